//! What a Monte-Carlo study of the Indoor lab found, as a document.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::model::indoor::filter_settings::FilterName;
use crate::study::moments::Estimate;

/// The result of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorReport {
    /// Version of the format, 1.
    pub version: u32,
    /// Name of the scenario.
    pub name: String,
    /// Trials that were run.
    pub trials: usize,
    /// Times of the steps, s.
    pub times: Vec<f64>,
    /// One entry a filter.
    pub filters: Vec<IndoorFilterReport>,
}

/// One filter over all trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorFilterReport {
    /// Its name in files.
    pub name: FilterName,
    /// Its name for people.
    pub label: String,
    /// Its figures.
    pub summary: IndoorSummary,
}

/// The figures of one filter, each with its standard error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorSummary {
    /// Trials that reached the end; the figures are theirs, and 0 where there are none.
    pub trials: usize,
    /// Trials in which the filter gave a typed error.
    pub failures: usize,
    /// Mean over trials of `sqrt(mean over time of ||p_hat - p||^2)`, m.
    pub position: Estimate,
    /// The same of the geodesic angle, rad.
    pub angle: Estimate,
    /// Mean NEES over its 9 degrees of freedom; 1 where the covariance is right.
    pub nees: Estimate,
    /// Mean number of times in a trial that the covariance was replaced by the nearest positive definite one.
    pub repairs: Estimate,
    /// The position errors of the trials in increasing order, m: their distribution.
    pub position_distribution: Vec<f64>,
    /// The same of the angle, rad.
    pub angle_distribution: Vec<f64>,
    /// One entry a step; none in a sweep, and none where no trial reached the end.
    pub steps: Vec<IndoorStepSummary>,
}

/// The figures of one filter at one step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorStepSummary {
    /// Root mean square position error, m.
    pub position: Estimate,
    /// Root mean square geodesic angle, rad.
    pub angle: Estimate,
    /// Mean NEES over its 9 degrees of freedom.
    pub nees: Estimate,
    /// Mean of the largest singular value of the filter's `R`; 1 for a rotation.
    pub largest_singular_value: Estimate,
    /// Mean of the smallest.
    pub smallest_singular_value: Estimate,
}
