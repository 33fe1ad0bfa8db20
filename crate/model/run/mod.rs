//! Run: all that estimators did with a recording, as one JSON document. Every door reads it.

mod csv;
mod geometry;

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

pub use geometry::{Flat, Geometry, PointCloud};

use super::document::entries::PoseEntries;
use super::document::{parse, write};
use super::estimator_settings::{EstimatorName, EstimatorSettings};
use crate::error::Result;

/// What the estimators and bounds made of one recording.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// Version of the format, 1.
    pub version: u32,
    /// Name of the scenario or recording.
    pub name: String,
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// The anchors that were used (the drawn ones where a scenario redraws them), m.
    pub anchors: Vec<Vec<f64>>,
    /// The sensors in the body frame, m.
    pub sensors: Vec<Vec<f64>>,
    /// How anchors and sensors lie, and what that hides.
    pub geometry: Geometry,
    /// Time of each epoch since the start, s.
    pub times: Vec<f64>,
    /// For each epoch the pairs (anchor, sensor) whose range is missing.
    pub missing: Vec<Vec<(usize, usize)>>,
    /// The true pose at each epoch, null where it is not known.
    pub truth: Vec<Option<PoseEntries>>,
    /// The choices that the estimators share.
    pub settings: EstimatorSettings,
    /// One entry an estimator, in the order of the settings.
    pub estimators: Vec<EstimatorRun>,
    /// One entry a bound; empty where the truth is not known.
    pub bounds: Vec<BoundRun>,
}

/// One estimator's part of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct EstimatorRun {
    /// Its name in files.
    pub name: EstimatorName,
    /// Its name for people.
    pub label: String,
    /// The steps up to the end, or up to the failure.
    pub steps: Vec<StepRecord>,
    /// Why it stopped early.
    pub failure: Option<Failure>,
}

/// One step of one estimator.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct StepRecord {
    /// Time since the start, s.
    pub time: f64,
    /// `[Q | t]` predicted.
    pub prior: PoseEntries,
    /// Innovation in information form, `H^T Sigma^-1 (d - h(prior))`, in the shape of `[Q | t]`.
    pub innovation: PoseEntries,
    /// `[Q | t]` as reported.
    pub posterior: PoseEntries,
    /// Traces of the covariance reported.
    pub covariance_trace: CovarianceTrace,
    /// Covariance of the position row by row, m^2.
    pub position_covariance: Vec<Vec<f64>>,
    /// Covariance of the error's rotation vector in the world frame row by row, rad^2 (1 x 1 in the plane); null where
    /// the estimator's covariance cannot be inverted.
    pub rotation_covariance: Option<Vec<Vec<f64>>>,
    /// `||Q^T Q - I||_F` before any projection.
    pub defect: f64,
    /// True if `Q` was projected.
    pub event: bool,
    /// Normalized innovation squared.
    pub nis: ConsistencyRecord,
    /// Errors, where the truth is known.
    pub errors: Option<PoseErrors>,
    /// Normalized estimation error squared, where the truth is known.
    pub nees: Option<ConsistencyRecord>,
}

/// Traces of a covariance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct CovarianceTrace {
    /// Over the entries of `Q`; a covariance of rotation angles counts twice, `||R hat(phi)||_F^2 = 2 ||phi||^2`.
    pub orientation: f64,
    /// Over the position, m^2.
    pub position: f64,
}

/// A statistic that is chi-square distributed where the estimator is consistent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct ConsistencyRecord {
    /// The quadratic form.
    pub value: f64,
    /// Its degrees of freedom, which is also its mean.
    pub degrees_of_freedom: usize,
}

/// Errors of a reported pose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct PoseErrors {
    /// `||Q - Q_true||_F` of the matrix as reported.
    pub orientation_frobenius: f64,
    /// Geodesic angle between the rotation nearest to `Q` and the true one, rad.
    pub angle: f64,
    /// `||t - t_true||`, m.
    pub position: f64,
}

/// Why an estimator stopped.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct Failure {
    /// The step that failed, from 0.
    pub step: usize,
    /// The reason in a sentence.
    pub message: String,
}

/// A lower bound on the error along the track.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct BoundRun {
    /// Its name in files.
    pub name: String,
    /// Its name for people.
    pub label: String,
    /// One entry an epoch; null where the bound does not exist (a motion that is not seen) or the truth is not known.
    pub steps: Vec<Option<BoundRecord>>,
    /// The first step at which it does not exist, and why.
    pub failure: Option<Failure>,
}

/// One step of one bound: variances, not their roots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct BoundRecord {
    /// Least mean squared `||Q - Q_true||_F`.
    pub orientation_trace: f64,
    /// Least mean squared rotation angle, rad^2; for a bound on any matrix `Q` that of the rotation nearest to it.
    pub angle_variance: Option<f64>,
    /// Least mean squared `||t - t_true||`, m^2.
    pub position_trace: f64,
    /// Bound on the covariance of the position row by row, m^2.
    pub position_covariance: Vec<Vec<f64>>,
    /// Bound on the covariance of the error's rotation vector in the world frame row by row, rad^2 (1 x 1 in the plane).
    pub rotation_covariance: Option<Vec<Vec<f64>>>,
}

impl Run {
    /// Reads a run.
    ///
    /// # Errors
    /// [`crate::Error::Syntax`] with line and column, [`crate::Error::Version`] for a newer format.
    pub fn from_json(text: &str) -> Result<Self> {
        parse("run", text)
    }

    /// The run as JSON; every number comes back as the same bits.
    pub fn to_json(&self) -> String {
        write(self)
    }

    /// The run as a table: a row for each estimator and step, units in the names of the columns.
    pub fn to_csv(&self) -> String {
        csv::table(self)
    }
}
