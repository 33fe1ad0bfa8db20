//! What a run of the Indoor lab gives, as a document: everything that happened, so that nothing has to run again.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::filter_settings::{FilterName, FilterSettings};
use crate::math::float::sqrt;
use crate::model::document::entries::PoseEntries;
use crate::model::document::write;

/// One trial of an indoor scenario through its filters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorRun {
    /// Version of the format, 1.
    pub version: u32,
    /// Name of the scenario.
    pub name: String,
    /// Positions of the beacons in the world frame, m.
    pub beacons: Vec<Vec<f64>>,
    /// Positions of the transmitters in the body frame, m.
    pub transmitters: Vec<Vec<f64>>,
    /// Time at the end of each step, s.
    pub times: Vec<f64>,
    /// True pose at the end of each step.
    pub truth: Vec<PoseEntries>,
    /// True velocity at the end of each step, m/s.
    pub true_velocities: Vec<[f64; 3]>,
    /// For each step, whether ranges were taken at its end.
    pub fixes: Vec<bool>,
    /// The choices of the filters.
    pub settings: FilterSettings,
    /// One entry a filter.
    pub filters: Vec<IndoorFilterRun>,
}

/// One filter over all steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorFilterRun {
    /// Its name in files.
    pub name: FilterName,
    /// Its name for people.
    pub label: String,
    /// One entry a step, up to a failure.
    pub steps: Vec<IndoorStepRecord>,
    /// Why it stopped, if it did.
    pub failure: Option<IndoorFailure>,
}

/// Why a filter stopped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorFailure {
    /// Number of the step, from 0.
    pub step: usize,
    /// The error in a sentence.
    pub message: String,
}

/// One filter at one step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorStepRecord {
    /// `R` as the filter keeps it, which need not be a rotation, and the position (m).
    pub pose: PoseEntries,
    /// Velocity in the world frame, m/s.
    pub velocity: [f64; 3],
    /// Covariance of the position, m^2.
    pub position_covariance: Vec<Vec<f64>>,
    /// Covariance of the rotation vector of the error in the world frame, rad^2.
    pub rotation_covariance: Vec<Vec<f64>>,
    /// Singular values of `R`, decreasing: all 1 for a rotation.
    pub singular_values: [f64; 3],
    /// Normalized innovation squared over its degrees of freedom, where the filter was updated.
    pub nis: Option<f64>,
    /// Distance from the true position, m.
    pub position_error: f64,
    /// Geodesic angle between the rotation next to `R` and the true one, rad.
    pub angle_error: f64,
    /// Normalized estimation error squared over its 9 degrees of freedom.
    pub nees: f64,
    /// How many times the covariance was replaced by the nearest positive definite one.
    pub repairs: usize,
    /// Whether a Q-factor was a reflection and was turned.
    pub reflected: bool,
}

impl IndoorFilterRun {
    /// Root mean square distance from the true position over its steps, m; 0 without any.
    pub fn rms_position_error(&self) -> f64 {
        sqrt(self.mean(|step| step.position_error * step.position_error))
    }

    /// Root mean square angle between its rotation and the true one over its steps, rad; 0 without any.
    pub fn rms_angle_error(&self) -> f64 {
        sqrt(self.mean(|step| step.angle_error * step.angle_error))
    }

    /// Mean NEES over its 9 degrees of freedom; 0 without steps.
    pub fn mean_nees(&self) -> f64 {
        self.mean(|step| step.nees)
    }

    fn mean(&self, part: impl Fn(&IndoorStepRecord) -> f64) -> f64 {
        self.steps.iter().map(part).sum::<f64>() / self.steps.len().max(1) as f64
    }
}

impl IndoorRun {
    /// The run as JSON.
    pub fn to_json(&self) -> String {
        write(self)
    }
}
