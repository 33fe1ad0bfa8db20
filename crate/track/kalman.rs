//! The unconstrained Kalman filter on `theta = vec([Q | t])` (\[T\] Sec. IV-A).

use super::filter::{Consistency, Estimator, Step, Uncertainty, require_finite};
use crate::error::Result;
use crate::math::pose::Theta;
use crate::math::rotation::defect;
use crate::model::accumulate::RangeBuffer;
use crate::model::covariance::Covariance;
use crate::model::epoch::{Epoch, Initial};
use crate::model::motion::ProcessNoise;
use crate::model::normal_equations::NormalEquations;
use crate::model::ranging::{RangeForm, RangeModel};

/// The Kalman filter (\[T\] eq. 17, 20-22) in information form.
///
/// `P <- (P^-1 + Lambda)^-1`, `theta <- theta + P innovation`, where `Lambda` and the innovation are the normal equations
/// of the ranges about the prior. With a centred topology and shared weights this is D+1 independent D-state filters,
/// and is computed so.
///
/// ```
/// use nalgebra::{Matrix2, Vector2};
/// use rangelab::math::pose::Theta;
/// use rangelab::model::{anchors::Anchors, epoch::{Epoch, Initial}, motion::{Motion, ProcessNoise}};
/// use rangelab::model::{noise::RangeNoise, ranging::{RangeModel, Weighting}, topology::Topology};
/// use rangelab::track::{filter::Estimator, kalman::KalmanFilter};
///
/// let corner = |x, y| Vector2::new(x, y);
/// let model = RangeModel::new(
///     Anchors::new(vec![corner(0.0, 0.0), corner(9.0, 0.0), corner(0.0, 7.0), corner(9.0, 7.0)])?,
///     Topology::new(vec![corner(-0.3, -0.2), corner(0.3, -0.2), corner(0.0, 0.4)])?,
///     RangeNoise::Range { sigma: 0.05 },
///     Weighting::Common,
/// )?;
/// let truth = Theta { orientation: Matrix2::identity(), position: Vector2::new(4.0, 3.0) };
/// let epoch = Epoch { motion: Motion::rest(0.1), ranges: model.exact_ranges(&truth)?, true_ranges: None };
/// let initial = Initial { theta: Theta { position: Vector2::zeros(), ..truth }, variance: 100.0 };
/// let mut filter = KalmanFilter::new(model, &initial, ProcessNoise { sigma_q: 0.01, sigma_t: 0.1 });
/// let step = filter.step(&epoch)?;
/// assert!((step.posterior.position - truth.position).norm() < 1e-3);
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct KalmanFilter<const D: usize> {
    model: RangeModel<D>,
    process: ProcessNoise,
    theta: Theta<D>,
    covariance: Covariance<D>,
    buffer: RangeBuffer<D>,
    update: Update<D>,
}

/// A predict and update that is not yet the filter's state: estimators that project decide what is kept.
#[derive(Clone, Copy, Debug)]
pub(super) struct Update<const D: usize> {
    pub(super) prior: Theta<D>,
    pub(super) normal: NormalEquations<D>,
    pub(super) theta: Theta<D>,
    pub(super) covariance: Covariance<D>,
    pub(super) nis: Consistency,
}

impl<const D: usize> KalmanFilter<D> {
    /// Starts from a prior that is isotropic on `theta`.
    pub fn new(model: RangeModel<D>, initial: &Initial<D>, process: ProcessNoise) -> Self {
        let covariance = Covariance::isotropic(initial.variance, model.topology());
        let buffer = model.range_buffer();
        let theta = initial.theta;
        let nis = Consistency { value: 0.0, degrees_of_freedom: 0 };
        let update = Update { prior: theta, normal: NormalEquations::empty(), theta, covariance, nis };
        Self { model, process, theta, covariance, buffer, update }
    }

    /// Predict and update from the present state, which is left as it is.
    pub(super) fn update(&mut self, epoch: &Epoch<D>) -> Result<&Update<D>> {
        let rotation = epoch.motion.rotation();
        let update = &mut self.update;
        update.prior = epoch.motion.predict_theta(&self.theta, &rotation);
        require_finite(&update.prior)?;
        update.covariance.set(&self.covariance);
        update.covariance.predict(rotation.matrix(), &self.process);
        self.model.fill_normal_equations(
            &epoch.ranges,
            epoch.weight_ranges(),
            &update.prior,
            RangeForm::Projected,
            &mut self.buffer,
            &mut update.normal,
        )?;
        update.covariance.update(&update.normal.information)?;
        let correction = update.covariance.times(&update.normal.innovation);
        update.theta.orientation = update.prior.orientation + correction.orientation;
        update.theta.position = update.prior.position + correction.position;
        // r^T S^-1 r = r^T r - r^T H P H^T r by the matrix inversion lemma.
        let value = update.normal.energy - update.normal.innovation.dot(&correction);
        update.nis = Consistency { value: value.max(0.0), degrees_of_freedom: update.normal.residuals };
        Ok(update)
    }

    /// The covariance predicted for an epoch.
    pub(super) fn predicted_covariance(&self, epoch: &Epoch<D>) -> Covariance<D> {
        let mut covariance = self.covariance;
        covariance.predict(epoch.motion.rotation().matrix(), &self.process);
        covariance
    }

    /// Makes the last update the state, with `theta` as the estimate that is fed back.
    #[inline]
    pub(super) fn keep(&mut self, theta: Theta<D>) {
        self.theta = theta;
        self.covariance.set(&self.update.covariance);
    }

    /// The record of the last update, with what is reported.
    #[inline]
    pub(super) fn record(&self, posterior: Theta<D>, uncertainty: Uncertainty<D>, event: bool) -> Step<D> {
        Step {
            prior: self.update.prior,
            innovation: self.update.normal.innovation,
            nis: self.update.nis,
            unprojected: self.update.theta,
            posterior,
            uncertainty,
            defect: defect(&self.update.theta.orientation),
            event,
        }
    }
}

impl<const D: usize> Estimator<D> for KalmanFilter<D> {
    fn step(&mut self, epoch: &Epoch<D>) -> Result<Step<D>> {
        let theta = self.update(epoch)?.theta;
        self.keep(theta);
        Ok(self.record(theta, Uncertainty::Linear(self.covariance), false))
    }
}
