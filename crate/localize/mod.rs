//! Floor 2: the pose from the ranges of one epoch alone, without a past.
//!
//! | estimator | of | by |
//! |---|---|---|
//! | [`least_squares::classical`] | each sensor by itself | a linear system each |
//! | [`least_squares::least_squares`] | any matrix `[Q \| t]` | a linear system |
//! | [`simplified::simplified`], [`simplified::weighted`] | a pose | one singular value decomposition |
//! | [`optimal::optimal`] | a pose, the least cost of the linear model | Newton on the Stiefel manifold |
//! | [`maximum_likelihood::maximum_likelihood`] | a pose, the ranges themselves | Levenberg and Marquardt |
//!
//! All but the last read the same small object, a [`Snapshot`]: `R` and `B` of the ranges. Total least squares are the same
//! estimators on other weights ([`Snapshot::reduced`]).

mod certificate;
pub mod least_squares;
pub mod maximum_likelihood;
pub mod optimal;
mod range_fit;
pub mod reduced;
pub mod simplified;
pub mod snapshot;
mod start;

use alloc::vec::Vec;

use nalgebra::SVector;

use crate::error::{Error, Result};
use crate::math::pose::Theta;
use crate::math::rotation::determinant;
use crate::model::localize_settings::{LocalizeSettings, LocalizerName};
use crate::model::topology::Topology;
pub use snapshot::Snapshot;

/// The mounting errors that the printed OUC-TLS assumes, m: `Lambda = Abar Abar^T + I` whitens the ranges but not the
/// topology (\[L\] eq. 34; the spelled-out form has `sigma_e^2` before `Abar Abar^T`).
pub const PRINTED_TLS_SIGMA: f64 = 1.0;

/// What is known of an optimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Optimum {
    /// The estimator is a formula: there is no other.
    Formula,
    /// A dual certificate proves that no orthogonal matrix costs less.
    Certified,
    /// No other start led to a lower cost.
    Searched,
    /// Nothing is known: where one start led.
    Local,
}

impl Optimum {
    /// The name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Formula => "formula",
            Self::Certified => "certified",
            Self::Searched => "searched",
            Self::Local => "local",
        }
    }
}

/// The answer of a snapshot estimator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate<const D: usize> {
    /// `[Q | t]`; `None` for the classical LS, which sees sensors and no body. `Q` is any matrix for the LS.
    pub theta: Option<Theta<D>>,
    /// Iterations until the estimator's stopping rule held; those of the polish behind it are not counted.
    pub iterations: usize,
    /// The orientation mirrors the body, `det Q < 0`.
    pub reflected: bool,
    /// What is known of the optimum.
    pub optimum: Optimum,
}

impl<const D: usize> Estimate<D> {
    fn new(theta: Theta<D>, iterations: usize, optimum: Optimum) -> Self {
        let reflected = determinant(&theta.orientation) < 0.0;
        Self { theta: Some(theta), iterations, reflected, optimum }
    }

    /// Topology-aware localization, `S = Q C + t 1^T` (\[L\] eq. 26); `None` where there is no body.
    pub fn sensor_positions(&self, topology: &Topology<D>) -> Option<Vec<SVector<f64, D>>> {
        let Theta { orientation, position } = self.theta?;
        Some(topology.sensors().iter().map(|c| orientation * c + position).collect())
    }
}

/// Runs an estimator on a snapshot. `mounting_sigma` is the standard deviation of the mounting errors, m, which the OUC-TLS
/// assumes unless the settings say another.
///
/// ```
/// use rangelab::localize::{Snapshot, localize};
/// use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName};
/// use rangelab::model::presets::preset;
/// use rangelab::simulate::simulate;
/// let recording = simulate::<3>(&preset("room")?, 0)?;
/// let epoch = &recording.epochs[0];
/// let snapshot = Snapshot::new(&recording.model, &epoch.ranges, epoch.weight_ranges())?;
/// let estimate = localize(LocalizerName::OucLs, &snapshot, &LocalizeSettings::default(), 0.0)?;
/// let truth = recording.truth[0].unwrap();
/// assert!((estimate.theta.unwrap().position - truth.position).norm() < 0.05);
/// # Ok::<(), rangelab::Error>(())
/// ```
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause, [`crate::Error::NoConvergence`].
pub fn localize<const D: usize>(
    name: LocalizerName,
    snapshot: &Snapshot<D>,
    settings: &LocalizeSettings,
    mounting_sigma: f64,
) -> Result<Estimate<D>> {
    let manifold = settings.manifold;
    let total = |sigma: f64| optimal::optimal(snapshot, sigma, manifold, settings.multi_start);
    let found = match name {
        LocalizerName::ClassicalLs => least_squares::classical(snapshot),
        LocalizerName::Ls => least_squares::least_squares(snapshot),
        LocalizerName::SucLs | LocalizerName::SucTls => simplified::simplified(snapshot, manifold),
        LocalizerName::SucLsWeighted => simplified::weighted(snapshot, manifold),
        LocalizerName::OucLs => total(0.0),
        LocalizerName::OucTlsPrinted => total(PRINTED_TLS_SIGMA),
        LocalizerName::OucTls => total(settings.tls_sigma.unwrap_or(mounting_sigma)),
        LocalizerName::GaussNewton => maximum_likelihood::gauss_newton(snapshot),
        LocalizerName::MaximumLikelihood => maximum_likelihood::maximum_likelihood(snapshot, settings.loss),
    };
    // An estimator that starts from another one fails under its own name.
    found.map_err(|error| match error {
        Error::Unobservable { ranges, reason, .. } => {
            Error::Unobservable { what: name.label(), ranges, reason }
        }
        other => other,
    })
}
