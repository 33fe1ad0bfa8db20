//! What the estimators of one trial are off, node by node: what is drawn.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use crate::error::Result;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::run::{KinematicsEstimatorRun, KinematicsRun, Points};

/// The true motion of a run, and what each estimator found less the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsDeviations {
    /// The true motion, centred.
    pub truth: RelativeKinematics,
    /// In the order of the run.
    pub estimators: Vec<EstimatorDeviations>,
}

/// What one estimator found less the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimatorDeviations {
    /// Of `Y_0, Y_1, ...` after the one alignment from `Y_0`, so that it is the error at every instant too; `None` where the
    /// estimator finds no motion.
    pub motion: Option<RelativeKinematics>,
    /// For estimators of one epoch at a time: D x N at each stamp, each aligned by itself; `None` where distances are missing.
    pub snapshots: Vec<Option<DMatrix<f64>>>,
}

impl KinematicsDeviations {
    /// Those of a run.
    ///
    /// # Errors
    /// Never for a run of [`run_kinematics`](super::run::run_kinematics); [`crate::Error::Size`] or [`crate::Error::Number`]
    /// for a document of other shapes.
    ///
    /// ```
    /// use rangelab::model::kinematics::presets::kinematics_preset;
    /// use rangelab::study::kinematics::deviations::KinematicsDeviations;
    /// use rangelab::study::kinematics::run::run_kinematics;
    /// let run = run_kinematics(&kinematics_preset("kinematics-sparse")?, 0)?;
    /// let deviations = KinematicsDeviations::of(&run)?;
    /// let of_likelihood = deviations.estimators[3].motion.as_ref().expect("it finds the motion");
    /// let found = run.estimators[3].coefficients[1][0][0];
    /// assert_eq!(of_likelihood.coefficient(1)[(0, 0)], found - deviations.truth.coefficient(1)[(0, 0)]);
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn of(run: &KinematicsRun) -> Result<Self> {
        let truth = motion(&run.truth)?;
        let of_estimator = |each: &KinematicsEstimatorRun| {
            Ok(EstimatorDeviations {
                motion: of_motion(&each.coefficients, &truth)?,
                snapshots: of_snapshots(&each.snapshots, &run.stamps, &truth),
            })
        };
        let estimators = run.estimators.iter().map(of_estimator).collect::<Result<_>>()?;
        Ok(Self { truth, estimators })
    }
}

/// Where the assumed degree is another than the true one, the coefficients that one lacks are zero.
fn of_motion(coefficients: &[Points], truth: &RelativeKinematics) -> Result<Option<RelativeKinematics>> {
    if coefficients.is_empty() {
        return Ok(None);
    }
    let found = motion(coefficients)?;
    let degree = found.degree().max(truth.degree());
    let (found, truth) = (found.with_degree(degree), truth.with_degree(degree));
    let pairs = found.coefficients().iter().zip(truth.coefficients());
    RelativeKinematics::new(pairs.map(|(found, truth)| found - truth).collect()).map(Some)
}

fn of_snapshots(
    snapshots: &[Option<Points>],
    stamps: &[f64],
    truth: &RelativeKinematics,
) -> Vec<Option<DMatrix<f64>>> {
    let off = |(snapshot, &time): (&Option<Points>, &f64)| {
        snapshot.as_ref().map(|found| matrix(found) - truth.positions(time))
    };
    snapshots.iter().zip(stamps).map(off).collect()
}

fn motion(coefficients: &[Points]) -> Result<RelativeKinematics> {
    RelativeKinematics::new(coefficients.iter().map(matrix).collect())
}

/// Points as columns.
fn matrix(points: &Points) -> DMatrix<f64> {
    let dimension = points.first().map_or(0, Vec::len);
    DMatrix::from_fn(dimension, points.len(), |i, node| points[node].get(i).copied().unwrap_or(f64::NAN))
}
