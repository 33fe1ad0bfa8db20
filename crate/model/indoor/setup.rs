//! An indoor scenario with its parts as vectors.

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::Vector3;

use super::epoch::IndoorModel;
use super::trajectory::{IndoorPath, Kinematics, kinematics};
use super::{IndoorScenario, TRANSMITTERS};
use crate::error::Result;
use crate::math::float::floor;
use crate::model::document::check::accept;
use crate::model::document::entries::{points, vector};

/// How far beyond the path the default beacons stand, m.
const MARGIN: f64 = 2.0;
/// Interval at which the box of a path is measured, s.
const BOX_INTERVAL: f64 = 0.1;

/// The typed parts of an indoor scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorSetup {
    /// Beacons, transmitters, noise: what filters know.
    pub model: IndoorModel,
    /// The true motion at the ends of all intervals, one more than there are intervals.
    pub truth: Vec<Kinematics>,
    /// Length of an interval of the IMU, s.
    pub interval: f64,
    /// For each interval, whether ranges are measured at its end.
    pub fixes: Vec<bool>,
}

impl IndoorScenario {
    /// The typed parts, after validation.
    ///
    /// # Errors
    /// [`crate::Error::Invalid`] with every problem.
    pub fn setup(&self) -> Result<IndoorSetup> {
        accept("indoor scenario", self.validate())?;
        let interval = self.imu.interval();
        let truth = kinematics(self.path, interval);
        Ok(IndoorSetup {
            model: IndoorModel {
                beacons: points(&self.beacons),
                transmitters: core::array::from_fn(|i| vector(&self.transmitters[i])),
                sigma: self.ranging.sigma,
                gravity: self.imu.gravity_vector(),
                angular_velocity_variance: self.imu.gyroscope_variance(),
                acceleration_variance: self.imu.accelerometer_variance(),
                lever_arm: self.imu.lever_arm.into(),
                lever_arm_correction: self.imu.lever_arm_correction,
            },
            fixes: fixes(truth.len() - 1, interval, self.ranging.interval),
            truth,
            interval,
        })
    }
}

/// The first fix at the end of the first interval, the others at the end of that nearest to their time.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index within the path")]
fn fixes(steps: usize, interval: f64, between: f64) -> Vec<bool> {
    let mut fixes = vec![false; steps];
    for number in 0_u32.. {
        let index = floor(f64::from(number) * between / interval + 0.5);
        if !(index < steps as f64) {
            break;
        }
        fixes[index as usize] = true;
    }
    fixes
}

/// Transmitters at the corners of the paper's isosceles triangle, in the plane of the body's first and third axis.
pub(super) fn isosceles(base: f64, altitude: f64) -> Vec<Vec<f64>> {
    let third = altitude / 3.0;
    let corners: [[f64; 3]; TRANSMITTERS] =
        [[0.0, 0.0, 2.0 * third], [0.5 * base, 0.0, -third], [-0.5 * base, 0.0, -third]];
    corners.map(Vec::from).into()
}

/// Four alternate corners of the box around a path.
pub(super) fn corners(path: IndoorPath) -> Vec<Vec<f64>> {
    let states = kinematics(path, BOX_INTERVAL);
    let extreme = |better: fn(f64, f64) -> f64, margin: f64| {
        let of_axis =
            |axis: usize| states.iter().map(|state| state.position[axis]).fold(0.0, better) + margin;
        Vector3::from_fn(|axis, _| of_axis(axis))
    };
    let (low, high) = (extreme(f64::min, -MARGIN), extreme(f64::max, MARGIN));
    let corner =
        |high_sides: [bool; 3]| (0..3).map(|i| if high_sides[i] { high[i] } else { low[i] }).collect();
    [[false, false, false], [true, true, false], [true, false, true], [false, true, true]].map(corner).into()
}
