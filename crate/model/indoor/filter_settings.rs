//! Which filters of the Indoor lab run, and the choices they share.

use alloc::string::ToString;
use alloc::vec::Vec;
use core::fmt;
use core::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::model::document::check::Check;

/// The filters by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum FilterName {
    /// Extended Kalman filter on `[vec(R); p; v]` as printed: `R` by Euler's rule and never made a rotation again, `g(X)`
    /// taken as a constant in the covariance (\[I\] Sec. IV).
    Ekf,
    /// The same with the derivative of `g(X) u` in the covariance.
    EkfFull,
    /// The EKF as printed, `R` put back onto SO(3) after prediction and update, the covariance left as it is.
    EkfRetraction,
    /// EKFRie, \[I\] Algorithm 1: retraction and transport after prediction and update.
    EkfRie,
    /// Unscented Kalman filter on the same state.
    Ukf,
    /// UKFRie, \[I\] Algorithm 2.
    UkfRie,
    /// Error-state (multiplicative) Kalman filter with exact integration of held inputs.
    Mekf,
    /// Left-invariant EKF on `SE_2(3)` with the same integration.
    LieKf,
    /// The error-state filter on the ranges themselves, without positions of transmitters in between.
    Tight,
}

impl FilterName {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 9] = [
        Self::Ekf,
        Self::EkfFull,
        Self::EkfRetraction,
        Self::EkfRie,
        Self::Ukf,
        Self::UkfRie,
        Self::Mekf,
        Self::LieKf,
        Self::Tight,
    ];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ekf => "ekf",
            Self::EkfFull => "ekf-full",
            Self::EkfRetraction => "ekf-retraction",
            Self::EkfRie => "ekf-rie",
            Self::Ukf => "ukf",
            Self::UkfRie => "ukf-rie",
            Self::Mekf => "mekf",
            Self::LieKf => "lie-kf",
            Self::Tight => "tight",
        }
    }

    /// The name as people read it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Ekf => "EKF",
            Self::EkfFull => "EKF, full Jacobian",
            Self::EkfRetraction => "EKF, retraction only",
            Self::EkfRie => "EKFRie",
            Self::Ukf => "UKF",
            Self::UkfRie => "UKFRie",
            Self::Mekf => "MEKF",
            Self::LieKf => "LIEKF",
            Self::Tight => "MEKF on ranges",
        }
    }
}

impl fmt::Display for FilterName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for FilterName {
    type Err = Error;

    /// Reads [`FilterName::name`].
    fn from_str(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|each| each.name() == name).ok_or_else(|| Error::UnknownName {
            what: "filter",
            name: name.to_string(),
            known: Self::ALL.map(Self::name).join(", "),
        })
    }
}

/// How EKFRie and UKFRie carry the covariance of `vec(R)` from one rotation to the next, `M = I (x) R_new R_old^T`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Transport {
    /// Not at all.
    None,
    /// The block from before the step replaces that of the step, as steps 7 and 16 are printed.
    Literal,
    /// The block of the step is carried, the cross blocks are left behind.
    Block,
    /// The whole covariance is carried, `M P M^T`, which is what \[I\] eq. 17 amounts to for all of `P`. For UKFRie only
    /// after the update: its sigma points have carried it over the motion already.
    #[default]
    Congruence,
}

/// How a step away from a rotation comes back to SO(3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Retraction {
    /// The Q-factor of `R + V` (\[I\] Table II), with the third column turned where it would be a reflection.
    #[default]
    Qr,
    /// The polar factor of `R + V`: the nearest rotation.
    Polar,
    /// `R Exp(xi)`, `xi` the tangential part of `R^T V`.
    Exponential,
}

/// How ranges become positions of the transmitters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum FrontEndKind {
    /// Each transmitter by itself: Gauss-Newton.
    #[default]
    GaussNewton,
    /// All three at once, on the manifold of triangles congruent to the one on the body.
    Isosceles,
}

/// The covariance that filters give to positions of transmitters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum FixCovariance {
    /// `sigma^2 I`, as in the paper.
    #[default]
    Isotropic,
    /// What the geometry gives each transmitter by itself, `sigma^2 (J^T J)^-1`. The corners of a triangle that is fitted as
    /// a whole depend on each other, which this leaves out: their nine coordinates have six degrees of freedom.
    Geometry,
}

/// Which transmitters are ranged, as far as filters on positions of transmitters see.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum TransmitterChoice {
    /// All three.
    #[default]
    All,
    /// The first alone, the corner between the equal sides of the paper's triangle: what averaging over three gains is
    /// the difference. It is never fitted as a triangle.
    First,
}

/// How the sigma points of the UKF are weighted in the noise of its input, `sum_l w_l g(chi_l) Q g(chi_l)^T` (\[I\]
/// Algorithm 2, step 5).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum InputNoiseWeights {
    /// By the weights of the transform, `w_l = xi_l`: the mean of the noise over the points.
    #[default]
    Once,
    /// By their squares, `w_l = xi_l^2`, as printed, with the paper's `alpha = 1e-3`: `xi_0^2 = 8.8e11`.
    Squared,
}

/// Which filters run, and the choices they share.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct FilterSettings {
    /// The filters that run, each at most once.
    pub enabled: Vec<FilterName>,
    /// Of EKFRie and UKFRie.
    pub transport: Transport,
    /// Of EKFRie, UKFRie and the EKF with retraction only.
    pub retraction: Retraction,
    /// True: EKFRie and UKFRie project the correction of `R` onto the tangent space before they retract.
    pub tangent_correction: bool,
    /// Of all filters but the one on the ranges themselves.
    pub front_end: FrontEndKind,
    /// Of the same filters.
    pub fix_covariance: FixCovariance,
    /// Of the same filters.
    pub transmitters: TransmitterChoice,
    /// Of UKF and UKFRie.
    pub input_noise_weights: InputNoiseWeights,
}

impl Default for FilterSettings {
    /// All filters, with the paper's choices and the transport that keeps the covariance positive definite.
    fn default() -> Self {
        Self {
            enabled: FilterName::ALL.to_vec(),
            transport: Transport::default(),
            retraction: Retraction::default(),
            tangent_correction: false,
            front_end: FrontEndKind::default(),
            fix_covariance: FixCovariance::default(),
            transmitters: TransmitterChoice::default(),
            input_noise_weights: InputNoiseWeights::default(),
        }
    }
}

impl FilterSettings {
    pub(super) fn check(&self, check: &mut Check) {
        for (i, name) in self.enabled.iter().enumerate() {
            if self.enabled[..i].contains(name) {
                check.problem(format_args!("filters.enabled[{i}]"), name, "each filter at most once");
            }
        }
    }
}
