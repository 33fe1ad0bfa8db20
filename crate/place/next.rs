//! What a placement is worth with one more anchor, at each point of space.

use alloc::string::String;
use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};

use super::gradient::{motion_of_sensor, weighted_mean};
use super::{Placement, Zone};
use crate::bounds::covariance_of;
use crate::bounds::field::{FieldLayout, NONE};
use crate::error::Result;
use crate::math::pose::Pose;
use crate::math::tangent::{MAX_TANGENT, TangentMatrix};
use crate::model::noise::VarianceLaw;
use crate::model::ranging::{RangeForm, RangeModel};
use crate::model::scenario::Scenario;

/// The value of a placement as a function of the place of one more anchor, which reaches as far as one likes.
///
/// What the anchors that are there say of each pose is summed once. One more anchor at `a` adds, for each sensor that it
/// sees, one range of weight `w`, and that is a square:
///
/// `J + sum_n 4 w_n/(1 + w_n/W_n) h_n h_n^T`, `h_n = H_n^T (a - z_n)`,
///
/// with `H_n = d s_n/d(phi, t)`, `z_n` the weighted mean of the anchors that the sensor sees and `W_n` the sum of their
/// weights where `||s||^2` is projected out, the sensor itself and infinity where it is not.
///
/// ```
/// use nalgebra::Vector2;
/// use rangelab::model::presets::preset;
/// use rangelab::place::{NextAnchor, advise};
/// let planar = preset("planar")?;
/// let with_one_more = NextAnchor::<2>::of(&planar)?.value(&Vector2::new(1.0, 2.0));
/// assert!(with_one_more < advise(&planar)?.value.unwrap());
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct NextAnchor<const D: usize> {
    placement: Placement<D>,
    zone: Zone<D>,
    law: VarianceLaw,
    seen: Vec<Seen<D>>,
    /// The number that it would have; no anchor of that number has a longest range.
    number: usize,
}

/// What the anchors say of one pose, and the sensors there.
#[derive(Clone, Debug)]
struct Seen<const D: usize> {
    information: TangentMatrix<D>,
    sensors: Vec<Sensor<D>>,
}

#[derive(Clone, Debug)]
struct Sensor<const D: usize> {
    /// World frame, m.
    place: SVector<f64, D>,
    /// `H_n`.
    motion: SMatrix<f64, D, MAX_TANGENT>,
    /// `z_n`, m.
    centre: SVector<f64, D>,
    /// `W_n`, m^-4.
    weight: f64,
}

impl<const D: usize> NextAnchor<D> {
    /// One more anchor for a scenario, judged by its `placement`.
    ///
    /// # Errors
    /// As [`Scenario::setup`]; [`crate::Error::Number`] where sums overflow.
    pub fn of(scenario: &Scenario) -> Result<Self> {
        let placement = Placement::<D>::of(scenario)?;
        let model = placement.model(&Placement::<D>::anchors_of(scenario))?;
        let seen: Result<_> = placement.poses.iter().map(|pose| Seen::of(&placement, &model, pose)).collect();
        Ok(Self {
            zone: Zone::of_next(&scenario.placement),
            law: placement.noise.law(),
            seen: seen?,
            number: scenario.anchors.len(),
            placement,
        })
    }

    /// The value with one more anchor at a point of the world, m or rad: what [`Placement::value`] says of all anchors
    /// together. [`NONE`] where none may stand, and where not all is seen even with it.
    pub fn value(&self, point: &SVector<f64, D>) -> f64 {
        if !self.zone.allows(point) {
            return NONE;
        }
        let figures: Option<Vec<f64>> = self.seen.iter().map(|seen| self.figure(seen, point)).collect();
        figures.map_or(NONE, |figures| self.placement.total(&figures))
    }

    /// Why there is no value at a point; none where there is one.
    pub fn refusal(&self, point: &SVector<f64, D>) -> Option<String> {
        self.zone.refusal(point)
    }

    /// The values at the cells of some rows of a grid, row by row.
    pub fn rows(&self, layout: &FieldLayout, first: usize, count: usize) -> Vec<f64> {
        let rows = first..first.saturating_add(count).min(layout.height);
        let cells = rows.flat_map(|row| (0..layout.width).map(move |column| layout.centre(column, row)));
        cells.map(|centre| self.value(&SVector::from_column_slice(&centre[..D]))).collect()
    }

    /// The figure of one pose; none where there is no bound.
    fn figure(&self, seen: &Seen<D>, point: &SVector<f64, D>) -> Option<f64> {
        let mut information = seen.information;
        for sensor in &seen.sensors {
            if self.placement.availability.allows(self.number, point, &sensor.place) {
                let weight = 1.0 / self.law.variance((point - sensor.place).norm_squared());
                let lever = sensor.motion.transpose() * (point - sensor.centre);
                information.add_square(4.0 * weight / (1.0 + weight / sensor.weight), &lever);
            }
        }
        let figure = self.placement.figure.value(&covariance_of(&information)?);
        figure.is_finite().then_some(figure)
    }
}

impl<const D: usize> Seen<D> {
    fn of(placement: &Placement<D>, model: &RangeModel<D>, pose: &Pose<D>) -> Result<Self> {
        let ranges = model.measurable_ranges(pose, &placement.availability)?;
        let information = placement.information(model, pose, &ranges)?.on_tangent_space();
        let (law, anchors) = (placement.noise.law(), model.anchors().positions());
        let sensor = |(n, c): (usize, &SVector<f64, D>)| {
            let place = pose.act(c);
            let (weight, centre) = match placement.form {
                RangeForm::Raw => (f64::INFINITY, place),
                RangeForm::Projected => weighted_mean(law, anchors, ranges.of_sensor(n)),
            };
            // A first range says nothing where the mean is projected out: any centre does.
            let centre = if weight > 0.0 { centre } else { place };
            Sensor { place, motion: motion_of_sensor(pose, c), centre, weight }
        };
        let sensors = placement.topology.sensors().iter().enumerate().map(sensor).collect();
        Ok(Self { information, sensors })
    }
}
