//! The document of the Indoor lab: an IMU and three transmitters on a body, beacons in a room.

pub mod epoch;
pub mod filter_settings;
pub mod presets;
mod profile;
pub mod run;
mod setup;
pub mod trajectory;
mod validate;

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::document::{Written, read, write};
use super::imu::ImuSettings;
use crate::error::{Problem, Result};
use filter_settings::FilterSettings;
pub use setup::IndoorSetup;
use trajectory::IndoorPath;

/// How many transmitters the body carries.
pub const TRANSMITTERS: usize = 3;

/// A simulated indoor experiment in space. Only the version must be given; all else is the paper's set-up on the path U.
///
/// ```
/// use rangelab::model::indoor::IndoorScenario;
/// let scenario = IndoorScenario::from_json(r#"{"version": 1, "path": "zigzag"}"#)?;
/// assert_eq!((scenario.beacons.len(), scenario.imu.rate_hz), (4, 10.0));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct IndoorScenario {
    /// Version of the format, 1.
    pub version: u32,
    /// What people call it.
    #[serde(default)]
    pub name: String,
    /// How the body moves; it starts at the origin.
    #[serde(default)]
    pub path: IndoorPath,
    /// Positions of the beacons in the world frame, m; by default four alternate corners of the box around the path, 2 m
    /// away from it on every side.
    #[serde(default)]
    pub beacons: Vec<Vec<f64>>,
    /// Positions of the three transmitters in the body frame, m; by default the paper's isosceles triangle.
    #[serde(default)]
    pub transmitters: Vec<Vec<f64>>,
    /// The IMU.
    #[serde(default)]
    pub imu: ImuSettings,
    /// The ranges.
    #[serde(default)]
    pub ranging: RangingSettings,
    /// What filters believe before the first sample.
    #[serde(default)]
    pub start: StartSettings,
    /// Which filters run, and how.
    #[serde(default)]
    pub filters: FilterSettings,
    /// Picks the random numbers, together with the trial; at most 2^53, which JavaScript can count to.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(type = "number"))]
    pub seed: u64,
    /// Hints of the page (camera, open panels); carried along, never read.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(type = "Record<string, unknown> | null"))]
    pub view: Option<serde_json::Value>,
}

/// How transmitters are ranged.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct RangingSettings {
    /// Standard deviation of a range, m.
    pub sigma: f64,
    /// Time between fixes, s: the first comes with the first sample of the IMU, each other with the sample nearest to its
    /// time.
    pub interval: f64,
    /// Probability that a range is missing, each on its own.
    pub missing_probability: f64,
}

impl Default for RangingSettings {
    /// 20 dB: a range is good to 0.1 m.
    fn default() -> Self {
        Self { sigma: 0.1, interval: 1.0, missing_probability: 0.0 }
    }
}

/// What filters believe before the first sample.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct StartSettings {
    /// How sure they are.
    pub prior: StartPrior,
    /// True: the state they start from is drawn from that; false: it is the true one, "prior knowledge".
    pub drawn: bool,
}

impl Default for StartSettings {
    fn default() -> Self {
        Self { prior: StartPrior::Isotropic { variance: 1e-6 }, drawn: false }
    }
}

/// How sure filters are of the state they start from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum StartPrior {
    /// One variance for each entry of `[vec(R); p; v]`; the half of it on each angle for filters on SO(3).
    Isotropic {
        /// The variance.
        variance: f64,
    },
    /// Standard deviations on the tangent space; for filters on `vec(R)` the covariance `s^2 J J^T`, `J_i = vec(R E_i)`.
    Tangent {
        /// Of the angle about each axis, rad.
        angle: f64,
        /// Of each coordinate of the position, m.
        position: f64,
        /// Of each coordinate of the velocity, m/s.
        velocity: f64,
    },
}

impl IndoorScenario {
    /// Reads a scenario, fills in defaults, and refuses it with every problem.
    ///
    /// # Errors
    /// [`crate::Error::Syntax`] with line and column, [`crate::Error::Version`] for a newer document,
    /// [`crate::Error::Invalid`] with every problem.
    pub fn from_json(text: &str) -> Result<Self> {
        read(text)
    }

    /// The scenario as JSON; every number comes back as the same bits.
    pub fn to_json(&self) -> String {
        write(self)
    }

    /// Every problem: path, value, limit. None: the scenario can be simulated.
    pub fn validate(&self) -> Vec<Problem> {
        validate::problems(self)
    }
}

impl Written for IndoorScenario {
    const KIND: &'static str = "indoor scenario";

    fn dimension(&self) -> usize {
        3
    }

    fn fill(&mut self, _dimension: usize) {
        if self.beacons.is_empty() {
            self.beacons = setup::corners(self.path);
        }
        if self.transmitters.is_empty() {
            self.transmitters = setup::isosceles(0.1, 0.3);
        }
    }

    fn problems(&self) -> Vec<Problem> {
        self.validate()
    }
}
