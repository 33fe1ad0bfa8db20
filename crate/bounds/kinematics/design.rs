//! What is measured, and how well.

use alloc::vec::Vec;

use crate::model::kinematics::KinematicsNoise;

/// When distances, and accelerations where there are any, are measured, and how well.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsDesign {
    /// The stamps, s.
    pub stamps: Vec<f64>,
    /// Standard deviation of a distance, m.
    pub sigma_distance: f64,
    /// Part of the distances that is there. Information about the motion is that part of the whole, as it is on average.
    pub present: f64,
    /// Standard deviation of a coordinate of an acceleration, m/s^2; `None` without accelerometers.
    pub sigma_acceleration: Option<f64>,
}

impl KinematicsDesign {
    /// Distances alone.
    pub fn distances(stamps: &[f64], noise: &KinematicsNoise) -> Self {
        Self {
            stamps: stamps.to_vec(),
            sigma_distance: noise.sigma_distance,
            present: 1.0 - noise.missing_probability,
            sigma_acceleration: None,
        }
    }

    /// Distances and accelerations, at the same stamps.
    pub fn with_accelerometers(stamps: &[f64], noise: &KinematicsNoise) -> Self {
        Self { sigma_acceleration: Some(noise.sigma_acceleration), ..Self::distances(stamps, noise) }
    }
}
