//! What a Monte-Carlo study of the Anchorless lab found, as a document.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::block::KinematicsBlock;
use super::bounds::KinematicsBoundReport;
use super::errors::Yardstick;
use crate::model::document::VERSION;
use crate::model::kinematics::settings::KinematicsName;
use crate::model::kinematics::{KinematicsScenario, KinematicsSetup};
use crate::study::moments::Estimate;

/// The result of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsReport {
    /// Version of the format, 1.
    pub version: u32,
    /// Name of the scenario.
    pub name: String,
    /// Trials that were run.
    pub trials: usize,
    /// Number of stamps, K.
    pub stamps: usize,
    /// The instants at which positions are compared, s.
    pub instants: Vec<f64>,
    /// One entry an estimator.
    pub estimators: Vec<KinematicsEstimatorReport>,
    /// What no unbiased estimator can beat: from distances alone, and with accelerations.
    pub bounds: Vec<KinematicsBoundReport>,
}

impl KinematicsReport {
    /// The figures of the blocks joined so far.
    pub(super) fn new(
        scenario: &KinematicsScenario,
        (setup, yardstick): (&KinematicsSetup, &Yardstick),
        done: &KinematicsBlock,
        bounds: Vec<KinematicsBoundReport>,
    ) -> Self {
        let estimators = scenario.estimators.enabled.iter().enumerate();
        let estimators = estimators.map(|(index, name)| KinematicsEstimatorReport {
            name: *name,
            label: name.label().to_string(),
            summary: done.estimator(index),
        });
        Self {
            version: VERSION,
            name: scenario.name.clone(),
            trials: done.trials(),
            stamps: setup.stamps.len(),
            instants: yardstick.instants.clone(),
            estimators: estimators.collect(),
            bounds,
        }
    }
}

/// One estimator over all trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsEstimatorReport {
    /// Its name in files.
    pub name: KinematicsName,
    /// Its name for people.
    pub label: String,
    /// Its figures.
    pub summary: KinematicsSummary,
}

/// The figures of one estimator, each with its standard error; a list is empty where the estimator does not give what it
/// is about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsSummary {
    /// Trials that gave an estimate; the figures are theirs.
    pub trials: usize,
    /// Trials in which the estimator gave a typed error.
    pub failures: usize,
    /// Root mean square error of a coordinate of `Y_0, Y_1, ...`, m/s^l, with one alignment in O(D), from `Y_0` (\[A\]
    /// Fig. 2a; the RMSE as printed there is this over the root of the number of coordinates).
    pub coefficients: Vec<Estimate>,
    /// Root mean square error of an entry of `vech(B_0), vech(B_1), vech(B_2)`, m^2/s^l (Fig. 1).
    pub gram: Vec<Estimate>,
    /// Root mean square error of a coordinate at each instant with that one alignment, m (Fig. 2b).
    pub positions: Vec<Estimate>,
    /// The same with an alignment at each instant, which takes away a common turn of the network, m.
    pub aligned_positions: Vec<Estimate>,
    /// The root mean square errors of `Y_1` of the trials in increasing order, m/s: their distribution.
    pub velocity_distribution: Vec<f64>,
}
