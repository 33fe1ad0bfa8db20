//! One trial of an indoor scenario through its filters, as a document.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::tally::StepErrors;
use crate::error::Result;
use crate::inertial::filter::InertialStep;
use crate::inertial::inertial_filter;
use crate::math::float::sqrt;
use crate::math::pose::{Pose, Theta};
use crate::math::singular::singular;
use crate::model::document::VERSION;
use crate::model::document::entries::{PoseEntries, coordinates, rows};
use crate::model::indoor::IndoorScenario;
use crate::model::indoor::epoch::{IndoorRecording, NavigationState};
use crate::model::indoor::filter_settings::{FilterName, FilterSettings};
use crate::model::indoor::run::{IndoorFailure, IndoorFilterRun, IndoorRun, IndoorStepRecord};
use crate::simulate::indoor::simulate_indoor;

/// Simulates an indoor scenario and runs its filters.
///
/// # Errors
/// When the scenario is not valid. A filter that fails says so in its own part of the run.
pub fn run_indoor(scenario: &IndoorScenario, trial: u64) -> Result<IndoorRun> {
    Ok(run_indoor_recording(&scenario.name, &simulate_indoor(scenario, trial)?, &scenario.filters))
}

/// Runs filters over a recording.
pub fn run_indoor_recording(name: &str, recording: &IndoorRecording, settings: &FilterSettings) -> IndoorRun {
    let mut now = 0.0;
    let mut elapsed = |interval: f64| {
        now += interval;
        now
    };
    let pose = |state: &NavigationState| {
        PoseEntries::from(Pose { rotation: state.rotation, position: state.position })
    };
    IndoorRun {
        version: VERSION,
        name: name.to_string(),
        beacons: coordinates(&recording.model.beacons),
        transmitters: coordinates(&recording.model.transmitters),
        times: recording.epochs.iter().map(|epoch| elapsed(epoch.interval)).collect(),
        truth: recording.truth.iter().map(pose).collect(),
        true_velocities: recording.truth.iter().map(|state| state.velocity.into()).collect(),
        fixes: recording.epochs.iter().map(|epoch| !epoch.ranges.is_empty()).collect(),
        settings: settings.clone(),
        filters: settings.enabled.iter().map(|&name| run_filter(name, settings, recording)).collect(),
    }
}

fn run_filter(name: FilterName, settings: &FilterSettings, recording: &IndoorRecording) -> IndoorFilterRun {
    let mut steps = Vec::with_capacity(recording.epochs.len());
    let failure = all_steps(name, settings, recording, &mut steps).err();
    IndoorFilterRun {
        name,
        label: name.label().to_string(),
        failure: failure.map(|error| IndoorFailure { step: steps.len(), message: error.to_string() }),
        steps,
    }
}

fn all_steps(
    name: FilterName,
    settings: &FilterSettings,
    recording: &IndoorRecording,
    steps: &mut Vec<IndoorStepRecord>,
) -> Result<()> {
    let mut filter = inertial_filter(name, settings, &recording.model, &recording.start)?;
    for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
        steps.push(record(&filter.step(epoch)?, truth)?);
    }
    Ok(())
}

fn record(step: &InertialStep, truth: &NavigationState) -> Result<IndoorStepRecord> {
    let errors = StepErrors::of(step, truth)?;
    let block = |i: usize| step.covariance.fixed_view::<3, 3>(i, i).into_owned();
    let rotation = *step.rotation().matrix();
    Ok(IndoorStepRecord {
        pose: Theta { orientation: step.orientation, position: step.position }.into(),
        velocity: step.velocity.into(),
        position_covariance: rows(&block(3)),
        rotation_covariance: rows(&(rotation * block(0) * rotation.transpose())),
        singular_values: singular(&step.orientation).values,
        nis: step.fix.map(|fix| fix.nis / fix.degrees_of_freedom as f64),
        position_error: sqrt(errors.squared_position),
        angle_error: sqrt(errors.squared_angle),
        nees: errors.nees,
        repairs: step.events.repairs,
        reflected: step.events.reflected,
    })
}
