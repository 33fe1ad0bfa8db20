//! The unconstrained Kalman filter on `theta = vec([Q | t])` ([T] Sec. IV-A).

use super::filter::{Consistency, Estimator, Step, Uncertainty, require_finite};
use crate::error::Result;
use crate::math::pose::Theta;
use crate::math::rotation::defect;
use crate::model::covariance::Covariance;
use crate::model::epoch::{Epoch, Initial};
use crate::model::motion::ProcessNoise;
use crate::model::normal_equations::NormalEquations;
use crate::model::ranging::{RangeForm, RangeModel, WeightBuffer};

/// The Kalman filter ([T] eq. 17, 20-22) in information form.
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
    buffer: WeightBuffer,
}

/// A predict and update that is not yet the filter's state: estimators that project decide what is kept.
pub(super) struct Update<const D: usize> {
    pub(super) prior: Theta<D>,
    pub(super) prior_covariance: Covariance<D>,
    pub(super) normal: NormalEquations<D>,
    pub(super) theta: Theta<D>,
    pub(super) covariance: Covariance<D>,
    pub(super) nis: Consistency,
}

impl<const D: usize> KalmanFilter<D> {
    /// Starts from a prior that is isotropic on `theta`.
    pub fn new(model: RangeModel<D>, initial: &Initial<D>, process: ProcessNoise) -> Self {
        let covariance = Covariance::isotropic(initial.variance, model.topology());
        let buffer = model.weight_buffer();
        Self { model, process, theta: initial.theta, covariance, buffer }
    }

    /// Predict and update from the present state, which is left as it is.
    pub(super) fn update(&mut self, epoch: &Epoch<D>) -> Result<Update<D>> {
        let rotation = epoch.motion.rotation();
        let prior = epoch.motion.predict_theta(&self.theta, &rotation);
        require_finite(&prior)?;
        let mut prior_covariance = self.covariance;
        prior_covariance.predict(rotation.matrix(), &self.process);
        let normal = self.model.normal_equations(
            &epoch.ranges,
            epoch.weight_ranges(),
            &prior,
            RangeForm::Projected,
            &mut self.buffer,
        )?;
        let mut covariance = prior_covariance;
        covariance.update(&normal.information)?;
        let correction = covariance.times(&normal.innovation);
        let mut theta = prior;
        theta.orientation += correction.orientation;
        theta.position += correction.position;
        // r^T S^-1 r = r^T r - r^T H P H^T r by the matrix inversion lemma.
        let value = normal.energy - normal.innovation.dot(&correction);
        let nis = Consistency { value: value.max(0.0), degrees_of_freedom: normal.residuals };
        Ok(Update { prior, prior_covariance, normal, theta, covariance, nis })
    }

    /// Makes an update the state, with `theta` as the estimate that is fed back.
    pub(super) fn keep(&mut self, update: &Update<D>, theta: Theta<D>) {
        self.theta = theta;
        self.covariance = update.covariance;
    }
}

impl<const D: usize> Update<D> {
    /// The record of the step, with what is reported.
    pub(super) fn into_step(self, posterior: Theta<D>, uncertainty: Uncertainty<D>, event: bool) -> Step<D> {
        Step {
            prior: self.prior,
            innovation: self.normal.innovation,
            nis: self.nis,
            unprojected: self.theta,
            posterior,
            uncertainty,
            defect: defect(&self.theta.orientation),
            event,
        }
    }
}

impl<const D: usize> Estimator<D> for KalmanFilter<D> {
    fn step(&mut self, epoch: &Epoch<D>) -> Result<Step<D>> {
        let update = self.update(epoch)?;
        self.keep(&update, update.theta);
        let (theta, covariance) = (update.theta, update.covariance);
        Ok(update.into_step(theta, Uncertainty::Linear(covariance), false))
    }
}
