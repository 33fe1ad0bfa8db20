//! The recursive bound on the pose with all ranges up to now: the posterior Cramér-Rao bound on SO(D) x R^D.

use super::fisher::FisherInformation;
use crate::error::{Error, Result};
use crate::math::tangent::TangentMatrix;
use crate::model::motion::ProcessNoise;

/// The intrinsic posterior Cramér-Rao bound along one true trajectory, on the tangent coordinates `(phi, t)`, rad and m:
///
/// `J_k = (J_{k-1}^-1 + M)^-1 + T_k^T F_k T_k`.
///
/// It is Tichavsky's recursion in coordinates where the motion is the identity: the rotation error is perturbed on the
/// right and the motion multiplies on the left, so `F_Q R exp(hat(phi)) = (F_Q R) exp(hat(phi))` does not turn it.
/// Along the true trajectory there is nothing to average over; a bound on the RMSE over many trajectories is the root
/// of the mean of its traces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PosteriorBound<const D: usize> {
    covariance: TangentMatrix<D>,
}

impl<const D: usize> PosteriorBound<D> {
    /// Starts from the prior of the filters, variance `c` on each entry of `[Q | t]`, restricted to the tangent space:
    /// `c/2` rad^2 for each angle, since each moves `vec(Q)` by `||R hat(e_i)||_F = sqrt 2`, and `c` m^2 for each
    /// coordinate.
    pub fn new(variance: f64) -> Self {
        let mut covariance = TangentMatrix::zeros();
        covariance.add_isotropic(0.5 * variance, variance);
        Self { covariance }
    }

    /// The motion over one interval: adds `sigma_q^2` for each angle and `sigma_t^2` for each coordinate.
    pub fn predict(&mut self, noise: &ProcessNoise) {
        self.covariance.add_isotropic(noise.sigma_q * noise.sigma_q, noise.sigma_t * noise.sigma_t);
    }

    /// The ranges of one epoch; what they do not see is left to the prior.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] where double precision does not carry the sum; the bound stays as it was.
    pub fn update(&mut self, information: &FisherInformation<D>) -> Result<()> {
        self.update_on(&information.on_tangent_space())
    }

    /// [`PosteriorBound::update`] where the information on the tangent space is known already.
    pub(super) fn update_on(&mut self, information: &TangentMatrix<D>) -> Result<()> {
        let posterior = self.covariance.inverse().and_then(|mut precision| {
            precision.add(information);
            precision.inverse()
        });
        self.covariance =
            posterior.map_err(|pivot| Error::NotPositiveDefinite { what: "the posterior bound", pivot })?;
        Ok(())
    }

    /// The bound on the covariance of the tangent coordinates.
    pub fn covariance(&self) -> &TangentMatrix<D> {
        &self.covariance
    }
}
