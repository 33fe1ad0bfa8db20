//! One trial of a kinematics scenario through its estimators, as a document.

use alloc::string::ToString;
use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::errors::Yardstick;
use crate::anchorless::estimate;
use crate::error::Result;
use crate::math::float::sqrt;
use crate::model::document::VERSION;
use crate::model::kinematics::KinematicsScenario;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::estimate::KinematicsEstimate;
use crate::model::kinematics::gauge::procrustes;
use crate::model::kinematics::run::{KinematicsEstimatorRun, KinematicsRun, Points};
use crate::model::kinematics::settings::{KinematicsName, KinematicsSettings};
use crate::simulate::kinematics::draw;

/// Simulates a kinematics scenario and runs its estimators.
///
/// # Errors
/// When the scenario is not valid. An estimator that fails says so in its own part of the run.
pub fn run_kinematics(scenario: &KinematicsScenario, trial: u64) -> Result<KinematicsRun> {
    let setup = scenario.setup()?;
    let drawn = draw(scenario, &setup, trial)?;
    let yardstick = Yardstick::new(scenario, &setup);
    let settings = &scenario.estimators;
    let run = |&name: &KinematicsName| run_estimator(name, settings, &drawn.record, &yardstick);
    Ok(KinematicsRun {
        version: VERSION,
        name: scenario.name.clone(),
        stamps: setup.stamps.clone(),
        missing: drawn.record.missing(),
        truth: coefficients(&drawn.truth),
        sensor_from_world: points(&drawn.sensor_from_world.transpose()),
        instants: yardstick.instants.clone(),
        settings: settings.clone(),
        estimators: settings.enabled.iter().map(run).collect::<Result<_>>()?,
    })
}

fn run_estimator(
    name: KinematicsName,
    settings: &KinematicsSettings,
    record: &DistanceRecord,
    yardstick: &Yardstick,
) -> Result<KinematicsEstimatorRun> {
    let (found, failure) = match estimate(name, settings, record) {
        Ok(found) => (found, None),
        Err(error) => (KinematicsEstimate::default(), Some(error.to_string())),
    };
    let errors = yardstick.errors(&found)?;
    let roots = |values: &[f64]| values.iter().map(|&value| sqrt(value)).collect::<Vec<f64>>();
    let aligned = found.kinematics.as_ref().map(|found| found.aligned_to(yardstick.motion())).transpose()?;
    Ok(KinematicsEstimatorRun {
        name,
        label: name.label().to_string(),
        failure,
        coefficients: aligned.as_ref().map(coefficients).unwrap_or_default(),
        coefficient_errors: roots(&errors.coefficients),
        gram_errors: roots(&errors.gram),
        position_errors: roots(&errors.positions),
        aligned_position_errors: roots(&errors.aligned_positions),
        snapshots: snapshots(&found, record, yardstick)?,
        acceleration_margin: found.acceleration_margin.filter(|margin| margin.is_finite()),
        iterations: found.iterations,
    })
}

/// Each snapshot in the frame of the truth at its stamp.
fn snapshots(
    found: &KinematicsEstimate,
    record: &DistanceRecord,
    yardstick: &Yardstick,
) -> Result<Vec<Option<Points>>> {
    let aligned = |(snapshot, &time): (&Option<DMatrix<f64>>, &f64)| {
        let Some(snapshot) = snapshot else { return Ok(None) };
        let turn = procrustes(snapshot, &yardstick.motion().positions(time))?;
        Ok(Some(points(&(turn * snapshot))))
    };
    found.snapshots.iter().zip(record.stamps()).map(aligned).collect()
}

/// The columns of a matrix.
fn points(matrix: &DMatrix<f64>) -> Points {
    matrix.column_iter().map(|column| column.iter().copied().collect()).collect()
}

fn coefficients(motion: &RelativeKinematics) -> Vec<Points> {
    motion.coefficients().iter().map(points).collect()
}
