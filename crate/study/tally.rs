//! What is counted for one estimator at one step over many trials.

use serde::{Deserialize, Serialize};

use super::error::PoseError;
use super::moments::{Estimate, Moments};
use crate::error::Result;
use crate::math::float::sqrt;
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::determinant;
use crate::track::filter::Step;

/// Sums over trials for one estimator at one step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally<const D: usize> {
    orientation: Moments,
    position: Moments,
    angle: Moments,
    column_angle: Moments,
    nees: Moments,
    nis: Moments,
    events: Moments,
    reflections: Moments,
    orientation_trace: Moments,
    position_trace: Moments,
    error_sum: Theta<D>,
    nees_freedom: usize,
    nis_freedom: Moments,
    failures: usize,
}

/// One row of a study: an estimator at a step, each figure with its standard error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Summary {
    /// Trials that reached the step.
    pub trials: usize,
    /// Trials in which the estimator had given a typed error by then.
    pub failures: usize,
    /// `RMSE(Q) = sqrt(mean ||Q_hat - Q||_F^2)`.
    pub rmse_orientation: Estimate,
    /// `RMSE(t)`, m.
    pub rmse_position: Estimate,
    /// Root mean square geodesic angle, rad.
    pub rms_angle: Estimate,
    /// The paper's literal mean angular error, `sqrt(mean over trials and columns of the column angle)`, in sqrt(rad).
    pub paper_mae: Estimate,
    /// `||mean (Q_hat - Q)||_F`; its standard error is the level that sampling alone gives.
    pub bias_orientation: Estimate,
    /// `||mean (t_hat - t)||`, m.
    pub bias_position: Estimate,
    /// `sqrt(mean tr P_q)`: the error the estimator claims.
    pub claimed_orientation: Estimate,
    /// `sqrt(mean tr P_t)`, m.
    pub claimed_position: Estimate,
    /// Mean NEES over its degrees of freedom; 1 where the covariance is right.
    pub nees: Estimate,
    /// Degrees of freedom of the NEES.
    pub nees_degrees_of_freedom: usize,
    /// Mean NIS over mean degrees of freedom.
    pub nis: Estimate,
    /// Share of trials in which `Q` was projected.
    pub event_rate: Estimate,
    /// Share of trials in which the reported `Q` mirrors the body.
    pub reflection_rate: Estimate,
}

impl<const D: usize> Tally<D> {
    /// Counts a step.
    ///
    /// # Errors
    /// When the reported covariance cannot be inverted for the NEES.
    pub fn push(&mut self, step: &Step<D>, truth: &Pose<D>) -> Result<()> {
        let error = PoseError::of(step, truth);
        let nees = step.nees(truth)?;
        self.orientation.push(error.orientation.norm_squared());
        self.position.push(error.position.norm_squared());
        self.angle.push(error.angle * error.angle);
        self.column_angle.push(error.column_angle);
        self.nees.push(nees.value);
        self.nees_freedom = nees.degrees_of_freedom;
        self.nis.push(step.nis.value);
        self.nis_freedom.push(step.nis.degrees_of_freedom as f64);
        self.events.push(f64::from(u8::from(step.event)));
        self.reflections.push(f64::from(u8::from(determinant(&step.posterior.orientation) < 0.0)));
        self.orientation_trace.push(step.uncertainty.orientation_trace());
        self.position_trace.push(step.uncertainty.position_block().trace());
        self.error_sum.orientation += error.orientation;
        self.error_sum.position += error.position;
        Ok(())
    }

    /// Counts a trial that did not reach the step.
    pub fn push_failure(&mut self) {
        self.failures += 1;
    }

    /// Appends the trials of `next`.
    pub fn merge(&mut self, next: &Self) {
        let pairs: [(&mut Moments, &Moments); 11] = [
            (&mut self.orientation, &next.orientation),
            (&mut self.position, &next.position),
            (&mut self.angle, &next.angle),
            (&mut self.column_angle, &next.column_angle),
            (&mut self.nees, &next.nees),
            (&mut self.nis, &next.nis),
            (&mut self.nis_freedom, &next.nis_freedom),
            (&mut self.events, &next.events),
            (&mut self.reflections, &next.reflections),
            (&mut self.orientation_trace, &next.orientation_trace),
            (&mut self.position_trace, &next.position_trace),
        ];
        for (mine, theirs) in pairs {
            mine.merge(theirs);
        }
        self.error_sum.orientation += next.error_sum.orientation;
        self.error_sum.position += next.error_sum.position;
        self.nees_freedom = self.nees_freedom.max(next.nees_freedom);
        self.failures += next.failures;
    }

    /// The figures so far.
    pub fn summary(&self) -> Summary {
        Summary {
            trials: self.orientation.count(),
            failures: self.failures,
            rmse_orientation: self.orientation.root_mean(),
            rmse_position: self.position.root_mean(),
            rms_angle: self.angle.root_mean(),
            paper_mae: self.column_angle.root_mean(),
            bias_orientation: bias(self.error_sum.orientation.norm(), &self.orientation),
            bias_position: bias(self.error_sum.position.norm(), &self.position),
            claimed_orientation: self.orientation_trace.root_mean(),
            claimed_position: self.position_trace.root_mean(),
            nees: scaled(self.nees.mean(), self.nees_freedom as f64),
            nees_degrees_of_freedom: self.nees_freedom,
            nis: scaled(self.nis.mean(), self.nis_freedom.mean().value),
            event_rate: self.events.mean(),
            reflection_rate: self.reflections.mean(),
        }
    }
}

/// Length of a mean error vector; sampling alone gives about the root mean square error over the root of the count.
fn bias(sum: f64, squared: &Moments) -> Estimate {
    let count = squared.count().max(1) as f64;
    Estimate { value: sum / count, standard_error: sqrt(squared.mean().value.max(0.0) / count) }
}

fn scaled(estimate: Estimate, by: f64) -> Estimate {
    let factor = if by > 0.0 { 1.0 / by } else { 0.0 };
    Estimate { value: estimate.value * factor, standard_error: estimate.standard_error * factor }
}
