//! What a localization study found, as a document.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::model::localize_settings::LocalizerName;
use crate::model::noise::RangeNoise;
use crate::study::moments::Estimate;

/// The result of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct LocalizationReport {
    /// Name of the scenario.
    pub name: String,
    /// Trials that were run at each point.
    pub trials: usize,
    /// The points of the sweep.
    pub points: Vec<SnapshotPoint>,
    /// One entry an estimator.
    pub estimators: Vec<SnapshotReport>,
    /// One entry a bound.
    pub bounds: Vec<SnapshotBoundReport>,
}

/// One point of a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotPoint {
    /// The noise.
    pub noise: RangeNoise,
    /// What it means for a range, root mean square of the standard deviations over all pairs with the anchors as given, m.
    pub range_error: f64,
}

/// One estimator over the sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotReport {
    /// Its name in files.
    pub name: LocalizerName,
    /// Its name for people.
    pub label: String,
    /// One entry a point.
    pub points: Vec<SnapshotSummary>,
}

/// One estimator at one noise, each figure with its standard error; those of a pose are null for an estimator without one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotSummary {
    /// Trials with an estimate.
    pub trials: usize,
    /// Trials with a typed error.
    pub failures: usize,
    /// `RMSE(Q) = sqrt(mean ||Q_hat - Q||_F^2)`.
    pub rmse_orientation: Option<Estimate>,
    /// Root mean square geodesic angle, rad.
    pub rms_angle: Option<Estimate>,
    /// The paper's literal mean angular error, `sqrt(mean over trials and columns of the column angle)`, in sqrt(rad).
    pub paper_mae: Option<Estimate>,
    /// `RMSE(t)`, m.
    pub rmse_position: Option<Estimate>,
    /// `RMSE(S) = sqrt(mean ||S_hat - S||_F^2)` over all sensors together against their nominal places (\[L\] eq. 53), m.
    pub rmse_sensors: Estimate,
    /// `||mean (Q_hat - Q)||_F`; its standard error is the level that sampling alone gives.
    pub bias_orientation: Option<Estimate>,
    /// `||mean (t_hat - t)||`, m.
    pub bias_position: Option<Estimate>,
    /// Share of trials in which `Q` mirrors the body.
    pub reflection_rate: Option<Estimate>,
    /// Share of trials in which the optimum is neither a formula's nor certified.
    pub uncertain_rate: Option<Estimate>,
    /// Iterations.
    pub iterations: Estimate,
    /// The most iterations in one trial.
    pub most_iterations: usize,
}

/// One bound over the sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotBoundReport {
    /// Its name in files.
    pub name: String,
    /// Its name for people.
    pub label: String,
    /// One entry a point.
    pub points: Vec<SnapshotBoundSummary>,
}

/// One bound at one noise, the root of its mean over the trials; null for what it does not speak of or where it does not
/// exist.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct SnapshotBoundSummary {
    /// Trials in which the bound exists.
    pub trials: usize,
    /// Least `RMSE(Q)`.
    pub orientation: Option<Estimate>,
    /// Least root mean square rotation angle, rad.
    pub angle: Option<Estimate>,
    /// Least `RMSE(t)`, m.
    pub position: Option<Estimate>,
    /// Least `RMSE(S)`, m.
    pub sensors: Option<Estimate>,
}
