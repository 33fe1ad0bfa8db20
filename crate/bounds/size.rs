//! How the bound on the orientation depends on the size of the body.

use alloc::vec::Vec;

use super::constrained::unitary_crb;
use super::fisher::fisher_information_of;
use crate::error::{Error, Result};
use crate::math::float::sqrt;
use crate::math::pose::Pose;
use crate::model::availability::Availability;
use crate::model::ranging::{RangeForm, RangeModel, Weighting};
use crate::model::topology::Topology;

/// The bound on the orientation (rad) of a body whose sensors are as many times farther from its origin as each scale
/// says; `None` where there is none.
///
/// # Errors
/// [`Error::Number`] for a scale that is not positive and finite.
pub fn orientation_against_size<const D: usize>(
    model: &RangeModel<D>,
    availability: &Availability<D>,
    pose: &Pose<D>,
    form: RangeForm,
    scales: &[f64],
) -> Result<Vec<Option<f64>>> {
    let bound = |&scale: &f64| {
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(Error::Number {
                what: "the scale of the body",
                value: scale,
                limit: "above 0, finite",
            });
        }
        let sensors = model.topology().sensors().iter().map(|c| c * scale).collect();
        let topology = Topology::new(sensors)?;
        let scaled = RangeModel::new(model.anchors().clone(), topology, *model.noise(), Weighting::PerPair)?;
        let measured = scaled.measurable_ranges(pose, availability)?;
        let information = fisher_information_of(&scaled, pose, &measured, form, &mut scaled.range_buffer())?;
        Ok(unitary_crb(&information).ok().map(|bound| sqrt(bound.angle_trace())))
    };
    scales.iter().map(bound).collect()
}
