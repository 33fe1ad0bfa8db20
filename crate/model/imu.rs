//! An inertial measurement unit: what its data sheet says, and how its samples belong to the motion.

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use super::document::check::{Check, Limit};
use crate::math::float::radians;

/// Standard gravity, m/s^2.
pub const STANDARD_GRAVITY: f64 = 9.806_65;

/// How the sample of an interval of length `T` belongs to the motion in it. It decides how well a filter can do: see each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Convention {
    /// Angular velocity and acceleration at the beginning of the interval: the literal reading of \[I\] eq. 14.
    #[default]
    Sample,
    /// What makes the discretization of \[I\] eq. 13 exact: the turn over the interval, and the change of velocity over
    /// it in the body's axes at its beginning.
    Disc,
    /// Delta-angle and delta-velocity, as an IMU gives them that integrates inside: the constant turn and acceleration
    /// in body axes that change orientation and velocity over the interval as the motion does.
    Mean,
    /// The mean of the samples at both ends.
    Trap,
}

impl Convention {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 4] = [Self::Sample, Self::Disc, Self::Mean, Self::Trap];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sample => "sample",
            Self::Disc => "disc",
            Self::Mean => "mean",
            Self::Trap => "trap",
        }
    }
}

/// What is done about a lever arm, which makes the accelerometer feel the body's turning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum LeverArmCorrection {
    /// `a_c = a_imu - (Omega^2 + alpha) z`, all in the body frame.
    #[default]
    Corrected,
    /// Nothing.
    Ignored,
    /// \[I\] eq. 28 as printed, `a_c = a_imu - R (Omega^2 + alpha) z` with the orientation believed: it mixes frames.
    Printed,
}

/// An inertial measurement unit on the body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct ImuSettings {
    /// Samples in a second.
    pub rate_hz: f64,
    /// How a sample belongs to its interval.
    pub convention: Convention,
    /// Rate noise spectral density of the gyroscope, degrees/s/sqrt(Hz).
    pub gyroscope_density_degrees: f64,
    /// Noise spectral density of the accelerometer, micro-g/sqrt(Hz).
    pub accelerometer_density_micro_g: f64,
    /// Constant error of the angular velocity, rad/s; no filter knows of it.
    pub gyroscope_bias: [f64; 3],
    /// Constant error of the acceleration, m/s^2; no filter knows of it.
    pub accelerometer_bias: [f64; 3],
    /// Gravity along minus the third axis, m/s^2: the accelerometer measures `R^T (a - g)`, and filters add `g`. 0, the
    /// default, is the paper's accelerometer, which measures `R^T a`.
    pub gravity: f64,
    /// Place of the IMU on the body, m.
    pub lever_arm: [f64; 3],
    /// What is done about the lever arm.
    pub lever_arm_correction: LeverArmCorrection,
}

impl Default for ImuSettings {
    /// The MPU-9250 at 10 Hz, as in \[I\] Sec. V-A.
    fn default() -> Self {
        Self {
            rate_hz: 10.0,
            convention: Convention::default(),
            gyroscope_density_degrees: 0.01,
            accelerometer_density_micro_g: 300.0,
            gyroscope_bias: [0.0; 3],
            accelerometer_bias: [0.0; 3],
            gravity: 0.0,
            lever_arm: [0.0; 3],
            lever_arm_correction: LeverArmCorrection::default(),
        }
    }
}

impl ImuSettings {
    /// Time between samples, s.
    pub fn interval(&self) -> f64 {
        1.0 / self.rate_hz
    }

    /// Variance of each coordinate of the angular velocity, rad^2/s^2: the density squared times half the rate
    /// (\[I\] Sec. V-A).
    ///
    /// ```
    /// let imu = rangelab::model::imu::ImuSettings::default();
    /// assert!((imu.gyroscope_variance() - 1.523e-7).abs() < 1e-10);
    /// assert!((imu.accelerometer_variance() - 4.33e-5).abs() < 1e-7);
    /// ```
    pub fn gyroscope_variance(&self) -> f64 {
        let density = radians(self.gyroscope_density_degrees);
        density * density * 0.5 * self.rate_hz
    }

    /// Variance of each coordinate of the acceleration, m^2/s^4.
    pub fn accelerometer_variance(&self) -> f64 {
        let density = self.accelerometer_density_micro_g * 1e-6 * STANDARD_GRAVITY;
        density * density * 0.5 * self.rate_hz
    }

    /// Gravity in the world frame, m/s^2.
    pub fn gravity_vector(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, -self.gravity)
    }

    pub(super) fn check(&self, check: &mut Check) {
        check.number("imu.rate_hz", self.rate_hz, Limit::RATE);
        check.number("imu.gyroscope_density_degrees", self.gyroscope_density_degrees, Limit::DENSITY);
        check.number("imu.accelerometer_density_micro_g", self.accelerometer_density_micro_g, Limit::DENSITY);
        check.vector("imu.gyroscope_bias", &self.gyroscope_bias, None, Limit::ANGULAR_VELOCITY);
        check.vector("imu.accelerometer_bias", &self.accelerometer_bias, None, Limit::ACCELERATION);
        check.number("imu.gravity", self.gravity, Limit::GRAVITY);
        check.vector("imu.lever_arm", &self.lever_arm, None, Limit::COORDINATE);
    }
}

/// One sample of an IMU: what it measured, at its own place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImuSample {
    /// Angular velocity in the body frame, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// Acceleration in the body frame, m/s^2; specific force where there is gravity.
    pub acceleration: Vector3<f64>,
}

/// What a filter is driven by over one interval: motion of the body's origin, and how well it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Angular velocity in the body frame, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// Acceleration of the body's origin in the body frame, m/s^2; specific force where there is gravity.
    pub acceleration: Vector3<f64>,
    /// Variance of each coordinate of the angular velocity, rad^2/s^2.
    pub angular_velocity_variance: f64,
    /// Covariance of the acceleration, m^2/s^4.
    pub acceleration_covariance: Matrix3<f64>,
}
