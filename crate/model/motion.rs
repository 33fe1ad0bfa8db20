//! How the body moves between epochs: the filter's linear model (\[T\] eq. 12 and 14).

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use crate::math::pose::{Pose, Theta};
use crate::math::rotation::{Angles, Rotation};

/// Known motion over one interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// Length of the interval, s.
    pub interval: f64,
    /// Linear velocity in the world frame, m/s.
    pub velocity: SVector<f64, D>,
    /// Angular velocity in the world frame, rad/s; one number in the plane.
    pub angular_velocity: Angles,
}

impl<const D: usize> Motion<D> {
    /// The body stands still.
    pub fn rest(interval: f64) -> Self {
        Self { interval, velocity: SVector::zeros(), angular_velocity: [0.0; 3] }
    }

    /// Both motions at once, over the same interval: velocities add.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let angular_velocity = core::array::from_fn(|i| self.angular_velocity[i] + other.angular_velocity[i]);
        Self { interval: self.interval, velocity: self.velocity + other.velocity, angular_velocity }
    }

    /// `F_Q = exp(interval hat(omega))` (\[T\] eq. 10; `Omega` carries the sampling time).
    pub fn rotation(&self) -> Rotation<D> {
        Rotation::exp(&self.angular_velocity.map(|x| x * self.interval))
    }

    /// Predicts the unconstrained state, `Q <- F_Q Q`, `t <- t + interval velocity` (\[T\] eq. 17a).
    #[must_use]
    pub fn predict_theta(&self, theta: &Theta<D>, rotation: &Rotation<D>) -> Theta<D> {
        Theta {
            orientation: rotation.matrix() * theta.orientation,
            position: theta.position + self.velocity * self.interval,
        }
    }

    /// Predicts a pose by the same motion.
    #[must_use]
    pub fn predict_pose(&self, pose: &Pose<D>, rotation: &Rotation<D>) -> Pose<D> {
        Pose {
            rotation: rotation.compose(&pose.rotation),
            position: pose.position + self.velocity * self.interval,
        }
    }
}

/// Process noise of one prediction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct ProcessNoise {
    /// Standard deviation of each entry of `Z_Q` (\[T\] eq. 12), and of the rotation about each axis for the error-state
    /// filter and the intrinsic bound, rad.
    pub sigma_q: f64,
    /// Standard deviation of each coordinate of `z_t` (\[T\] eq. 14), m.
    pub sigma_t: f64,
}
