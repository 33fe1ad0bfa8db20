//! The unitarily constrained Kalman filter (\[T\] Sec. IV-B).

use nalgebra::{SMatrix, SVector};

use super::event_triggered::project_jointly;
use super::filter::{Estimator, Step, Uncertainty, not_positive};
use super::kalman::{KalmanFilter, Update};
use crate::error::Result;
use crate::math::block::BlockMatrix;
use crate::math::linalg::spd_inverse;
use crate::math::pose::Theta;
use crate::math::projection::project_in_metric;
use crate::math::rotation::Manifold;
use crate::math::singular::psd_pseudo_inverse;
use crate::model::covariance::Covariance;
use crate::model::epoch::{Epoch, Initial};
use crate::model::motion::ProcessNoise;
use crate::model::ranging::RangeModel;

/// The UC-KF: the update is the minimizer of \[T\] eq. 23 over `Q` on the manifold and `t`.
///
/// For any prior and topology that is the plain Kalman update, then the projection of `Q` in the metric `P_q^-1`, then
/// `t <- t + P_tq P_q^-1 (q_new - q)`; no stacking. The covariance stays that of eq. 22, which is too large on the
/// manifold; [`Uncertainty::Constrained`] says so.
#[derive(Clone, Debug)]
pub struct UnitaryKalmanFilter<const D: usize> {
    filter: KalmanFilter<D>,
    manifold: Manifold,
    decoupled: bool,
}

impl<const D: usize> UnitaryKalmanFilter<D> {
    /// Starts from a prior that is isotropic on `theta`. `decoupled` solves for `Q` with `t` eliminated from the ranges
    /// alone and then for `t` (\[T\] eq. 26-27), which is the same for a centred topology and a little worse otherwise.
    pub fn new(
        model: RangeModel<D>,
        initial: &Initial<D>,
        process: ProcessNoise,
        manifold: Manifold,
        decoupled: bool,
    ) -> Self {
        Self { filter: KalmanFilter::new(model, initial, process), manifold, decoupled }
    }
}

impl<const D: usize> Estimator<D> for UnitaryKalmanFilter<D> {
    fn step(&mut self, epoch: &Epoch<D>) -> Result<Step<D>> {
        let prior = self.decoupled.then(|| self.filter.predicted_covariance(epoch));
        let update = self.filter.update(epoch)?;
        let posterior = match (prior, &update.covariance) {
            (Some(prior), Covariance::Full(_)) => decoupled(update, &prior.to_blocks(), self.manifold)?,
            // With C 1 = 0 and independent columns the two forms are one.
            _ => project_jointly(&update.theta, &update.covariance, self.manifold)?,
        };
        let uncertainty = Uncertainty::Constrained(update.covariance);
        self.filter.keep(posterior);
        Ok(self.filter.record(posterior, uncertainty, true))
    }
}

/// \[T\] eq. 26, then 27.
fn decoupled<const D: usize>(
    update: &Update<D>,
    prior: &BlockMatrix<D>,
    manifold: Manifold,
) -> Result<Theta<D>> {
    let information = update.normal.information.to_blocks();
    let innovation = &update.normal.innovation;
    let (mut metric, mut gradient) = eliminate_position(&information, innovation);
    metric.add(&prior.orientation_metric().map_err(not_positive)?.metric);
    // Zero rows for t would make the metric singular; the identity leaves them alone.
    metric.set_block(D, D, &SMatrix::identity());
    gradient.position = SVector::zeros();
    let unconstrained = metric.inverse().map_err(not_positive)?.times(&gradient).orientation;
    let target = update.prior.orientation + unconstrained;
    let orientation = *project_in_metric(&target, &metric, manifold)?.matrix();
    let turned = Theta { orientation: orientation - update.prior.orientation, position: SVector::zeros() };
    let residual = innovation.position - information.times(&turned).position;
    let precision =
        spd_inverse(&prior.position_block()).map_err(not_positive)? + information.position_block();
    let shift = spd_inverse(&precision).map_err(not_positive)? * residual;
    Ok(Theta { orientation, position: update.prior.position + shift })
}

/// The information that the ranges alone hold about `Q`, whatever `t`: `Lambda_qq - Lambda_qt Lambda_tt^+ Lambda_tq`.
fn eliminate_position<const D: usize>(
    information: &BlockMatrix<D>,
    innovation: &Theta<D>,
) -> (BlockMatrix<D>, Theta<D>) {
    let inverse = psd_pseudo_inverse(&information.position_block());
    let mut reduced = BlockMatrix::zeros();
    let mut gradient = *innovation;
    for i in 0..D {
        let gain = information.block(i, D) * inverse;
        for j in 0..=i {
            reduced.set_block(i, j, &(information.block(i, j) - gain * information.block(D, j)));
        }
        gradient.add_to_column(i, &-(gain * innovation.position));
    }
    (reduced, gradient)
}
