//! Least squares without a constraint: each sensor by itself, or any matrix `[Q | t]`.

use super::snapshot::Snapshot;
use super::{Estimate, Optimum};
use crate::error::Result;
use crate::model::lack::Parameters;
use crate::model::ranging::RangeForm;

/// Classical LS: the position of each sensor from its own ranges (\[L\] eq. 8). It knows no body: the estimate holds no pose,
/// and the positions are [`Snapshot::sensor_position`].
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause where the ranges of some sensor do not show it.
pub fn classical<const D: usize>(snapshot: &Snapshot<D>) -> Result<Estimate<D>> {
    if (0..snapshot.levers.len()).any(|n| snapshot.sensor_position(n).is_none()) {
        return Err(snapshot.unobservable("classical LS", RangeForm::Projected, Parameters::Sensors));
    }
    Ok(Estimate { theta: None, iterations: 0, reflected: false, optimum: Optimum::Formula })
}

/// LS of all entries of `[Q | t]` (\[L\] eq. 14). `Q` is no rotation.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause: it needs M >= D + 1 anchors and N >= D + 1 sensors that fill the space.
pub fn least_squares<const D: usize>(snapshot: &Snapshot<D>) -> Result<Estimate<D>> {
    let reduced = snapshot.reduced("LS", 0.0)?;
    if !reduced.unique {
        return Err(snapshot.unobservable("LS", RangeForm::Projected, Parameters::Unconstrained));
    }
    let centroid = reduced.centroid(&reduced.target);
    Ok(Estimate::new(snapshot.in_body_frame(reduced.target, centroid), 0, Optimum::Formula))
}
