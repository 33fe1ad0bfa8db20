//! The error-state Kalman filter on SO(D) x R^D: the yardstick beyond the paper.

use super::filter::{Consistency, Estimator, Step, Uncertainty, not_positive, require_finite};
use crate::error::Result;
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::{Angles, Manifold, Rotation, defect, right_jacobian_inverse, rotation_angles};
use crate::math::tangent::{TangentMatrix, TangentTransform, TangentVector, join, restrict_gradient, split};
use crate::model::accumulate::RangeBuffer;
use crate::model::epoch::{Epoch, Initial};
use crate::model::motion::ProcessNoise;
use crate::model::normal_equations::NormalEquations;
use crate::model::ranging::{RangeForm, RangeModel};

const MAX_ITERATIONS: usize = 30;

/// A squared step of 1e-6 standard deviations is the last: what the next would correct is its square, or a part of
/// it where residuals are large.
const LAST: f64 = 1e-12;

/// Below this promise a cost that does not fall is rounding, not a wrong step.
const ROUNDING: f64 = 1e-8;

/// An iterated error-state Kalman filter; the rotation error is perturbed on the right, `R exp(hat(phi))`.
///
/// The update is the Gauss-Newton minimum of `||x - prior||^2 + ||d - h(x)||^2` on the manifold, each in its own metric,
/// with steps that are halved where the cost would rise. [`RangeForm::Raw`] reads the squared ranges without projecting
/// out `||s||^2`, which keeps the direction normal to coplanar anchors and one range more for each sensor.
#[derive(Clone, Debug)]
pub struct ErrorStateKalmanFilter<const D: usize> {
    model: RangeModel<D>,
    process: ProcessNoise,
    form: RangeForm,
    pose: Pose<D>,
    covariance: TangentMatrix<D>,
    buffer: RangeBuffer<D>,
    /// Those of the last evaluation.
    normal: NormalEquations<D>,
}

/// One evaluation of the cost: where, how much, and its Gauss-Newton model.
#[derive(Clone, Copy)]
struct Model<const D: usize> {
    pose: Pose<D>,
    cost: f64,
    covariance: TangentMatrix<D>,
    step: TangentVector,
    /// Twice the fall of the cost that the model promises: the squared step in standard deviations.
    decrement: f64,
}

impl<const D: usize> ErrorStateKalmanFilter<D> {
    /// Starts from the prior, restricted to the tangent space: variance `c` on each entry of `Q` is `c/2` on each angle.
    pub fn new(model: RangeModel<D>, initial: &Initial<D>, process: ProcessNoise, form: RangeForm) -> Self {
        let mut covariance = TangentMatrix::zeros();
        covariance.add_isotropic(0.5 * initial.variance, initial.variance);
        let rotation = Rotation::project(&initial.theta.orientation, Manifold::So);
        let pose = Pose { rotation, position: initial.theta.position };
        let buffer = model.range_buffer();
        Self { model, process, form, pose, covariance, buffer, normal: NormalEquations::empty() }
    }

    fn evaluate(
        &mut self,
        epoch: &Epoch<D>,
        prior: &Pose<D>,
        precision: &TangentMatrix<D>,
        pose: Pose<D>,
    ) -> Result<Model<D>> {
        self.model.fill_normal_equations(
            &epoch.ranges,
            epoch.weight_ranges(),
            &Theta::from(pose),
            self.form,
            &mut self.buffer,
            &mut self.normal,
        )?;
        let normal = &self.normal;
        let (phi, shift) = prior.local(&pose);
        let deviation = join(&phi, &shift);
        let pulled = precision.times(&deviation);
        let jacobian = prior_jacobian::<D>(&phi);
        let mut information = precision.congruence(&jacobian);
        information.add(&normal.information.on_tangent_space(&pose.rotation));
        let covariance = information.inverse().map_err(not_positive)?;
        let gradient = restrict_gradient(&normal.innovation, &pose.rotation) - jacobian.transpose() * pulled;
        let cost = normal.energy + deviation.dot(&pulled);
        let step = covariance.times(&gradient);
        Ok(Model { pose, cost, covariance, step, decrement: gradient.dot(&step) })
    }

    /// Gauss-Newton from `start`.
    fn minimize(
        &mut self,
        epoch: &Epoch<D>,
        prior: &Pose<D>,
        precision: &TangentMatrix<D>,
        start: Model<D>,
    ) -> Result<Model<D>> {
        let mut best = start;
        let mut scale = 1.0;
        for _ in 0..MAX_ITERATIONS {
            let (phi, shift) = split(&(best.step * scale));
            let pose = best.pose.retract(&phi, &shift);
            if best.decrement <= LAST {
                best.pose = pose;
                break;
            }
            let candidate = self.evaluate(epoch, prior, precision, pose)?;
            if candidate.cost <= best.cost {
                (best, scale) = (candidate, 1.0);
            } else if best.decrement <= ROUNDING {
                break;
            } else {
                scale *= 0.5;
            }
        }
        Ok(best)
    }
}

/// `d(log of the deviation from the prior)/d(phi, shift)`: the inverse right Jacobian on the angles.
fn prior_jacobian<const D: usize>(phi: &Angles) -> TangentTransform {
    let mut jacobian = TangentTransform::identity();
    let angles = rotation_angles(D);
    let on_angles = right_jacobian_inverse::<D>(phi);
    for i in 0..angles {
        for j in 0..angles {
            jacobian[(i, j)] = on_angles[(i, j)];
        }
    }
    jacobian
}

impl<const D: usize> Estimator<D> for ErrorStateKalmanFilter<D> {
    fn step(&mut self, epoch: &Epoch<D>) -> Result<Step<D>> {
        let prior = epoch.motion.predict_pose(&self.pose, &epoch.motion.rotation());
        require_finite(&Theta::from(prior))?;
        let mut predicted = self.covariance;
        predicted.add_isotropic(
            self.process.sigma_q * self.process.sigma_q,
            self.process.sigma_t * self.process.sigma_t,
        );
        let precision = predicted.inverse().map_err(not_positive)?;
        let start = self.evaluate(epoch, &prior, &precision, prior)?;
        let NormalEquations { innovation, energy, residuals, .. } = self.normal;
        let best = self.minimize(epoch, &prior, &precision, start)?;
        // Repeated products of rotations drift by an ulp a step; this keeps the state a rotation for ever.
        let rotation = best.pose.rotation.renormalized();
        self.pose = Pose { rotation, position: best.pose.position };
        self.covariance = best.covariance;
        let posterior = Theta::from(self.pose);
        let value = (energy - start.decrement).max(0.0);
        Ok(Step {
            prior: Theta::from(prior),
            innovation,
            nis: Consistency { value, degrees_of_freedom: residuals },
            unprojected: posterior,
            posterior,
            uncertainty: Uncertainty::Tangent(best.covariance),
            defect: defect(&posterior.orientation),
            event: false,
        })
    }
}
