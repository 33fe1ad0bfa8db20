//! The event-triggered Kalman filter and KF-ortho (\[T\] Sec. IV-C).

use super::filter::{Estimator, Step, Uncertainty};
use super::kalman::{KalmanFilter, Update};
use crate::error::Result;
use crate::math::block::OrientationMetric;
use crate::math::pose::Theta;
use crate::math::projection::project_in_metric;
use crate::math::rotation::{Manifold, Rotation, defect};
use crate::model::covariance::Covariance;
use crate::model::epoch::{Epoch, Initial};
use crate::model::estimator_settings::{Metric, Threshold, ThresholdKind};
use crate::model::motion::ProcessNoise;
use crate::model::ranging::RangeModel;

/// When `Q` is projected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trigger {
    /// After every update: KF-ortho.
    Always,
    /// Where the defect `||Q^T Q - I||_F` exceeds a threshold: ET-KF.
    Above(Threshold),
}

/// How `Q` is projected and what becomes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProjectionSettings {
    /// When.
    pub trigger: Trigger,
    /// In which metric. In `P_q^-1` the position moves along, `t <- t + P_tq P_q^-1 (q_new - q)`.
    pub metric: Metric,
    /// Onto what.
    pub manifold: Manifold,
    /// True: the filter goes on from the projected `Q` with `P` unchanged, as the paper's text implies. False: the
    /// projection is only reported. With badly placed anchors feedback makes KF-ortho several times worse than the plain
    /// filter, since `P` is not told what the projection did.
    pub feedback: bool,
}

/// The Kalman filter with an orthonormalization of `Q` that is triggered by its defect.
#[derive(Clone, Debug)]
pub struct EventTriggeredKalmanFilter<const D: usize> {
    filter: KalmanFilter<D>,
    settings: ProjectionSettings,
}

impl<const D: usize> EventTriggeredKalmanFilter<D> {
    /// Starts from a prior that is isotropic on `theta`.
    pub fn new(
        model: RangeModel<D>,
        initial: &Initial<D>,
        process: ProcessNoise,
        settings: ProjectionSettings,
    ) -> Self {
        Self { filter: KalmanFilter::new(model, initial, process), settings }
    }

    fn triggered(&self, theta: &Theta<D>, covariance: &Covariance<D>) -> bool {
        match self.settings.trigger {
            Trigger::Always => true,
            Trigger::Above(Threshold { kind, epsilon }) => {
                let scale = match kind {
                    ThresholdKind::Absolute => 1.0,
                    ThresholdKind::Relative => crate::math::float::sqrt(covariance.orientation_trace()),
                };
                defect(&theta.orientation) > epsilon * scale
            }
        }
    }

    fn project(&self, theta: &Theta<D>, covariance: &Covariance<D>) -> Result<Theta<D>> {
        match self.settings.metric {
            Metric::Frobenius => Ok(Theta {
                orientation: *Rotation::project(&theta.orientation, self.settings.manifold).matrix(),
                position: theta.position,
            }),
            Metric::Information => project_jointly(theta, covariance, self.settings.manifold),
        }
    }
}

/// Projects `Q` in the metric `P_q^-1` and moves `t` along: the exact minimizer of \[T\] eq. 23 for any `P` and topology.
pub(super) fn project_jointly<const D: usize>(
    theta: &Theta<D>,
    covariance: &Covariance<D>,
    manifold: Manifold,
) -> Result<Theta<D>> {
    let OrientationMetric { metric, position_gain } = covariance.orientation_metric()?;
    let orientation = *project_in_metric(&theta.orientation, &metric, manifold)?.matrix();
    let moved = orientation - theta.orientation;
    let mut position = theta.position;
    for j in 0..D {
        position += position_gain[j] * moved.column(j);
    }
    Ok(Theta { orientation, position })
}

impl<const D: usize> Estimator<D> for EventTriggeredKalmanFilter<D> {
    fn step(&mut self, epoch: &Epoch<D>) -> Result<Step<D>> {
        let &Update { theta, covariance, .. } = self.filter.update(epoch)?;
        let event = self.triggered(&theta, &covariance);
        let posterior = if event { self.project(&theta, &covariance)? } else { theta };
        self.filter.keep(if self.settings.feedback { posterior } else { theta });
        Ok(self.filter.record(posterior, Uncertainty::Linear(covariance), event))
    }
}
