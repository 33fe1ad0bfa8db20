//! Which estimators of relative kinematics run, and the choices they share.

use alloc::string::ToString;
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::error::{Error, Problem};
use crate::model::document::check::Check;
use crate::model::document::read_part;

/// Highest degree of a motion.
pub const MAX_DEGREE: usize = 8;

/// The estimators by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum KinematicsName {
    /// \[A\] Algorithm 1 with the divisions of eq. 18 as printed.
    #[serde(rename = "algorithm-1-literal")]
    Algorithm1Literal,
    /// Algorithm 1, the products of eq. 18 read as a matrix of rank one.
    #[serde(rename = "algorithm-1-rank1")]
    Algorithm1Rank1,
    /// Algorithm 1, least squares over O(D).
    #[serde(rename = "algorithm-1-so")]
    Algorithm1So,
    /// Algorithm 1, linear in `(H, H Omega_2, Omega)`, then projected.
    #[serde(rename = "algorithm-1-lifted")]
    Algorithm1Lifted,
    /// \[A\] Algorithm 2, with accelerometers, and the divisions as printed.
    #[serde(rename = "algorithm-2-literal")]
    Algorithm2Literal,
    /// Algorithm 2 with the matrix of rank one.
    #[serde(rename = "algorithm-2-rank1")]
    Algorithm2Rank1,
    /// Algorithm 2, least squares over O(D).
    #[serde(rename = "algorithm-2-so")]
    Algorithm2So,
    /// Algorithm 2, linear, then projected.
    #[serde(rename = "algorithm-2-lifted")]
    Algorithm2Lifted,
    /// Snapshots of the fitted Gram matrix, brought into one frame by the motion being a polynomial.
    SnapshotSync,
    /// Maximum likelihood from distances, each pair compressed to its polynomial.
    MaximumLikelihood,
    /// Maximum likelihood from every single distance.
    MaximumLikelihoodFull,
    /// Maximum likelihood from distances and accelerations, each pair compressed.
    MaximumLikelihoodAccelerometers,
    /// Maximum likelihood from every single distance and acceleration.
    MaximumLikelihoodAccelerometersFull,
    /// Classical multidimensional scaling of each epoch alone.
    MultidimensionalScaling,
    /// A polynomial for the range of each pair, \[A\] ref. 10.
    RangePolynomial,
}

impl KinematicsName {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 15] = [
        Self::Algorithm1Literal,
        Self::Algorithm1Rank1,
        Self::Algorithm1So,
        Self::Algorithm1Lifted,
        Self::Algorithm2Literal,
        Self::Algorithm2Rank1,
        Self::Algorithm2So,
        Self::Algorithm2Lifted,
        Self::SnapshotSync,
        Self::MaximumLikelihood,
        Self::MaximumLikelihoodFull,
        Self::MaximumLikelihoodAccelerometers,
        Self::MaximumLikelihoodAccelerometersFull,
        Self::MultidimensionalScaling,
        Self::RangePolynomial,
    ];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Algorithm1Literal => "algorithm-1-literal",
            Self::Algorithm1Rank1 => "algorithm-1-rank1",
            Self::Algorithm1So => "algorithm-1-so",
            Self::Algorithm1Lifted => "algorithm-1-lifted",
            Self::Algorithm2Literal => "algorithm-2-literal",
            Self::Algorithm2Rank1 => "algorithm-2-rank1",
            Self::Algorithm2So => "algorithm-2-so",
            Self::Algorithm2Lifted => "algorithm-2-lifted",
            Self::SnapshotSync => "snapshot-sync",
            Self::MaximumLikelihood => "maximum-likelihood",
            Self::MaximumLikelihoodFull => "maximum-likelihood-full",
            Self::MaximumLikelihoodAccelerometers => "maximum-likelihood-accelerometers",
            Self::MaximumLikelihoodAccelerometersFull => "maximum-likelihood-accelerometers-full",
            Self::MultidimensionalScaling => "multidimensional-scaling",
            Self::RangePolynomial => "range-polynomial",
        }
    }

    /// The name as people read it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Algorithm1Literal => "Algorithm 1, as printed",
            Self::Algorithm1Rank1 => "Algorithm 1, rank one",
            Self::Algorithm1So => "Algorithm 1, O(D)",
            Self::Algorithm1Lifted => "Algorithm 1, lifted",
            Self::Algorithm2Literal => "Algorithm 2, as printed",
            Self::Algorithm2Rank1 => "Algorithm 2, rank one",
            Self::Algorithm2So => "Algorithm 2, O(D)",
            Self::Algorithm2Lifted => "Algorithm 2, lifted",
            Self::SnapshotSync => "Snapshot synchronization",
            Self::MaximumLikelihood => "ML, distances",
            Self::MaximumLikelihoodFull => "ML, every distance",
            Self::MaximumLikelihoodAccelerometers => "ML, distances and accelerations",
            Self::MaximumLikelihoodAccelerometersFull => "ML, every distance and acceleration",
            Self::MultidimensionalScaling => "MDS of each epoch",
            Self::RangePolynomial => "Polynomial of each range",
        }
    }

    /// Whether it reads the accelerations of a record.
    pub fn reads_accelerations(self) -> bool {
        matches!(
            self,
            Self::Algorithm2Literal
                | Self::Algorithm2Rank1
                | Self::Algorithm2So
                | Self::Algorithm2Lifted
                | Self::MaximumLikelihoodAccelerometers
                | Self::MaximumLikelihoodAccelerometersFull
        )
    }
}

impl fmt::Display for KinematicsName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for KinematicsName {
    type Err = Error;

    /// Reads [`KinematicsName::name`].
    fn from_str(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|each| each.name() == name).ok_or_else(|| Error::UnknownName {
            what: "estimator of relative kinematics",
            name: name.to_string(),
            known: Self::ALL.map(Self::name).join(", "),
        })
    }
}

/// What the estimators run with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct KinematicsSettings {
    /// Which ones run.
    pub enabled: Vec<KinematicsName>,
    /// The degree L of the motion that they assume.
    pub degree: usize,
    /// The degree q of each range in [`KinematicsName::RangePolynomial`].
    pub range_degree: usize,
}

impl Default for KinematicsSettings {
    fn default() -> Self {
        Self {
            enabled: Vec::from([
                KinematicsName::Algorithm1Rank1,
                KinematicsName::Algorithm2Rank1,
                KinematicsName::SnapshotSync,
                KinematicsName::MaximumLikelihood,
                KinematicsName::MaximumLikelihoodAccelerometers,
            ]),
            degree: 2,
            range_degree: 4,
        }
    }
}

impl KinematicsSettings {
    /// Reads settings on their own, fills in defaults, and refuses them with every problem.
    ///
    /// # Errors
    /// [`Error::Syntax`] with line and column, [`Error::Invalid`] with every problem.
    ///
    /// ```
    /// use rangelab::model::kinematics::settings::KinematicsSettings;
    /// assert_eq!(KinematicsSettings::from_json(r#"{"degree": 3}"#)?.range_degree, 4);
    /// assert!(KinematicsSettings::from_json(r#"{"degree": 9}"#).is_err());
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, Error> {
        read_part("settings of relative kinematics", text, Self::validate)
    }

    /// Every problem: path, value, limit.
    pub fn validate(&self) -> Vec<Problem> {
        let mut check = Check::default();
        self.check(&mut check, "");
        check.into_problems()
    }

    pub(super) fn check(&self, check: &mut Check, prefix: &str) {
        let mut seen = self.enabled.clone();
        seen.sort();
        seen.dedup();
        if seen.len() != self.enabled.len() {
            let value = "with the same estimator twice";
            check.problem(format_args!("{prefix}enabled"), value, "each estimator at most once");
        }
        if self.degree > MAX_DEGREE {
            check.problem(format_args!("{prefix}degree"), self.degree, format_args!("0 to {MAX_DEGREE}"));
        }
        let most = 2 * MAX_DEGREE;
        if !(2..=most).contains(&self.range_degree) {
            let limit = format_args!("2 to {most}");
            check.problem(format_args!("{prefix}range_degree"), self.range_degree, limit);
        }
    }
}
