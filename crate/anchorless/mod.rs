//! Floor 2: mobile nodes without anchors. Relative positions, velocities and accelerations from the distances between them,
//! with or without accelerometers (\[A\]).
//!
//! [`estimate`] is the one door to all estimators by name.

pub mod distance_matrix;
pub mod gram_fit;
pub mod maximum_likelihood;
pub mod multidimensional_scaling;
pub mod pair_fit;
pub mod polynomial_fit;
pub mod range_polynomial;
pub mod relative_kinematics;
pub mod synchronization;

use crate::error::{Error, Result};
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::estimate::KinematicsEstimate;
use crate::model::kinematics::settings::{KinematicsName, KinematicsSettings};
use maximum_likelihood::{Detail, maximum_likelihood, maximum_likelihood_with_accelerometers};
use relative_kinematics::Solver;
use relative_kinematics::{algorithm_1, algorithm_2};

/// Estimates by name.
///
/// # Errors
/// [`Error::TooFew`] where nodes, stamps, distances or accelerations are missing, with what is; [`Error::Degenerate`] where
/// the motion is one that the estimator cannot tell.
///
/// ```
/// use rangelab::anchorless::estimate;
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::model::kinematics::settings::KinematicsName;
/// use rangelab::simulate::kinematics::simulate_kinematics;
/// let scenario = kinematics_preset("kinematics-paper")?;
/// let trial = simulate_kinematics(&scenario, 0)?;
/// let found = estimate(KinematicsName::Algorithm2So, &scenario.estimators, &trial.record)?;
/// let found = found.kinematics.expect("it finds the motion").aligned_to(&trial.truth)?;
/// assert!((found.coefficient(1) - trial.truth.coefficient(1)).amax() < 0.3); // m/s
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn estimate(
    name: KinematicsName,
    settings: &KinematicsSettings,
    record: &DistanceRecord,
) -> Result<KinematicsEstimate> {
    let degree = settings.degree;
    match name {
        KinematicsName::Algorithm1Literal => algorithm_1(record, degree, Solver::Literal),
        KinematicsName::Algorithm1Rank1 => algorithm_1(record, degree, Solver::Rank1),
        KinematicsName::Algorithm1So => algorithm_1(record, degree, Solver::So),
        KinematicsName::Algorithm1Lifted => algorithm_1(record, degree, Solver::Lifted),
        KinematicsName::Algorithm2Literal => algorithm_2(record, degree, Solver::Literal),
        KinematicsName::Algorithm2Rank1 => algorithm_2(record, degree, Solver::Rank1),
        KinematicsName::Algorithm2So => algorithm_2(record, degree, Solver::So),
        KinematicsName::Algorithm2Lifted => algorithm_2(record, degree, Solver::Lifted),
        KinematicsName::MultidimensionalScaling => multidimensional_scaling::snapshots(record),
        KinematicsName::RangePolynomial => range_polynomial::range_polynomial(record, settings.range_degree),
        KinematicsName::SnapshotSync => synchronization::snapshot_sync(record, degree),
        KinematicsName::MaximumLikelihood => maximum_likelihood(record, degree, Detail::Compressed),
        KinematicsName::MaximumLikelihoodFull => maximum_likelihood(record, degree, Detail::Every),
        KinematicsName::MaximumLikelihoodAccelerometers => {
            maximum_likelihood_with_accelerometers(record, degree, Detail::Compressed)
        }
        KinematicsName::MaximumLikelihoodAccelerometersFull => {
            maximum_likelihood_with_accelerometers(record, degree, Detail::Every)
        }
    }
}

/// Refuses too few nodes.
pub(crate) fn at_least_nodes(
    what: &'static str,
    found: usize,
    needed: usize,
    reason: &'static str,
) -> Result<()> {
    if found < needed {
        return Err(Error::TooFew { what, counted: "nodes", found, needed, reason });
    }
    Ok(())
}

/// Fourth powers of distances (m) must not overflow.
const MAX_DISTANCE: f64 = 1e30;

/// Refuses distances whose powers are no numbers.
pub(crate) fn small_enough(record: &DistanceRecord) -> Result<()> {
    let mut distances = (0..record.stamps().len()).flat_map(|k| record.distances(k)).copied().flatten();
    match distances.find(|distance| distance.abs() > MAX_DISTANCE) {
        Some(value) => Err(Error::Number { what: "a distance", value, limit: "at most 1e30 m" }),
        None => Ok(()),
    }
}
