//! One estimate against the truth.

use nalgebra::SVector;

use super::super::error::PoseError;
use crate::localize::{Estimate, Optimum, Snapshot};
use crate::math::pose::Pose;

/// Error of one estimate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SnapshotError<const D: usize> {
    /// Error of the pose; `None` where there is none.
    pub pose: Option<PoseError<D>>,
    /// `||S_hat - S||_F^2` over the sensors against their nominal places, m^2.
    pub sensors: f64,
    /// `det Q < 0`.
    pub reflected: bool,
    /// Nothing proves the optimum.
    pub uncertain: bool,
    /// Iterations.
    pub iterations: usize,
}

impl<const D: usize> SnapshotError<D> {
    /// Measures an estimate of a snapshot.
    pub fn of(estimate: &Estimate<D>, snapshot: &Snapshot<D>, truth: &Pose<D>) -> Self {
        let sensors = snapshot.model.topology().sensors();
        let squared = |n: usize, s: SVector<f64, D>| (s - truth.act(&sensors[n])).norm_squared();
        let place = |n: usize| match estimate.theta {
            Some(theta) => Some(theta.orientation * sensors[n] + theta.position),
            None => snapshot.sensor_position(n),
        };
        Self {
            pose: estimate.theta.map(|theta| PoseError::between(&theta, truth)),
            sensors: (0..sensors.len()).filter_map(|n| place(n).map(|s| squared(n, s))).sum(),
            reflected: estimate.reflected,
            uncertain: !matches!(estimate.optimum, Optimum::Formula | Optimum::Certified),
            iterations: estimate.iterations,
        }
    }
}
