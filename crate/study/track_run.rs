//! One recording through every estimator and every bound, as a Run document.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::error::PoseError;
use crate::bounds::{Bound, BoundKind, StepBounds, bounds_along, fisher_information, unitary_crb};
use crate::error::{Error, Result};
use crate::math::pose::Pose;
use crate::math::rotation::{Manifold, Rotation};
use crate::model::document::VERSION;
use crate::model::document::entries::{angle_rows, coordinates, rows};
use crate::model::epoch::Recording;
use crate::model::estimator_settings::{EstimatorName, EstimatorSettings};
use crate::model::ranging::RangeForm;
use crate::model::recording::RecordingDocument;
use crate::model::run::{
    BoundRecord, BoundRun, ConsistencyRecord, CovarianceTrace, EstimatorRun, Failure, Geometry, PoseErrors,
    Run, StepRecord,
};
use crate::model::scenario::Scenario;
use crate::simulate::simulate;
use crate::track::estimator;
use crate::track::filter::{Consistency, Step};
use crate::with_dimension;

/// Simulates a scenario and runs its estimators.
///
/// # Errors
/// When the scenario is not valid. An estimator or a bound that fails says so in its own part of the run.
pub fn run_scenario(scenario: &Scenario, trial: u64) -> Result<Run> {
    with_dimension!(scenario.dimension, D => {
        run_recording(&scenario.name, &simulate::<D>(scenario, trial)?, &scenario.estimators)
    })
}

/// Runs estimators over a recording.
///
/// # Errors
/// When the recording is not valid.
pub fn run_document(document: &RecordingDocument, settings: &EstimatorSettings) -> Result<Run> {
    with_dimension!(document.dimension, D => run_recording(&document.name, &document.recording::<D>()?, settings))
}

/// Runs estimators and bounds over a typed recording.
///
/// # Errors
/// When the noise of the recording is not positive.
pub fn run_recording<const D: usize>(
    name: &str,
    recording: &Recording<D>,
    settings: &EstimatorSettings,
) -> Result<Run> {
    let times = times(recording);
    Ok(Run {
        version: VERSION,
        name: name.to_string(),
        dimension: D,
        anchors: coordinates(recording.model.anchors().positions()),
        sensors: coordinates(recording.model.topology().sensors()),
        geometry: Geometry::of(&recording.model, unseen(recording)),
        truth: recording.truth.iter().map(|pose| pose.map(Into::into)).collect(),
        settings: settings.clone(),
        estimators: settings
            .enabled
            .iter()
            .map(|&name| run_estimator(name, settings, recording, &times))
            .collect(),
        bounds: bound_runs(recording, &bounds_along(recording)?),
        missing: recording.epochs.iter().map(|epoch| epoch.ranges.missing_pairs().collect()).collect(),
        times,
    })
}

fn times<const D: usize>(recording: &Recording<D>) -> Vec<f64> {
    let mut now = 0.0;
    let elapsed = recording.epochs.iter().map(|epoch| {
        now += epoch.motion.interval;
        now
    });
    elapsed.collect()
}

/// What complete ranges do not show at the first pose: the true one, or else the one that estimators start from.
fn unseen<const D: usize>(recording: &Recording<D>) -> Option<String> {
    let model = &recording.model;
    let start = &recording.initial.theta;
    let believed =
        || Pose { rotation: Rotation::project(&start.orientation, Manifold::So), position: start.position };
    let pose = recording.truth.iter().flatten().next().copied().unwrap_or_else(believed);
    let information = fisher_information(model, &pose, RangeForm::Projected, &mut model.range_buffer());
    match unitary_crb(&information.ok()?) {
        Err(Error::Unobservable { reason, .. }) => Some(reason),
        _ => None,
    }
}

fn run_estimator<const D: usize>(
    name: EstimatorName,
    settings: &EstimatorSettings,
    recording: &Recording<D>,
    times: &[f64],
) -> EstimatorRun {
    let mut filter = estimator(name, settings, recording);
    let mut run = EstimatorRun {
        name,
        label: name.label().to_string(),
        steps: Vec::with_capacity(times.len()),
        failure: None,
    };
    for (k, epoch) in recording.epochs.iter().enumerate() {
        let record = filter.step(epoch).and_then(|step| record(&step, times[k], recording.truth[k].as_ref()));
        match record {
            Ok(record) => run.steps.push(record),
            Err(error) => {
                run.failure = Some(failure(k, &error));
                break;
            }
        }
    }
    run
}

fn failure(step: usize, error: &Error) -> Failure {
    Failure { step, message: error.to_string() }
}

fn record<const D: usize>(step: &Step<D>, time: f64, truth: Option<&Pose<D>>) -> Result<StepRecord> {
    let position_block = step.uncertainty.position_block();
    let error = truth.map(|pose| PoseError::of(step, pose));
    Ok(StepRecord {
        time,
        prior: step.prior.into(),
        innovation: step.innovation.into(),
        posterior: step.posterior.into(),
        covariance_trace: CovarianceTrace {
            orientation: step.uncertainty.orientation_trace(),
            position: position_block.trace(),
        },
        position_covariance: rows(&position_block),
        rotation_covariance: step.rotation_covariance().ok().map(|matrix| angle_rows::<D>(&matrix)),
        defect: step.defect,
        event: step.event,
        nis: consistency(step.nis),
        errors: error.map(|error| PoseErrors {
            orientation_frobenius: error.orientation.norm(),
            angle: error.angle,
            position: error.position.norm(),
        }),
        nees: truth.map(|pose| step.nees(pose)).transpose()?.map(consistency),
    })
}

fn consistency(statistic: Consistency) -> ConsistencyRecord {
    ConsistencyRecord { value: statistic.value, degrees_of_freedom: statistic.degrees_of_freedom }
}

/// The bounds that exist for at least one step.
fn bound_runs<const D: usize>(recording: &Recording<D>, steps: &[StepBounds<D>]) -> Vec<BoundRun> {
    let run = |kind: BoundKind| {
        let found = steps.iter().map(|bounds| bounds.get(kind));
        let failure = found.clone().enumerate().find_map(|(k, bound)| match bound {
            Some(Err(error)) => Some(failure(k, error)),
            _ => None,
        });
        BoundRun {
            name: kind.name().to_string(),
            label: kind.label().to_string(),
            steps: found
                .zip(&recording.truth)
                .map(|(bound, truth)| Some(bound_record(bound?.as_ref().ok()?, truth.as_ref())))
                .collect(),
            failure,
        }
    };
    let runs = BoundKind::ALL.into_iter().map(run);
    runs.filter(|run| run.failure.is_some() || run.steps.iter().any(Option::is_some)).collect()
}

fn bound_record<const D: usize>(bound: &Bound<D>, truth: Option<&Pose<D>>) -> BoundRecord {
    BoundRecord {
        orientation_trace: bound.orientation_trace,
        angle_variance: bound.angle_variance,
        position_trace: bound.position_trace,
        position_covariance: rows(&bound.position_block()),
        rotation_covariance: truth
            .map(|pose| angle_rows::<D>(&bound.rotation_block_in_world(&pose.rotation))),
    }
}
