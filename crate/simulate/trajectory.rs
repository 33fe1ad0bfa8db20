//! The true track.

use alloc::vec::Vec;

use nalgebra::SVector;

use super::random::Stream;
use crate::math::pose::Pose;
use crate::math::rotation::{Angles, rotation_angles};
use crate::model::motion::Motion;
use crate::model::scenario::{MotionSettings, Setup};

/// Moves the body from its start through all epochs; `omega` and `velocity` are those of each interval.
///
/// ```text
/// R_k = exp(tau (hat(omega) + hat(e))) R_(k-1),  e ~ N(0, sigma_omega^2 I)     \[T\] eq. 11, Omega = tau hat(omega)
/// t_k = t_(k-1) + tau velocity + z,               z ~ N(0, sigma_t^2 I)         \[T\] eq. 14
/// ```
///
/// Each epoch draws the entries of `e`, then those of `z`. The true rotation is projected after every step: it stays one
/// to the last digit over any number of steps.
pub fn trajectory<const D: usize>(
    setup: &Setup<D>,
    disturbance: &MotionSettings,
    stream: &mut Stream,
) -> Vec<Pose<D>> {
    let mut pose = setup.start;
    let step = |motion: &Motion<D>| {
        pose = disturbed_step(&pose, motion, disturbance, stream);
        pose
    };
    setup.motions.iter().map(step).collect()
}

fn disturbed_step<const D: usize>(
    pose: &Pose<D>,
    motion: &Motion<D>,
    disturbance: &MotionSettings,
    stream: &mut Stream,
) -> Pose<D> {
    let mut angular_velocity: Angles = motion.angular_velocity;
    for rate in angular_velocity.iter_mut().take(rotation_angles(D)) {
        *rate += disturbance.sigma_omega * stream.normal();
    }
    let moved = Motion { angular_velocity, ..*motion };
    let next = moved.predict_pose(pose, &moved.rotation());
    Pose {
        rotation: next.rotation.renormalized(),
        position: next.position + SVector::from_fn(|_, _| disturbance.sigma_t * stream.normal()),
    }
}
