//! Recording: ranges with the motion between them, measured or simulated, as one JSON document.

mod convert;
mod validate;

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::document::entries::PoseEntries;
use super::document::{Written, read, write};
use super::motion::ProcessNoise;
use super::noise::RangeNoise;
use super::ranging::Weighting;
use super::scenario::{InitialSettings, WeightSource, zeros_if_empty};
use crate::error::{Problem, Result};
use crate::math::rotation::rotation_angles;

/// What estimators are given; they cannot tell whether it was simulated. Version, dimension, anchors, sensors, noise and
/// epochs must be given; the rest has defaults.
///
/// ```
/// use rangelab::model::recording::RecordingDocument;
/// let document = RecordingDocument::from_json(
///     r#"{"version": 1, "dimension": 2, "anchors": [[0, 0], [9, 0], [0, 9]], "sensors": [[0, 0], [1, 0]],
///         "noise": {"kind": "range", "sigma": 0.05},
///         "epochs": [{"interval": 0.1, "ranges": [[5.0, 5.7], [6.4, null], [6.7, 7.2]]}]}"#,
/// )?;
/// let recording = document.recording::<2>()?;
/// assert_eq!(recording.epochs[0].ranges.get(0, 0), Some(25.0)); // squared
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct RecordingDocument {
    /// Version of the format, 1.
    pub version: u32,
    /// What people call it.
    #[serde(default)]
    pub name: String,
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// Positions of the anchors in the world frame, m.
    pub anchors: Vec<Vec<f64>>,
    /// Positions of the sensors in the body frame, m.
    pub sensors: Vec<Vec<f64>>,
    /// How ranges are disturbed.
    pub noise: RangeNoise,
    /// Which ranges give the weights; the true ones need the truth in every epoch.
    #[serde(default)]
    pub weights: WeightSource,
    /// Whether the sensors share the weights of an anchor.
    #[serde(default)]
    pub weighting: Weighting,
    /// What estimators believe before the first epoch.
    #[serde(default)]
    pub initial: InitialSettings,
    /// Process noise that estimators assume in each prediction; by default none.
    #[serde(default)]
    pub process: ProcessNoise,
    /// The epochs, in order.
    pub epochs: Vec<EpochDocument>,
}

/// One epoch: the motion since the last one, then ranges, and the truth where it is known.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct EpochDocument {
    /// Time since the last epoch, s.
    pub interval: f64,
    /// Linear velocity over the interval in the world frame, m/s; zero by default.
    #[serde(default)]
    pub velocity: Vec<f64>,
    /// Angular velocity over the interval in the world frame, rad/s: 3 numbers, 1 in the plane; zero by default.
    #[serde(default)]
    pub angular_velocity: Vec<f64>,
    /// Squared ranges, m^2: a row an anchor, in it an entry a sensor, null where missing. This or `ranges`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub squared_ranges: Option<Vec<Vec<Option<f64>>>>,
    /// Ranges, m, in the same shape.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub ranges: Option<Vec<Vec<Option<f64>>>>,
    /// The true pose. Estimators never see it; errors are measured against it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub truth: Option<PoseEntries>,
}

impl RecordingDocument {
    /// Reads and validates a recording; what was left out is filled in.
    ///
    /// # Errors
    /// [`crate::Error::Syntax`] with line and column, [`crate::Error::Version`] for a newer format,
    /// [`crate::Error::Invalid`] with every problem.
    pub fn from_json(text: &str) -> Result<Self> {
        read(text)
    }

    /// The recording as JSON; every number comes back as the same bits.
    pub fn to_json(&self) -> String {
        write(self)
    }

    /// Every problem: path, value, limit. None: estimators can read it.
    pub fn validate(&self) -> Vec<Problem> {
        validate::problems(self)
    }
}

impl Written for RecordingDocument {
    const KIND: &'static str = "recording";

    fn dimension(&self) -> usize {
        self.dimension
    }

    fn fill(&mut self, dimension: usize) {
        self.initial.fill(dimension);
        for epoch in &mut self.epochs {
            zeros_if_empty(&mut epoch.velocity, dimension);
            zeros_if_empty(&mut epoch.angular_velocity, rotation_angles(dimension));
        }
    }

    fn problems(&self) -> Vec<Problem> {
        self.validate()
    }
}
