//! Where anchors may stand.

use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use nalgebra::SVector;

use crate::error::{Error, Problem, Result};
use crate::model::document::entries::vector;
use crate::model::placement_settings::{PlacementSettings, Region};
use crate::simulate::random::Stream;

/// A box along the axes, m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Box<const D: usize> {
    low: SVector<f64, D>,
    high: SVector<f64, D>,
}

/// Where anchors may stand: within limits, out of keep-out zones (on their faces is out), some not moved at all.
#[derive(Clone, Debug, PartialEq)]
pub struct Zone<const D: usize> {
    limits: Box<D>,
    keep_out: Vec<Box<D>>,
    fixed: Vec<bool>,
}

/// Draws before a place in the limits is given up: keep-out zones fill nearly all of them.
const MAX_DRAWS: usize = 1000;

impl<const D: usize> Zone<D> {
    /// The zone of a scenario's placement for its anchors; without limits it is the box of the anchors.
    ///
    /// # Errors
    /// [`Error::Invalid`] where keep-out zones leave an anchor no place.
    pub fn new(settings: &PlacementSettings, anchors: &[SVector<f64, D>]) -> Result<Self> {
        let fixed = (0..anchors.len()).map(|m| settings.fixed.contains(&m)).collect();
        let limits = settings.limits.as_ref().map_or_else(|| around(anchors), Box::of);
        let zone = Self { limits, keep_out: settings.keep_out.iter().map(Box::of).collect(), fixed };
        for (m, anchor) in anchors.iter().enumerate() {
            if !zone.fixed[m] && zone.project(anchor).is_none() {
                return Err(no_place(m, anchor.as_slice(), zone.keep_out.len()));
            }
        }
        Ok(zone)
    }

    /// The box of the anchors, all of them free.
    pub fn around(anchors: &[SVector<f64, D>]) -> Self {
        Self { limits: around(anchors), keep_out: Vec::new(), fixed: vec![false; anchors.len()] }
    }

    /// The zone of one more anchor: everywhere, where the placement has no limits.
    pub(super) fn of_next(settings: &PlacementSettings) -> Self {
        let endless =
            || Box { low: SVector::repeat(f64::NEG_INFINITY), high: SVector::repeat(f64::INFINITY) };
        let limits = settings.limits.as_ref().map_or_else(endless, Box::of);
        Self { limits, keep_out: settings.keep_out.iter().map(Box::of).collect(), fixed: Vec::new() }
    }

    /// Why no anchor may stand there; none where one may.
    pub(super) fn refusal(&self, point: &SVector<f64, D>) -> Option<String> {
        let zone = self.keep_out.iter().position(|zone| zone.holds(point));
        match zone {
            Some(index) => Some(format!("no anchor may stand inside keep-out zone {}", index + 1)),
            None if self.allows(point) => None,
            None => Some("no anchor may stand outside the limits of the placement".into()),
        }
    }

    /// Whether an anchor may not be moved.
    pub fn is_fixed(&self, anchor: usize) -> bool {
        self.fixed[anchor]
    }

    /// Whether an anchor may stand there.
    pub fn allows(&self, point: &SVector<f64, D>) -> bool {
        let Box { low, high } = &self.limits;
        (0..D).all(|i| low[i] <= point[i] && point[i] <= high[i])
            && !self.keep_out.iter().any(|zone| zone.holds(point))
    }

    /// Longest edge of the limits, m.
    pub fn extent(&self) -> f64 {
        (self.limits.high - self.limits.low).iter().copied().fold(0.0, f64::max)
    }

    /// A place near the point where an anchor may stand: clamped to the limits, then moved out of each keep-out zone by
    /// its nearest face. None where that does not come to an end.
    pub fn project(&self, point: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        let Box { low, high } = &self.limits;
        let mut place = SVector::from_fn(|i, _| point[i].clamp(low[i], high[i]));
        for _ in 0..=self.keep_out.len() {
            let Some(zone) = self.keep_out.iter().find(|zone| zone.holds(&place)) else { return Some(place) };
            place = zone.nearest_exit(&place, &self.limits)?;
        }
        self.allows(&place).then_some(place)
    }

    /// The anchors, each moved to where it may stand; one for which no place is found stays at `before`.
    pub(super) fn project_all(
        &self,
        before: &[SVector<f64, D>],
        wanted: &[SVector<f64, D>],
    ) -> Vec<SVector<f64, D>> {
        let place = |m: usize| if self.fixed[m] { None } else { self.project(&wanted[m]) };
        (0..wanted.len()).map(|m| place(m).unwrap_or(before[m])).collect()
    }

    /// A uniformly drawn place where an anchor may stand; `otherwise` where none is met.
    pub(super) fn draw(&self, stream: &mut Stream, otherwise: SVector<f64, D>) -> SVector<f64, D> {
        let Box { low, high } = &self.limits;
        let mut draw = || SVector::from_fn(|i, _| low[i] + stream.uniform() * (high[i] - low[i]));
        (0..MAX_DRAWS).map(|_| draw()).find(|point| self.allows(point)).unwrap_or(otherwise)
    }
}

impl<const D: usize> Box<D> {
    fn of(region: &Region) -> Self {
        Self { low: vector(&region.low), high: vector(&region.high) }
    }

    fn holds(&self, point: &SVector<f64, D>) -> bool {
        (0..D).all(|i| self.low[i] < point[i] && point[i] < self.high[i])
    }

    /// The nearest point on a face that lies within the limits.
    fn nearest_exit(&self, point: &SVector<f64, D>, limits: &Self) -> Option<SVector<f64, D>> {
        let faces = (0..D).flat_map(|i| [(i, self.low[i]), (i, self.high[i])]);
        let reachable = faces.filter(|&(i, face)| limits.low[i] <= face && face <= limits.high[i]);
        let distance = |&(i, face): &(usize, f64)| (face - point[i]).abs();
        let (i, face) = reachable.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        let mut exit = *point;
        exit[i] = face;
        Some(exit)
    }
}

fn around<const D: usize>(anchors: &[SVector<f64, D>]) -> Box<D> {
    let mut limits = Box { low: anchors[0], high: anchors[0] };
    for anchor in anchors {
        for i in 0..D {
            limits.low[i] = limits.low[i].min(anchor[i]);
            limits.high[i] = limits.high[i].max(anchor[i]);
        }
    }
    limits
}

fn no_place(anchor: usize, position: &[f64], zones: usize) -> Error {
    let problem = Problem {
        path: "placement.keep_out".into(),
        value: format!("{zones} zones around anchors[{anchor}] at {position:?} m"),
        limit: "zones that leave each anchor a place within the limits, or that anchor among the fixed"
            .into(),
    };
    Error::Invalid { document: "scenario", problems: vec![problem] }
}
