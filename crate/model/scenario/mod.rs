//! Scenario: everything a simulation and its estimators are told, as one JSON document.

pub(super) mod setup;
pub(super) mod validate;

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

pub use setup::Setup;

use super::availability::AvailabilitySettings;
use super::document::entries::PoseEntries;
use super::document::{Written, read, write};
use super::estimator_settings::EstimatorSettings;
use super::field_settings::FieldSettings;
use super::localize_settings::LocalizeSettings;
use super::motion::ProcessNoise;
use super::noise::RangeNoise;
use super::path::PathSettings;
use super::placement_settings::PlacementSettings;
use super::ranging::Weighting;
use crate::error::{Problem, Result};
use crate::math::rotation::rotation_angles;

/// A simulated experiment. Version, dimension, anchors, sensors and noise must be given; the rest has defaults.
///
/// ```
/// use rangelab::model::scenario::Scenario;
/// let scenario = Scenario::from_json(
///     r#"{"version": 1, "dimension": 2, "anchors": [[0, 0], [9, 0], [0, 9]],
///         "sensors": [[-0.5, 0], [0.5, 0], [0, 1]], "noise": {"kind": "range", "sigma": 0.05}}"#,
/// )?;
/// assert_eq!((scenario.steps, scenario.start.position.len()), (20, 2));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Version of the format, 1.
    pub version: u32,
    /// What people call it.
    #[serde(default)]
    pub name: String,
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// Positions of the anchors in the world frame, m.
    pub anchors: Vec<Vec<f64>>,
    /// Draws new anchors for every trial, as many as are given; null keeps them where they are.
    #[serde(default)]
    pub redraw_anchors: Option<RedrawAnchors>,
    /// Positions of the sensors in the body frame, m.
    pub sensors: Vec<Vec<f64>>,
    /// Standard deviation `sigma_e` of each coordinate of a sensor's real place on the body about the one given (\[L\]
    /// Sec. VII), m; drawn anew for every trial. Estimators and bounds know nothing of it.
    #[serde(default)]
    pub mounting_sigma: f64,
    /// How ranges are disturbed; estimators know it.
    pub noise: RangeNoise,
    /// Which ranges give the weights.
    #[serde(default)]
    pub weights: WeightSource,
    /// Whether the sensors share the weights of an anchor.
    #[serde(default)]
    pub weighting: Weighting,
    /// Probability that a range is missing, each on its own.
    #[serde(default)]
    pub missing_probability: f64,
    /// Time between epochs, s.
    #[serde(default = "one_second")]
    pub interval: f64,
    /// Number of epochs.
    #[serde(default = "twenty")]
    pub steps: usize,
    /// Picks the random numbers, together with the trial; at most 2^53, which JavaScript can count to.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(type = "number"))]
    pub seed: u64,
    /// How the body really moves.
    #[serde(default)]
    pub motion: MotionSettings,
    /// True pose before the first epoch; the identity at the origin by default.
    #[serde(default)]
    pub start: PoseEntries,
    /// What estimators believe before the first epoch.
    #[serde(default)]
    pub initial: InitialSettings,
    /// Process noise that estimators assume in each prediction; by default none.
    #[serde(default)]
    pub process: ProcessNoise,
    /// Which estimators run, and how.
    #[serde(default)]
    pub estimators: EstimatorSettings,
    /// Which ranges can be measured at all.
    #[serde(default)]
    pub availability: AvailabilitySettings,
    /// Which bound is drawn as a field.
    #[serde(default)]
    pub field: FieldSettings,
    /// What the placement adviser makes small.
    #[serde(default)]
    pub placement: PlacementSettings,
    /// Which snapshot estimators run, and how.
    #[serde(default)]
    pub localize: LocalizeSettings,
    /// Hints of the page (camera, open panels); carried along, never read.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(type = "Record<string, unknown> | null"))]
    pub view: Option<serde_json::Value>,
}

/// How anchors are drawn anew for every trial: uniformly in the cube (square) around the origin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct RedrawAnchors {
    /// Half the edge of the cube, m.
    pub half_width: f64,
}

/// Which ranges give the weights, whose variance depends on the distance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum WeightSource {
    /// The measured ranges: all that a real system has.
    #[default]
    Measured,
    /// The true ranges, as the papers' analysis assumes.
    True,
}

/// How the body really moves: constant velocities and, added to them, the motion along a path; disturbed in every step.
///
/// Estimators are told the undisturbed motion: the displacement over each interval and the turn over it, exactly.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct MotionSettings {
    /// Linear velocity in the world frame, m/s; zero by default. A path drifts with it as a whole.
    pub velocity: Vec<f64>,
    /// Angular velocity in the world frame, rad/s: 3 numbers, 1 in the plane; zero by default. It bends no path: the
    /// body spins while it follows one.
    pub angular_velocity: Vec<f64>,
    /// What the body follows; null, the default, for constant velocities alone.
    pub path: Option<PathSettings>,
    /// Standard deviation of the disturbance of the angular velocity about each axis (\[T\] eq. 11), rad/s.
    pub sigma_omega: f64,
    /// Standard deviation of the disturbance of each coordinate of the position in a step (\[T\] eq. 14), m.
    pub sigma_t: f64,
}

/// What estimators believe before the first epoch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct InitialSettings {
    /// `Q` row by row; the identity by default. It need not be a rotation: the KF's own `Q` is none.
    pub orientation: Vec<Vec<f64>>,
    /// `t`, m; the origin by default.
    pub position: Vec<f64>,
    /// Variance of each entry of `[Q | t]`; \[T\] Sec. V takes 100, the default.
    pub covariance: f64,
}

impl Default for InitialSettings {
    fn default() -> Self {
        Self { orientation: Vec::new(), position: Vec::new(), covariance: 100.0 }
    }
}

fn one_second() -> f64 {
    1.0
}

fn twenty() -> usize {
    20
}

impl Scenario {
    /// Reads and validates a scenario; what was left out is filled in.
    ///
    /// # Errors
    /// [`crate::Error::Syntax`] with line and column, [`crate::Error::Version`] for a newer format,
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

impl Written for Scenario {
    const KIND: &'static str = "scenario";

    fn dimension(&self) -> usize {
        self.dimension
    }

    fn fill(&mut self, dimension: usize) {
        if self.start == PoseEntries::default() {
            self.start = PoseEntries::identity(dimension);
        }
        zeros_if_empty(&mut self.motion.velocity, dimension);
        zeros_if_empty(&mut self.motion.angular_velocity, rotation_angles(dimension));
        self.initial.fill(dimension);
    }

    fn problems(&self) -> Vec<Problem> {
        self.validate()
    }
}

impl InitialSettings {
    pub(super) fn fill(&mut self, dimension: usize) {
        let identity = PoseEntries::identity(dimension);
        if self.orientation.is_empty() {
            self.orientation = identity.orientation;
        }
        if self.position.is_empty() {
            self.position = identity.position;
        }
    }
}

pub(super) fn zeros_if_empty(vector: &mut Vec<f64>, length: usize) {
    if vector.is_empty() {
        *vector = vec![0.0; length];
    }
}
