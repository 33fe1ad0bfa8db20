//! What the filters of the Indoor lab are given.

use alloc::vec::Vec;

use nalgebra::Vector3;

use super::{StartPrior, TRANSMITTERS};
use crate::math::rotation::Rotation;
use crate::model::imu::{ImuSample, LeverArmCorrection};

/// What filters know of the room, the body and its sensors.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorModel {
    /// Positions of the beacons in the world frame, m.
    pub beacons: Vec<Vector3<f64>>,
    /// Positions of the transmitters in the body frame, m.
    pub transmitters: [Vector3<f64>; TRANSMITTERS],
    /// Standard deviation of a range, m.
    pub sigma: f64,
    /// Gravity in the world frame, m/s^2; zero where the accelerometer does not feel it.
    pub gravity: Vector3<f64>,
    /// Variance of each coordinate of the angular velocity, rad^2/s^2.
    pub angular_velocity_variance: f64,
    /// Variance of each coordinate of the acceleration, m^2/s^4.
    pub acceleration_variance: f64,
    /// Place of the IMU on the body, m.
    pub lever_arm: Vector3<f64>,
    /// What filters do about it.
    pub lever_arm_correction: LeverArmCorrection,
}

/// Ranges of one beacon to the transmitters, m; `None` is missing.
pub type BeaconRanges = [Option<f64>; TRANSMITTERS];

/// One interval of the IMU and the ranges at its end. It holds no truth: a filter cannot look.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorEpoch {
    /// Length of the interval, s. A gap in the samples is a longer interval: the last sample is held over it.
    pub interval: f64,
    /// The sample of the interval.
    pub sample: ImuSample,
    /// Angular velocity of the sample after it, rad/s, for the angular acceleration that a lever arm needs.
    pub next_angular_velocity: Vector3<f64>,
    /// Ranges at the end of the interval, beacon by beacon; empty where none were taken.
    pub ranges: Vec<BeaconRanges>,
}

/// Orientation, position and velocity of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NavigationState {
    /// `world_from_body`.
    pub rotation: Rotation<3>,
    /// Position in the world frame, m.
    pub position: Vector3<f64>,
    /// Velocity in the world frame, m/s.
    pub velocity: Vector3<f64>,
}

/// What filters believe before the first epoch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IndoorStart {
    /// The state.
    pub state: NavigationState,
    /// How sure they are of it.
    pub prior: StartPrior,
}

/// All that filters are given, and the truth apart, for those who measure them.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorRecording {
    /// Beacons, transmitters, noise.
    pub model: IndoorModel,
    /// Belief before the first epoch.
    pub start: IndoorStart,
    /// The epochs, in order.
    pub epochs: Vec<IndoorEpoch>,
    /// The true state at the end of each epoch.
    pub truth: Vec<NavigationState>,
}

impl IndoorEpoch {
    /// Whether each range was measured, beacon by beacon; false for all `beacons` where none were taken.
    pub fn present(&self, beacons: usize) -> impl Iterator<Item = bool> + '_ {
        let taken =
            |m: usize| self.ranges.get(m).map_or([false; TRANSMITTERS], |of| of.map(|range| range.is_some()));
        (0..beacons).flat_map(taken)
    }
}

impl NavigationState {
    /// The world position of a point of the body, `p + R c`.
    pub fn act(&self, point_in_body: &Vector3<f64>) -> Vector3<f64> {
        self.position + self.rotation.matrix() * point_in_body
    }
}
