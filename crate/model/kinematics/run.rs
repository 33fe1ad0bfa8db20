//! What one trial of the Anchorless lab gives, as a document: everything that happened, so that nothing has to run again.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::settings::{KinematicsName, KinematicsSettings};
use crate::model::document::write;

/// Points as lists of coordinates.
pub type Points = Vec<Vec<f64>>;

/// One trial of a scenario through its estimators.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsRun {
    /// Version of the format, 1.
    pub version: u32,
    /// Name of the scenario.
    pub name: String,
    /// The stamps, s.
    pub stamps: Vec<f64>,
    /// How many distances are missing.
    pub missing: usize,
    /// The true motion, centred: `Y_0, Y_1, ...`, each a list of the nodes' vectors, m/s^l.
    pub truth: Vec<Points>,
    /// `Q`, from the frame of the truth to that of the accelerometers, row by row.
    pub sensor_from_world: Points,
    /// The instants at which the motion is played, s.
    pub instants: Vec<f64>,
    /// The choices of the estimators.
    pub settings: KinematicsSettings,
    /// One entry an estimator.
    pub estimators: Vec<KinematicsEstimatorRun>,
}

/// What one estimator found, in the frame of the truth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsEstimatorRun {
    /// Its name in files.
    pub name: KinematicsName,
    /// Its name for people.
    pub label: String,
    /// Why it gave nothing, in a sentence, if it did.
    pub failure: Option<String>,
    /// `Y_0, Y_1, ...` after one alignment in O(D), from `Y_0`, m/s^l; empty where it finds no motion.
    pub coefficients: Vec<Points>,
    /// Root mean square error of a coordinate of each, m/s^l.
    pub coefficient_errors: Vec<f64>,
    /// Root mean square error of an entry of `vech(B_0), vech(B_1), vech(B_2)`, m^2/s^l; empty where it finds none.
    pub gram_errors: Vec<f64>,
    /// Root mean square error of a coordinate at each instant with that alignment, m.
    pub position_errors: Vec<f64>,
    /// The same with an alignment at each instant, m.
    pub aligned_position_errors: Vec<f64>,
    /// For estimators of one epoch at a time: positions at each stamp, each aligned by itself, m; `null` where distances are
    /// missing.
    pub snapshots: Vec<Option<Points>>,
    /// Least eigenvalue kept of the accelerations' Gram matrix over its most negative one; below 1 they drown in noise.
    pub acceleration_margin: Option<f64>,
    /// Iterations that were made; 0 for closed forms.
    pub iterations: usize,
}

impl KinematicsRun {
    /// The run as JSON; every number comes back as the same bits.
    pub fn to_json(&self) -> String {
        write(self)
    }
}
