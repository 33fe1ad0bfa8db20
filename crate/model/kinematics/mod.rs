//! The document of the Anchorless lab: mobile nodes that measure the distances between each other, and their accelerations.
//!
//! N nodes move along polynomials of time, `X(t) = sum_l Y_l t^l/l!`, `X` and every `Y_l` D x N. No node stands anywhere
//! known: distances show the motion up to a common motion of the whole network, which is fixed by centring every
//! coefficient and by one element of O(D).
//!
//! The dimension is a number here, not a type: coefficients are D x N matrices from the heap, because N and L are known
//! only when the program runs and one record then fits every estimator. What must be fast goes through
//! [`with_dimension!`](crate::with_dimension).

pub mod coefficients;
pub mod distance_record;
pub mod estimate;
pub mod gauge;
pub mod gauge_directions;
pub mod pair_polynomial;
pub mod presets;
pub mod run;
pub mod settings;
pub mod stacked;
pub mod stamps;
pub mod time_scale;
mod validate;

use alloc::string::String;
use alloc::vec::Vec;

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use super::document::check::accept;
use super::document::{Written, read, write};
use crate::error::{Problem, Result};
use coefficients::RelativeKinematics;
use settings::KinematicsSettings;
use stamps::Stamps;

/// A simulated network of mobile nodes. Version and coefficients must be given; all else is the set-up of \[A\] Sec. 5.
///
/// ```
/// use rangelab::model::kinematics::KinematicsScenario;
/// let text = r#"{"version": 1, "coefficients": [[[0, 0], [3, 0], [0, 4]], [[1, 0], [0, 0], [0, 1]]]}"#;
/// let scenario = KinematicsScenario::from_json(text)?;
/// assert_eq!((scenario.dimension(), scenario.nodes(), scenario.degree()), (2, 3, 1));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct KinematicsScenario {
    /// Version of the format, 1.
    pub version: u32,
    /// What people call it.
    #[serde(default)]
    pub name: String,
    /// `Y_0, Y_1, ...` in this order, each a list of the nodes' vectors: positions (m), velocities (m/s), accelerations
    /// (m/s^2) and so on at time 0. They need not be centred.
    pub coefficients: Vec<Vec<Vec<f64>>>,
    /// When distances and accelerations are measured.
    #[serde(default)]
    pub stamps: Stamps,
    /// How well.
    #[serde(default)]
    pub noise: KinematicsNoise,
    /// Which estimators run, and how.
    #[serde(default)]
    pub estimators: KinematicsSettings,
    /// At how many instants, evenly from the first stamp to the last, the motion is played and positions are compared.
    #[serde(default = "default_steps")]
    pub steps: usize,
    /// Picks the random numbers, together with the trial; at most 2^53, which JavaScript can count to.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(type = "number"))]
    pub seed: u64,
    /// Hints of the page (camera, open panels); carried along, never read.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(type = "Record<string, unknown> | null"))]
    pub view: Option<serde_json::Value>,
}

/// How well nodes measure.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct KinematicsNoise {
    /// Standard deviation of a distance, each pair and stamp on its own, m.
    pub sigma_distance: f64,
    /// Standard deviation of a coordinate of an acceleration, m/s^2.
    pub sigma_acceleration: f64,
    /// Probability that a distance is missing, each on its own.
    pub missing_probability: f64,
}

impl Default for KinematicsNoise {
    /// \[A\] Sec. 5.
    fn default() -> Self {
        Self { sigma_distance: 0.01, sigma_acceleration: 0.001, missing_probability: 0.0 }
    }
}

const fn default_steps() -> usize {
    101
}

/// The typed parts of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsSetup {
    /// The motion as given, not centred.
    pub motion: RelativeKinematics,
    /// When it is measured, s, increasing or not.
    pub stamps: Vec<f64>,
}

impl KinematicsScenario {
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

    /// D, the number of coordinates of the first node.
    pub fn dimension(&self) -> usize {
        self.coefficients.first().and_then(|points| points.first()).map_or(0, Vec::len)
    }

    /// N.
    pub fn nodes(&self) -> usize {
        self.coefficients.first().map_or(0, Vec::len)
    }

    /// L, of the true motion; estimators assume that of their settings.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// The typed parts, after validation.
    ///
    /// # Errors
    /// [`crate::Error::Invalid`] with every problem.
    pub fn setup(&self) -> Result<KinematicsSetup> {
        accept(Self::KIND, self.validate())?;
        let matrix = |points: &Vec<Vec<f64>>| {
            DMatrix::from_fn(self.dimension(), points.len(), |i, node| points[node][i])
        };
        let motion = RelativeKinematics::new(self.coefficients.iter().map(matrix).collect())?;
        Ok(KinematicsSetup { motion, stamps: self.stamps.times() })
    }

    /// The instants at which the motion is played and positions are compared, s.
    pub fn instants(&self) -> Vec<f64> {
        let [first, last] = self.stamps.ends();
        stamps::evenly(first, last, self.steps)
    }
}

impl Written for KinematicsScenario {
    const KIND: &'static str = "kinematics scenario";

    fn dimension(&self) -> usize {
        Self::dimension(self)
    }

    fn fill(&mut self, _dimension: usize) {}

    fn problems(&self) -> Vec<Problem> {
        self.validate()
    }
}
