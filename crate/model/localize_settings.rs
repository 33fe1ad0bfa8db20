//! Which estimators find the pose from one epoch alone, and the choices they share.

use alloc::string::ToString;
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

use serde::{Deserialize, Serialize};

use super::document::check::{Check, Limit};
use crate::error::Error;
use crate::math::rotation::Manifold;

/// The snapshot estimators by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum LocalizerName {
    /// Each sensor by itself; the body is not used, and there is no orientation (\[L\] eq. 8).
    ClassicalLs,
    /// Least squares on any matrix `[Q | t]` (\[L\] eq. 14).
    Ls,
    /// Simplified unitarily constrained least squares: the classical positions fitted by a rotation (\[L\] eq. 20).
    SucLs,
    /// The LS matrix fitted by a rotation, its rows weighted by what the anchors see of them; exact for a body of equal
    /// moments.
    SucLsWeighted,
    /// Optimal unitarily constrained least squares by Newton's method (\[L\] eq. 22, Algorithm 1).
    OucLs,
    /// Simplified unitarily constrained total least squares; the SUC-LS (\[L\] Theorem 2).
    SucTls,
    /// Optimal unitarily constrained total least squares as printed, for mounting errors of 1 m (\[L\] eq. 34).
    OucTlsPrinted,
    /// The same for the mounting errors that there are.
    OucTls,
    /// One Gauss-Newton step from the SUC-LS on the ranges themselves.
    GaussNewton,
    /// Maximum likelihood on the ranges themselves, by Levenberg and Marquardt's method.
    MaximumLikelihood,
}

impl LocalizerName {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 10] = [
        Self::ClassicalLs,
        Self::Ls,
        Self::SucLs,
        Self::SucLsWeighted,
        Self::OucLs,
        Self::SucTls,
        Self::OucTlsPrinted,
        Self::OucTls,
        Self::GaussNewton,
        Self::MaximumLikelihood,
    ];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::ClassicalLs => "classical-ls",
            Self::Ls => "ls",
            Self::SucLs => "suc-ls",
            Self::SucLsWeighted => "suc-ls-weighted",
            Self::OucLs => "ouc-ls",
            Self::SucTls => "suc-tls",
            Self::OucTlsPrinted => "ouc-tls-printed",
            Self::OucTls => "ouc-tls",
            Self::GaussNewton => "gauss-newton",
            Self::MaximumLikelihood => "maximum-likelihood",
        }
    }

    /// The name as people read it.
    pub fn label(self) -> &'static str {
        match self {
            Self::ClassicalLs => "classical LS",
            Self::Ls => "LS",
            Self::SucLs => "SUC-LS",
            Self::SucLsWeighted => "weighted SUC-LS",
            Self::OucLs => "OUC-LS",
            Self::SucTls => "SUC-TLS",
            Self::OucTlsPrinted => "OUC-TLS as printed",
            Self::OucTls => "OUC-TLS",
            Self::GaussNewton => "Gauss-Newton step",
            Self::MaximumLikelihood => "ML",
        }
    }
}

impl fmt::Display for LocalizerName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for LocalizerName {
    type Err = Error;

    /// Reads [`LocalizerName::name`].
    ///
    /// ```
    /// use rangelab::model::localize_settings::LocalizerName;
    /// assert_eq!("ouc-ls".parse(), Ok(LocalizerName::OucLs));
    /// assert!("oucls".parse::<LocalizerName>().unwrap_err().to_string().contains("classical-ls, ls, suc-ls"));
    /// ```
    fn from_str(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|each| each.name() == name).ok_or_else(|| Error::UnknownName {
            what: "localizer",
            name: name.to_string(),
            known: Self::ALL.map(Self::name).join(", "),
        })
    }
}

/// What a residual of maximum likelihood costs, in standard deviations of its range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Loss {
    /// Its square: right for normal noise.
    #[default]
    Squared,
    /// Huber's: its square up to `scale`, linear beyond, so that one wrong range cannot pull the pose far.
    Huber {
        /// Where it turns linear, in standard deviations; 1.345 costs 5 % where there are no wrong ranges.
        scale: f64,
    },
}

/// Which snapshot estimators run, and the choices they share.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct LocalizeSettings {
    /// The estimators that run, each at most once.
    pub enabled: Vec<LocalizerName>,
    /// Rotations, or the papers' orthogonal matrices, reflections included. Maximum likelihood always takes rotations.
    pub manifold: Manifold,
    /// Standard deviation of the mounting errors that the OUC-TLS assumes, m; null: those of the scenario.
    pub tls_sigma: Option<f64>,
    /// What a residual of maximum likelihood costs.
    pub loss: Loss,
    /// True: an optimum that cannot be certified is searched for from 24 more starts.
    pub multi_start: bool,
}

impl Default for LocalizeSettings {
    /// All estimators over SO(D), squared loss, from the paper's start alone.
    fn default() -> Self {
        Self {
            enabled: LocalizerName::ALL.to_vec(),
            manifold: Manifold::default(),
            tls_sigma: None,
            loss: Loss::default(),
            multi_start: false,
        }
    }
}

impl LocalizeSettings {
    pub(super) fn check(&self, check: &mut Check) {
        for (i, name) in self.enabled.iter().enumerate() {
            if self.enabled[..i].contains(name) {
                check.problem(format_args!("localize.enabled[{i}]"), name, "each localizer at most once");
            }
        }
        if let Some(sigma) = self.tls_sigma {
            check.number("localize.tls_sigma", sigma, Limit::POSITION_NOISE);
        }
        if let Loss::Huber { scale } = self.loss {
            check.number("localize.loss.scale", scale, Limit::HUBER_SCALE);
        }
    }
}
