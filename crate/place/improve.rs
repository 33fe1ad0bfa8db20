//! A scenario with its anchors moved to better places.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use nalgebra::SVector;
use serde::Serialize;

use super::optimise::optimise;
use super::{Placement, Zone};
use crate::error::Result;
use crate::model::document::entries::coordinates;
use crate::model::scenario::Scenario;
use crate::simulate::random::{Part, Stream};
use crate::with_dimension;

/// What one search found.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Improvement {
    /// Which search: 0 starts from the anchors as they are, every other from places drawn anew within the limits.
    #[cfg_attr(feature = "typescript", ts(type = "number"))]
    pub restart: u64,
    /// The unit of the values, m or rad.
    pub unit: String,
    /// Value of the anchors of the scenario; null where no bound exists.
    pub before: Option<f64>,
    /// Value of the anchors found; null where no bound exists.
    pub after: Option<f64>,
    /// Why no bound exists for the anchors found; null where it does.
    pub cause: Option<String>,
    /// The anchors found, m.
    pub anchors: Vec<Vec<f64>>,
}

impl Improvement {
    /// The scenario with these anchors, which then stay where they are in every trial.
    pub fn applied_to(&self, scenario: &Scenario) -> Scenario {
        Scenario { anchors: self.anchors.clone(), redraw_anchors: None, ..scenario.clone() }
    }
}

/// An anchor arrangement in which something is not seen is often one that is symmetric, where the slope shows no way
/// out: anchors are nudged by up to this part of the extent of the limits.
const NUDGE: f64 = 0.01;

/// Moves the free anchors of a scenario to where its `placement` counts them better, by one search. The same scenario and
/// restart give the same bits everywhere, and restarts may be made in any order.
///
/// Restart 0 is never worse than the scenario's anchors, unless these break the limits: then they are moved inside first.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario, and where keep-out zones leave an anchor no place;
/// [`crate::Error::Number`] where sums overflow. That no bound exists is no error but a finding.
///
/// ```
/// use rangelab::model::presets::preset;
/// use rangelab::place::improve;
/// let found = improve(&preset("room")?, 0)?;
/// assert!(found.after < found.before);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn improve(scenario: &Scenario, restart: u64) -> Result<Improvement> {
    with_dimension!(scenario.dimension, D => search::<D>(scenario, restart))
}

fn search<const D: usize>(scenario: &Scenario, restart: u64) -> Result<Improvement> {
    let placement = Placement::<D>::of(scenario)?;
    let given = Placement::<D>::anchors_of(scenario);
    let zone = Zone::new(&scenario.placement, &given)?;
    let mut stream = Stream::new(scenario.seed, restart, Part::Anchors);
    let start = match restart {
        0 => zone.project_all(&given, &given),
        _ => redrawn(&zone, &given, &mut stream),
    };
    let seen = placement.value(&start).is_ok();
    let from = if seen { start } else { nudged(&zone, &start, &mut stream) };
    let found = optimise(&placement, &zone, &from)?;
    let after = placement.value(&found);
    Ok(Improvement {
        restart,
        unit: placement.figure.unit().to_string(),
        before: placement.value(&given).ok(),
        cause: after.as_ref().err().map(ToString::to_string),
        after: after.ok(),
        anchors: coordinates(&found),
    })
}

fn redrawn<const D: usize>(
    zone: &Zone<D>,
    given: &[SVector<f64, D>],
    stream: &mut Stream,
) -> Vec<SVector<f64, D>> {
    let inside = zone.project_all(given, given);
    let place = |(m, &anchor): (usize, &SVector<f64, D>)| {
        // Drawn also for one that is fixed: fixing it leaves the draws of the others as they were.
        let drawn = zone.draw(stream, anchor);
        if zone.is_fixed(m) { anchor } else { drawn }
    };
    inside.iter().enumerate().map(place).collect()
}

fn nudged<const D: usize>(
    zone: &Zone<D>,
    anchors: &[SVector<f64, D>],
    stream: &mut Stream,
) -> Vec<SVector<f64, D>> {
    let reach = NUDGE * zone.extent();
    let mut nudge = || SVector::from_fn(|_, _| (2.0 * stream.uniform() - 1.0) * reach);
    let wanted: Vec<_> = anchors.iter().map(|anchor| anchor + nudge()).collect();
    zone.project_all(anchors, &wanted)
}
