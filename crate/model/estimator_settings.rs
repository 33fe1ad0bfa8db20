//! Which estimators run, and the choices they share.

use alloc::string::ToString;
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

use serde::{Deserialize, Serialize};

use super::document::check::{Check, Limit};
use super::document::read_part;
use crate::error::{Error, Problem};
use crate::math::rotation::Manifold;

/// The trackers by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum EstimatorName {
    /// Unconstrained Kalman filter on `[Q | t]` (\[T\] Sec. IV-A).
    Kf,
    /// The Kalman filter, `Q` projected after every update (\[T\] Sec. IV-C with threshold 0).
    Ortho,
    /// Unitarily constrained Kalman filter (\[T\] Sec. IV-B).
    UcKf,
    /// The Kalman filter, `Q` projected only where its defect exceeds a threshold (\[T\] Sec. IV-C).
    EtKf,
    /// Error-state Kalman filter on SO(D) x R^D, `||s||^2` projected out of the squared ranges.
    Eskf,
    /// Error-state Kalman filter on the squared ranges as they are.
    EskfRaw,
}

impl EstimatorName {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 6] = [Self::Kf, Self::Ortho, Self::UcKf, Self::EtKf, Self::Eskf, Self::EskfRaw];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kf => "kf",
            Self::Ortho => "ortho",
            Self::UcKf => "uc-kf",
            Self::EtKf => "et-kf",
            Self::Eskf => "eskf",
            Self::EskfRaw => "eskf-raw",
        }
    }

    /// The name as people read it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Kf => "KF",
            Self::Ortho => "KF-ortho",
            Self::UcKf => "UC-KF",
            Self::EtKf => "ET-KF",
            Self::Eskf => "ESKF",
            Self::EskfRaw => "ESKF raw",
        }
    }
}

impl fmt::Display for EstimatorName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for EstimatorName {
    type Err = Error;

    /// Reads [`EstimatorName::name`].
    ///
    /// ```
    /// use rangelab::model::estimator_settings::EstimatorName;
    /// assert_eq!("uc-kf".parse(), Ok(EstimatorName::UcKf));
    /// let error = "ukf".parse::<EstimatorName>().unwrap_err().to_string();
    /// assert_eq!(error, "no estimator is called \"ukf\"; there are: kf, ortho, uc-kf, et-kf, eskf, eskf-raw");
    /// ```
    fn from_str(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|each| each.name() == name).ok_or_else(|| Error::UnknownName {
            what: "estimator",
            name: name.to_string(),
            known: Self::ALL.map(Self::name).join(", "),
        })
    }
}

/// In which metric "nearest" is meant when `Q` is projected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Metric {
    /// The identity: the polar factor (\[T\] eq. 28).
    #[default]
    Frobenius,
    /// `P_q^-1`: badly seen entries of `Q` give way to well seen ones, as in the UC-KF (\[T\] eq. 23).
    Information,
}

/// What the trigger of the ET-KF compares the defect `||Q^T Q - I||_F` with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum ThresholdKind {
    /// `epsilon` itself (\[T\] Sec. IV-C).
    #[default]
    Absolute,
    /// `epsilon sqrt(tr P_q)`: the trigger keeps acting while the filter settles.
    Relative,
}

/// Threshold of the event trigger.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct Threshold {
    /// What `epsilon` multiplies.
    pub kind: ThresholdKind,
    /// `epsilon`; 0 projects always.
    pub epsilon: f64,
}

impl Default for Threshold {
    /// The paper's, `epsilon = 0.15` (\[T\] Sec. V).
    fn default() -> Self {
        Self { kind: ThresholdKind::Absolute, epsilon: 0.15 }
    }
}

/// Which estimators run, and the choices they share.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct EstimatorSettings {
    /// The estimators that run, each at most once.
    pub enabled: Vec<EstimatorName>,
    /// What `Q` is projected onto.
    pub manifold: Manifold,
    /// The metric of the projection in KF-ortho and ET-KF; the UC-KF always takes `P_q^-1`.
    pub metric: Metric,
    /// True: KF-ortho and ET-KF go on from the projected `Q`; false: they only report it.
    pub feedback: bool,
    /// The trigger of the ET-KF.
    pub threshold: Threshold,
    /// True: the UC-KF solves for `Q` and then for `t` (\[T\] eq. 26-27); false: jointly (eq. 23).
    pub decoupled: bool,
}

impl Default for EstimatorSettings {
    /// All estimators, on SO(D), output projected and not fed back.
    fn default() -> Self {
        Self {
            enabled: EstimatorName::ALL.to_vec(),
            manifold: Manifold::default(),
            metric: Metric::default(),
            feedback: false,
            threshold: Threshold::default(),
            decoupled: false,
        }
    }
}

impl EstimatorSettings {
    /// Reads and validates the settings alone, for estimators that run on a recording.
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, [`Error::Invalid`] with every problem.
    ///
    /// ```
    /// use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
    /// let settings = EstimatorSettings::from_json(r#"{"enabled": ["kf", "uc-kf"], "feedback": true}"#)?;
    /// assert_eq!(settings.enabled, [EstimatorName::Kf, EstimatorName::UcKf]);
    /// assert!(EstimatorSettings::from_json(r#"{"threshold": {"kind": "relative", "epsilon": -1}}"#).is_err());
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, Error> {
        read_part("estimator settings", text, Self::validate)
    }

    /// Every problem: path, value, limit.
    pub fn validate(&self) -> Vec<Problem> {
        let mut check = Check::default();
        self.check(&mut check, "");
        check.into_problems()
    }

    pub(super) fn check(&self, check: &mut Check, prefix: &str) {
        for (i, name) in self.enabled.iter().enumerate() {
            if self.enabled[..i].contains(name) {
                check.problem(format_args!("{prefix}enabled[{i}]"), name, "each estimator at most once");
            }
        }
        check.number(format_args!("{prefix}threshold.epsilon"), self.threshold.epsilon, Limit::EPSILON);
    }
}
