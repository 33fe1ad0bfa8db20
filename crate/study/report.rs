//! What a Monte-Carlo study found, as a document.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::moments::Estimate;
use super::tally::Summary;
use crate::model::estimator_settings::EstimatorName;

/// The result of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct StudyReport {
    /// Version of the format, 1.
    pub version: u32,
    /// Name of the scenario.
    pub name: String,
    /// Trials that were run.
    pub trials: usize,
    /// One entry an estimator.
    pub estimators: Vec<EstimatorReport>,
    /// One entry a bound that exists.
    pub bounds: Vec<BoundReport>,
}

/// One estimator over all trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct EstimatorReport {
    /// Its name in files.
    pub name: EstimatorName,
    /// Its name for people.
    pub label: String,
    /// One entry a step.
    pub steps: Vec<Summary>,
}

/// One bound, the root of its mean over the trials' true trajectories.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct BoundReport {
    /// Its name in files.
    pub name: String,
    /// Its name for people.
    pub label: String,
    /// One entry a step.
    pub steps: Vec<BoundSummary>,
}

/// One bound at one step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct BoundSummary {
    /// Trials in which the bound exists.
    pub trials: usize,
    /// Least `RMSE(Q)`.
    pub orientation: Estimate,
    /// Least root mean square rotation angle, rad.
    pub angle: Estimate,
    /// Least `RMSE(t)`, m.
    pub position: Estimate,
}
