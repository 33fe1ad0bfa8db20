//! What a sweep found.

use alloc::string::String;
use alloc::vec::Vec;

use crate::model::indoor::filter_settings::FilterName;
use crate::study::indoor::report::IndoorSummary;

/// The figures of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorSweepReport {
    /// Name of the scenario.
    pub name: String,
    /// Trials that were run at each point.
    pub trials: usize,
    /// The points.
    pub points: Vec<f64>,
    /// One entry a filter.
    pub filters: Vec<IndoorSweepFilter>,
}

/// One filter over a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorSweepFilter {
    /// Its name in files.
    pub name: FilterName,
    /// Its name for people.
    pub label: String,
    /// Its figures, point by point.
    pub points: Vec<IndoorSummary>,
}
