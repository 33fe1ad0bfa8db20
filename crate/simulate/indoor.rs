//! Recordings drawn from an indoor scenario.

use alloc::vec::Vec;

use nalgebra::Vector3;

use super::imu::exact_sample;
use super::random::{Part, Stream};
use crate::error::Result;
use crate::math::float::sqrt;
use crate::math::rotation::Rotation;
use crate::model::imu::{ImuSample, ImuSettings};
use crate::model::indoor::epoch::{
    BeaconRanges, IndoorEpoch, IndoorModel, IndoorRecording, IndoorStart, NavigationState,
};
use crate::model::indoor::trajectory::Kinematics;
use crate::model::indoor::{IndoorScenario, IndoorSetup, StartPrior, StartSettings};

/// Draws one trial of an indoor scenario.
///
/// The same scenario and trial give the same bits everywhere, and trials may be drawn in any order. Random numbers are
/// common: a change of beacons or noise changes no draw, only what is made of it.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario.
///
/// ```
/// use rangelab::model::indoor::presets::indoor_preset;
/// use rangelab::simulate::indoor::simulate_indoor;
/// let recording = simulate_indoor(&indoor_preset("indoor-u")?, 0)?;
/// assert_eq!((recording.epochs.len(), recording.truth.len()), (100, 100));
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn simulate_indoor(scenario: &IndoorScenario, trial: u64) -> Result<IndoorRecording> {
    Ok(draw(scenario, &scenario.setup()?, trial))
}

/// [`simulate_indoor`] for a scenario whose parts are already there.
pub fn draw(scenario: &IndoorScenario, setup: &IndoorSetup, trial: u64) -> IndoorRecording {
    let (model, truth) = (&setup.model, &setup.truth);
    let samples: Vec<ImuSample> = (0..setup.fixes.len()).map(|k| sample(scenario, setup, k, trial)).collect();
    let ranges = |k: usize| {
        let mut stream = stream(scenario, trial, k, Sensor::Ranging);
        if setup.fixes[k] { ranges(model, &truth[k + 1], scenario, &mut stream) } else { Vec::new() }
    };
    let epoch = |k: usize| IndoorEpoch {
        interval: setup.interval,
        sample: samples[k],
        next_angular_velocity: samples[(k + 1).min(samples.len() - 1)].angular_velocity,
        ranges: ranges(k),
    };
    IndoorRecording {
        model: model.clone(),
        start: start(&truth[0], &scenario.start, &mut Stream::new(scenario.seed, trial, Part::Motion)),
        epochs: (0..samples.len()).map(epoch).collect(),
        truth: truth[1..].iter().map(state).collect(),
    }
}

#[derive(Clone, Copy)]
enum Sensor {
    Imu,
    Ranging,
}

/// Each sensor draws from its own stream in each epoch.
fn stream(scenario: &IndoorScenario, trial: u64, k: usize, sensor: Sensor) -> Stream {
    Stream::new(scenario.seed, trial, Part::Epoch(2 * k + sensor as usize))
}

fn normal_vector(stream: &mut Stream) -> Vector3<f64> {
    Vector3::from_fn(|_, _| stream.normal())
}

fn sample(scenario: &IndoorScenario, setup: &IndoorSetup, k: usize, trial: u64) -> ImuSample {
    let (imu, model): (&ImuSettings, _) = (&scenario.imu, &setup.model);
    let (before, after) = (&setup.truth[k], &setup.truth[k + 1]);
    let exact = exact_sample(imu.convention, before, after, setup.interval, &model.lever_arm, &model.gravity);
    let mut stream = stream(scenario, trial, k, Sensor::Imu);
    let turning = normal_vector(&mut stream) * sqrt(model.angular_velocity_variance);
    let moving = normal_vector(&mut stream) * sqrt(model.acceleration_variance);
    ImuSample {
        angular_velocity: exact.angular_velocity + turning + Vector3::from(imu.gyroscope_bias),
        acceleration: exact.acceleration + moving + Vector3::from(imu.accelerometer_bias),
    }
}

/// Each pair draws a uniform number, which loses the range, then the noise, needed or not.
fn ranges(
    model: &IndoorModel,
    truth: &Kinematics,
    scenario: &IndoorScenario,
    stream: &mut Stream,
) -> Vec<BeaconRanges> {
    let transmitters = model.transmitters.map(|c| truth.position + truth.rotation.matrix() * c);
    let mut range = |beacon: &Vector3<f64>, transmitter: &Vector3<f64>| {
        let lost = stream.uniform() < scenario.ranging.missing_probability;
        let noise = model.sigma * stream.normal();
        (!lost).then(|| sqrt((transmitter - beacon).norm_squared()) + noise)
    };
    model.beacons.iter().map(|beacon| transmitters.map(|transmitter| range(beacon, &transmitter))).collect()
}

fn state(truth: &Kinematics) -> NavigationState {
    NavigationState { rotation: truth.rotation, position: truth.position, velocity: truth.velocity }
}

/// What filters start from: `R Exp(phi)`, `p` and `v` each off by what the prior says.
fn start(truth: &Kinematics, settings: &StartSettings, stream: &mut Stream) -> IndoorStart {
    let (angle, position, velocity) = match settings.prior {
        StartPrior::Isotropic { variance } => (sqrt(0.5 * variance), sqrt(variance), sqrt(variance)),
        StartPrior::Tangent { angle, position, velocity } => (angle, position, velocity),
    };
    let mut state = state(truth);
    if settings.drawn {
        let phi = normal_vector(stream) * angle;
        state.rotation = state.rotation.compose(&Rotation::exp(&phi.into()));
        state.position += normal_vector(stream) * position;
        state.velocity += normal_vector(stream) * velocity;
    }
    IndoorStart { state, prior: settings.prior }
}
