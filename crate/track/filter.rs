//! What all trackers share: one trait, one record of a step.

use nalgebra::SMatrix;

use crate::error::{Error, Result};
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::{AngleMatrix, Manifold, Rotation};
use crate::math::tangent::{TangentMatrix, join, tangent_dimension};
use crate::model::covariance::Covariance;
use crate::model::epoch::Epoch;

/// A recursive estimator of position and orientation.
pub trait Estimator<const D: usize> {
    /// Predicts over the epoch's interval, then updates with its ranges.
    ///
    /// # Errors
    /// A typed error when the epoch does not fit the model or the arithmetic leaves double precision; the estimator
    /// keeps its state from before the step.
    fn step(&mut self, epoch: &Epoch<D>) -> Result<Step<D>>;
}

/// Everything that happened in one step, so that it can be shown again without running it again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<const D: usize> {
    /// `[Q | t]` predicted.
    pub prior: Theta<D>,
    /// Innovation in information form, `H^T Sigma^-1 (d - h(prior))`, in the shape of `[Q | t]`.
    pub innovation: Theta<D>,
    /// Normalized innovation squared.
    pub nis: Consistency,
    /// `[Q | t]` after the update, before any projection.
    pub unprojected: Theta<D>,
    /// `[Q | t]` as reported.
    pub posterior: Theta<D>,
    /// What the estimator believes about its error.
    pub uncertainty: Uncertainty<D>,
    /// `||Q^T Q - I||_F` before any projection.
    pub defect: f64,
    /// True if `Q` was projected in this step.
    pub event: bool,
}

/// A statistic that is chi-square distributed where the estimator is consistent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Consistency {
    /// The quadratic form.
    pub value: f64,
    /// Its degrees of freedom, which is also its mean.
    pub degrees_of_freedom: usize,
}

/// The covariance an estimator reports, and what it is a covariance of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Uncertainty<const D: usize> {
    /// Of all entries of `[Q | t]` (\[T\] eq. 22).
    Linear(Covariance<D>),
    /// The same matrix kept by an estimator that stays on the manifold: too large as it stands (\[T\] end of Sec. IV-B),
    /// right when restricted to the tangent space, `(T^T P^-1 T)^-1`.
    Constrained(Covariance<D>),
    /// Of the tangent coordinates `(phi, t)`, rotation perturbed on the right.
    Tangent(TangentMatrix<D>),
}

impl<const D: usize> Uncertainty<D> {
    /// Trace of the covariance of `vec(Q)`; a tangent covariance is carried to `Q` by `||R hat(phi)||_F^2 = 2 ||phi||^2`.
    pub fn orientation_trace(&self) -> f64 {
        match self {
            Self::Linear(p) | Self::Constrained(p) => p.orientation_trace(),
            Self::Tangent(p) => 2.0 * p.angle_trace(),
        }
    }

    /// Covariance of the position, m^2.
    pub fn position_block(&self) -> SMatrix<f64, D, D> {
        match self {
            Self::Linear(p) | Self::Constrained(p) => p.position_block(),
            Self::Tangent(p) => p.shift_block(),
        }
    }
}

impl<const D: usize> Step<D> {
    /// The orientation reported, as a rotation: the polar factor over SO(D) where it is not one already.
    pub fn rotation(&self) -> Rotation<D> {
        Rotation::project(&self.posterior.orientation, Manifold::So)
    }

    /// The pose reported.
    pub fn pose(&self) -> Pose<D> {
        Pose { rotation: self.rotation(), position: self.posterior.position }
    }

    /// Covariance of the error's rotation vector in the world frame, rad^2, as the estimator believes it:
    /// `R_true = exp(hat(phi)) R` with `R` the rotation reported. To first order, so meaningful well below 1 rad.
    ///
    /// For a linear estimator it is the tangential part of the covariance of `vec(Q)` at `R`; for one that stays on the
    /// manifold that of `(T^T P^-1 T)^-1`, the covariance its NEES is taken with; for the error-state filter the block
    /// of its state.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] when the covariance cannot be inverted.
    pub fn rotation_covariance(&self) -> Result<AngleMatrix> {
        let rotation = self.rotation();
        let tangent = match &self.uncertainty {
            Uncertainty::Linear(p) => TangentMatrix::of_nearest_pose(&p.to_blocks(), &rotation),
            Uncertainty::Constrained(p) => {
                let precision = p.precision().map_err(not_positive)?;
                TangentMatrix::restrict(&precision, &rotation).inverse().map_err(not_positive)?
            }
            Uncertainty::Tangent(p) => *p,
        };
        Ok(tangent.rotation_block_in_world(&rotation))
    }

    /// Normalized estimation error squared against the true pose: on `[Q | t]` (D(D+1) degrees of freedom) for a linear
    /// estimator, on the tangent space (D(D-1)/2 + D) for one that stays on the manifold.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] when the covariance cannot be inverted.
    pub fn nees(&self, truth: &Pose<D>) -> Result<Consistency> {
        match &self.uncertainty {
            Uncertainty::Linear(p) => {
                let error = self.posterior.minus(&Theta::from(*truth));
                let value = p.inverse_quadratic_form(&error).map_err(not_positive)?;
                Ok(Consistency { value, degrees_of_freedom: D * (D + 1) })
            }
            Uncertainty::Constrained(p) => {
                let precision = p.precision().map_err(not_positive)?;
                Ok(self.tangent_nees(truth, &TangentMatrix::restrict(&precision, &self.rotation())))
            }
            Uncertainty::Tangent(p) => Ok(self.tangent_nees(truth, &p.inverse().map_err(not_positive)?)),
        }
    }

    fn tangent_nees(&self, truth: &Pose<D>, precision: &TangentMatrix<D>) -> Consistency {
        let (phi, shift) = self.pose().local(truth);
        Consistency {
            value: precision.quadratic_form(&join(&phi, &shift)),
            degrees_of_freedom: tangent_dimension(D),
        }
    }
}

/// Ranges may all be missing: then nothing after the prediction would notice.
pub(super) fn require_finite<const D: usize>(prior: &Theta<D>) -> Result<()> {
    match prior.orientation.iter().chain(prior.position.iter()).find(|x| !x.is_finite()) {
        Some(&value) => Err(Error::Number {
            what: "an entry of the predicted [Q | t]",
            value,
            limit: "finite: so must be the pose before, the velocities and the interval",
        }),
        None => Ok(()),
    }
}

pub(super) fn not_positive(pivot: f64) -> Error {
    Error::NotPositiveDefinite { what: "the covariance of an estimate", pivot }
}
