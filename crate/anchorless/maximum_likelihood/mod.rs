//! The likeliest motion, from every distance and, where there are accelerometers, every acceleration.
//!
//! Unknown are the coefficients of powers of scaled time of all nodes, stacked: D N (L + 1) numbers. Distances do not show
//! translations of a coefficient, nor a common rotation; information is added there, and what is found is centred.

mod acceleration_cost;
mod descent;
mod objective;
mod pair_cost;
mod retraction;
mod starts;

use nalgebra::DMatrix;

use crate::error::{Error, Result};
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::estimate::KinematicsEstimate;
use crate::model::kinematics::stacked::{from_stacked_powers, stacked_powers};
use crate::with_dimension;
use acceleration_cost::AccelerationCost;
use descent::{Minimum, minimum};
use objective::Objective;
use pair_cost::PairCosts;
use starts::from_synchronized;

/// What is being computed, for errors.
const WHAT: &str = "maximum likelihood";

/// How distances enter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Each pair as the 2L + 1 numbers that its squared distances say about a polynomial: the cost of an iteration does not
    /// depend on the number of stamps. Equal to the next but for the bend of the square, of the order of `(sigma/d)^2`.
    Compressed,
    /// Every single distance, `sum (d - ||x_a(t) - x_b(t)||)^2/sigma^2`.
    Every,
}

/// Maximum likelihood from distances alone, from the start of [`snapshot_sync`](super::synchronization::snapshot_sync), and
/// from simpler ones where the minimum next to it is too high to be the right one.
///
/// Gauss-Newton, then exact Newton until steps stop shrinking. The cost of the estimate is `sum (residual/sigma)^2`, less
/// what no motion of this degree could explain where pairs are compressed.
///
/// # Errors
/// As [`snapshot_sync`](super::synchronization::snapshot_sync); [`Error::Degenerate`] where distances do not determine the motion; [`Error::NoConvergence`].
///
/// ```
/// use rangelab::anchorless::maximum_likelihood::{Detail, maximum_likelihood};
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::simulate::kinematics::simulate_kinematics;
/// let trial = simulate_kinematics(&kinematics_preset("kinematics-paper")?, 0)?;
/// let found = maximum_likelihood(&trial.record, 2, Detail::Compressed)?;
/// let found = found.kinematics.expect("it finds the motion").aligned_to(&trial.truth)?;
/// assert!((found.coefficient(1) - trial.truth.coefficient(1)).amax() < 0.1); // m/s
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn maximum_likelihood(
    record: &DistanceRecord,
    degree: usize,
    detail: Detail,
) -> Result<KinematicsEstimate> {
    let near = from_synchronized(record, &PairCosts::new(record, degree, Detail::Compressed))?;
    in_detail(record, near, None, detail).map(|found| estimate_of(found, None))
}

/// Maximum likelihood from distances and accelerations, from the start of [`joint_start`]; the motion is given in the frame
/// of the accelerometers, mirror included, so that their `Q` is the identity.
///
/// # Errors
/// As [`maximum_likelihood`] and [`joint_start`].
///
/// ```
/// use rangelab::anchorless::maximum_likelihood::{Detail, maximum_likelihood_with_accelerometers};
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::simulate::kinematics::simulate_kinematics;
/// let trial = simulate_kinematics(&kinematics_preset("kinematics-paper")?, 0)?;
/// let found = maximum_likelihood_with_accelerometers(&trial.record, 2, Detail::Compressed)?;
/// let found = found.kinematics.expect("it finds the motion").aligned_to(&trial.truth)?;
/// assert!((found.coefficient(1) - trial.truth.coefficient(1)).amax() < 0.02); // m/s
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn maximum_likelihood_with_accelerometers(
    record: &DistanceRecord,
    degree: usize,
    detail: Detail,
) -> Result<KinematicsEstimate> {
    let readings = AccelerationCost::new(record, degree)?;
    let pairs = PairCosts::new(record, degree, Detail::Compressed);
    let (start, before) = start_in_frame(record, &pairs, &readings)?;
    let near = descended(record, &pairs, Some(&readings), &start)?;
    let found = in_detail(record, near, Some(&readings), detail)?;
    let rotation = DMatrix::identity(record.dimension(), record.dimension());
    let iterations = before + found.iterations;
    Ok(estimate_of(Found { iterations, ..found }, Some(rotation)))
}

/// Maximum likelihood from distances, then the element of O(D) that fits its accelerations to the readings, and the number
/// of iterations.
///
/// With accelerations the cost has a second, mirrored minimum; distances alone do not know it, for them the mirrored motion
/// is the same one.
///
/// # Errors
/// As [`maximum_likelihood`]; [`Error::TooFew`] where the record has no accelerations, [`Error::Number`] for motions of degree
/// below 2, which have none.
pub fn joint_start(record: &DistanceRecord, degree: usize) -> Result<(RelativeKinematics, usize)> {
    let readings = AccelerationCost::new(record, degree)?;
    start_in_frame(record, &PairCosts::new(record, degree, Detail::Compressed), &readings)
}

/// [`joint_start`] from pairs that are compressed already.
fn start_in_frame(
    record: &DistanceRecord,
    pairs: &PairCosts,
    readings: &AccelerationCost,
) -> Result<(RelativeKinematics, usize)> {
    let Found { motion, iterations, .. } = from_synchronized(record, pairs)?;
    let stacked = stacked_powers(&record.time_scale().scale(&motion));
    Ok((motion.rotated(&readings.frame(record.dimension(), &stacked)?), iterations))
}

/// The minimum next to a start: from distances, and from the accelerations of the record where it has any, which the start
/// then has to have in their own frame.
///
/// # Errors
/// [`Error::Size`] where the start is not of the nodes and dimension of the record, [`Error::Number`] for accelerations and
/// a start of degree below 2; [`Error::Degenerate`] where the motion is not determined; [`Error::NoConvergence`].
pub fn refined(
    record: &DistanceRecord,
    start: &RelativeKinematics,
    detail: Detail,
) -> Result<KinematicsEstimate> {
    let (found, expected) = (start.coefficient(0).len(), record.dimension() * record.nodes());
    if start.dimension() != record.dimension() || start.nodes() != record.nodes() {
        return Err(Error::Size { what: "coordinates in the start", found, expected });
    }
    let pairs = PairCosts::new(record, start.degree(), detail);
    if record.accelerometers().is_none() {
        return descended(record, &pairs, None, start).map(|found| estimate_of(found, None));
    }
    let accelerations = AccelerationCost::new(record, start.degree())?;
    let rotation = DMatrix::identity(record.dimension(), record.dimension());
    descended(record, &pairs, Some(&accelerations), start).map(|found| estimate_of(found, Some(rotation)))
}

/// What a descent found.
struct Found {
    motion: RelativeKinematics,
    cost: f64,
    iterations: usize,
}

fn estimate_of(found: Found, rotation: Option<DMatrix<f64>>) -> KinematicsEstimate {
    let Found { motion, cost, iterations } = found;
    KinematicsEstimate {
        kinematics: Some(motion),
        rotation,
        cost,
        iterations,
        ..KinematicsEstimate::default()
    }
}

/// Compressed pairs lead to where single distances are a step or two from their minimum.
fn in_detail(
    record: &DistanceRecord,
    near: Found,
    accelerations: Option<&AccelerationCost>,
    detail: Detail,
) -> Result<Found> {
    if detail == Detail::Compressed {
        return Ok(near);
    }
    let every = PairCosts::new(record, near.motion.degree(), detail);
    let found = descended(record, &every, accelerations, &near.motion)?;
    Ok(Found { iterations: near.iterations + found.iterations, ..found })
}

fn descended(
    record: &DistanceRecord,
    pairs: &PairCosts,
    accelerations: Option<&AccelerationCost>,
    start: &RelativeKinematics,
) -> Result<Found> {
    let (nodes, dimension, scale) = (record.nodes(), record.dimension(), record.time_scale());
    let from = stacked_powers(&scale.scale(&start.centred()));
    let Minimum { unknowns, cost, iterations } = with_dimension!(dimension, D => {
        minimum(&Objective::<D> { nodes, pairs, accelerations }, from)
    })?;
    let motion = scale.unscale(&from_stacked_powers(dimension, nodes, unknowns.as_slice()))?.centred();
    Ok(Found { motion, cost: 2.0 * cost, iterations })
}
