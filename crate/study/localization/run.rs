//! Single trials: one as a document, many as a cloud of numbers.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::bounds::{SnapshotBound, figures};
use super::tally::BoundFigures;
use super::trial::SnapshotError;
use crate::error::Result;
use crate::localize::{Estimate, Snapshot, localize};
use crate::math::float::sqrt;
use crate::math::pose::Pose;
use crate::model::document::entries::{PoseEntries, coordinates};
use crate::model::epoch::Recording;
use crate::model::localize_settings::LocalizerName;
use crate::model::run::PoseErrors;
use crate::model::scenario::Scenario;
use crate::simulate::simulate;
use crate::with_dimension;

/// What the snapshot estimators made of the first epoch of one trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotRun {
    /// Name of the scenario.
    pub name: String,
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// The anchors that were used, m.
    pub anchors: Vec<Vec<f64>>,
    /// The true pose.
    pub truth: PoseEntries,
    /// One entry an estimator.
    pub estimators: Vec<SnapshotEstimate>,
    /// One entry a bound that exists.
    pub bounds: Vec<SnapshotBoundFigures>,
}

/// One estimator's answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotEstimate {
    /// Its name in files.
    pub name: LocalizerName,
    /// Its name for people.
    pub label: String,
    /// `[Q | t]`; null for an estimator that sees no body, and after a failure.
    pub pose: Option<PoseEntries>,
    /// Where it puts the sensors, m; empty after a failure.
    pub sensors: Vec<Vec<f64>>,
    /// Its errors, where it has a pose.
    pub errors: Option<PoseErrors>,
    /// `||S_hat - S||_F` against the nominal places, m; 0 after a failure.
    pub sensors_error: f64,
    /// Iterations until its stopping rule held.
    pub iterations: usize,
    /// It mirrors the body.
    pub reflected: bool,
    /// What is known of its optimum: `formula`, `certified`, `searched` or `local`.
    pub optimum: String,
    /// Why there is no estimate, in a sentence.
    pub failure: Option<String>,
}

/// One bound: the least root mean square errors; null for what it does not speak of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotBoundFigures {
    /// Its name in files.
    pub name: String,
    /// Its name for people.
    pub label: String,
    /// Of `||Q_hat - Q||_F`.
    pub orientation: Option<f64>,
    /// Of the rotation angle, rad.
    pub angle: Option<f64>,
    /// Of the position, m.
    pub position: Option<f64>,
    /// Of all sensors together, m.
    pub sensors: f64,
}

/// Runs the enabled localizers on the first epoch of a trial.
///
/// # Errors
/// When the scenario is not valid or a range overflows.
pub fn localize_trial(scenario: &Scenario, trial: u64) -> Result<SnapshotRun> {
    with_dimension!(scenario.dimension, D => run(scenario, &first_epoch::<D>(scenario, trial)?))
}

/// Numbers for each estimator in each trial of [`localization_cloud`].
pub const fn cloud_stride(dimension: usize) -> usize {
    3 + dimension * (dimension + 1)
}

/// The estimates of trials `first..first + trials` as seen from the truth of each, for trials move the body before the first
/// epoch. Trial by trial, estimator by estimator (as enabled): 1 where there is a pose and else 0, 1 where it mirrors the
/// body, iterations, `Q_hat Q^T` row by row (the identity where there is no error), `t_hat - t` (m); zeros where there is no
/// pose.
///
/// # Errors
/// When the scenario is not valid or a range overflows.
pub fn localization_cloud(scenario: &Scenario, first: u64, trials: u64) -> Result<Vec<f64>> {
    with_dimension!(scenario.dimension, D => {
        let mut cloud = Vec::new();
        for trial in first..first + trials {
            let recording = first_epoch::<D>(scenario, trial)?;
            push_errors(scenario, &recording, &mut cloud)?;
        }
        Ok(cloud)
    })
}

fn first_epoch<const D: usize>(scenario: &Scenario, trial: u64) -> Result<Recording<D>> {
    simulate(&Scenario { steps: 1, ..scenario.clone() }, trial)
}

fn push_errors<const D: usize>(
    scenario: &Scenario,
    recording: &Recording<D>,
    cloud: &mut Vec<f64>,
) -> Result<()> {
    let epoch = &recording.epochs[0];
    let truth = recording.truth[0].unwrap_or_else(Pose::identity);
    let snapshot = Snapshot::new(&recording.model, &epoch.ranges, epoch.weight_ranges())?;
    for &name in &scenario.localize.enabled {
        let estimate = localize(name, &snapshot, &scenario.localize, scenario.mounting_sigma).ok();
        let found = estimate.and_then(|estimate| Some((estimate, estimate.theta?)));
        let Some((estimate, theta)) = found else {
            cloud.extend(core::iter::repeat_n(0.0, cloud_stride(D)));
            continue;
        };
        cloud.extend([1.0, f64::from(u8::from(estimate.reflected)), estimate.iterations as f64]);
        // Columns of the transpose are rows.
        let turned = truth.rotation.matrix() * theta.orientation.transpose();
        cloud.extend(turned.iter().chain((theta.position - truth.position).iter()));
    }
    Ok(())
}

fn run<const D: usize>(scenario: &Scenario, recording: &Recording<D>) -> Result<SnapshotRun> {
    let (model, epoch) = (&recording.model, &recording.epochs[0]);
    // A simulated recording knows its truth.
    let truth = recording.truth[0].unwrap_or_else(Pose::identity);
    let snapshot = Snapshot::new(model, &epoch.ranges, epoch.weight_ranges())?;
    let one = |&name: &LocalizerName| {
        let estimate = localize(name, &snapshot, &scenario.localize, scenario.mounting_sigma);
        let error = estimate.as_ref().ok().map(|e| SnapshotError::of(e, &snapshot, &truth));
        record(name, &snapshot, estimate, error.as_ref())
    };
    let found = figures(&model.per_pair(), &truth, &epoch.ranges, scenario.mounting_sigma)?;
    let bounds = SnapshotBound::ALL.into_iter().zip(found);
    Ok(SnapshotRun {
        name: scenario.name.clone(),
        dimension: D,
        anchors: coordinates(model.anchors().positions()),
        truth: truth.into(),
        estimators: scenario.localize.enabled.iter().map(one).collect(),
        bounds: bounds.filter_map(|(kind, figures)| figures.map(|figures| bound(kind, &figures))).collect(),
    })
}

fn record<const D: usize>(
    name: LocalizerName,
    snapshot: &Snapshot<D>,
    estimate: Result<Estimate<D>>,
    error: Option<&SnapshotError<D>>,
) -> SnapshotEstimate {
    let mut result = SnapshotEstimate {
        name,
        label: name.label().into(),
        pose: None,
        sensors: Vec::new(),
        errors: error.and_then(|error| error.pose.as_ref()).map(|pose| PoseErrors {
            orientation_frobenius: pose.orientation.norm(),
            angle: pose.angle,
            position: pose.position.norm(),
        }),
        sensors_error: error.map_or(0.0, |error| sqrt(error.sensors)),
        iterations: 0,
        reflected: false,
        optimum: String::new(),
        failure: None,
    };
    match estimate {
        Ok(estimate) => {
            let topology = snapshot.model.topology();
            let own = || (0..topology.len()).filter_map(|n| snapshot.sensor_position(n)).collect();
            result.sensors = coordinates(&estimate.sensor_positions(topology).unwrap_or_else(own));
            result.pose = estimate.theta.map(Into::into);
            result.iterations = estimate.iterations;
            result.reflected = estimate.reflected;
            result.optimum = estimate.optimum.name().to_string();
        }
        Err(error) => result.failure = Some(error.to_string()),
    }
    result
}

fn bound(kind: SnapshotBound, figures: &BoundFigures) -> SnapshotBoundFigures {
    SnapshotBoundFigures {
        name: kind.name().into(),
        label: kind.label().into(),
        orientation: figures.orientation.map(sqrt),
        angle: figures.angle.map(sqrt),
        position: figures.position.map(sqrt),
        sensors: sqrt(figures.sensors),
    }
}
