//! What is counted for one estimator at one step over many trials.

use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::error::PoseError;
use super::flat::{Flat, Numbers};
use super::moments::{Estimate, Moments};
use crate::error::Result;
use crate::math::float::sqrt;
use crate::math::pose::Pose;
use crate::math::rotation::determinant;
use crate::track::filter::Step;

/// What is averaged over trials.
#[derive(Clone, Copy)]
enum Figure {
    Orientation,
    Position,
    Angle,
    ColumnAngle,
    Nees,
    Nis,
    NisFreedom,
    Events,
    Reflections,
    OrientationTrace,
    PositionTrace,
}

const FIGURES: usize = Figure::PositionTrace as usize + 1;

/// Sums over trials for one estimator at one step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    moments: [Moments; FIGURES],
    /// Sum of `Q_hat - Q`, entry by entry; unused entries (D = 2) are zero.
    orientation_sum: [f64; 9],
    /// Sum of `t_hat - t`, m.
    position_sum: [f64; 3],
    nees_freedom: usize,
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
    /// Mean degrees of freedom of the NIS, which missing ranges lower.
    pub nis_degrees_of_freedom: f64,
    /// Share of trials in which `Q` was projected.
    pub event_rate: Estimate,
    /// Share of trials in which the reported `Q` mirrors the body.
    pub reflection_rate: Estimate,
}

impl Tally {
    /// Counts a step.
    ///
    /// # Errors
    /// When the reported covariance cannot be inverted for the NEES.
    pub fn push<const D: usize>(&mut self, step: &Step<D>, truth: &Pose<D>) -> Result<()> {
        let error = PoseError::of(step, truth);
        let nees = step.nees(truth)?;
        let mirrored = determinant(&step.posterior.orientation) < 0.0;
        let figures = [
            (Figure::Orientation, error.orientation.norm_squared()),
            (Figure::Position, error.position.norm_squared()),
            (Figure::Angle, error.angle * error.angle),
            (Figure::ColumnAngle, error.column_angle),
            (Figure::Nees, nees.value),
            (Figure::Nis, step.nis.value),
            (Figure::NisFreedom, step.nis.degrees_of_freedom as f64),
            (Figure::Events, f64::from(u8::from(step.event))),
            (Figure::Reflections, f64::from(u8::from(mirrored))),
            (Figure::OrientationTrace, step.uncertainty.orientation_trace()),
            (Figure::PositionTrace, step.uncertainty.position_block().trace()),
        ];
        for (figure, value) in figures {
            self.moments[figure as usize].push(value);
        }
        add(&mut self.orientation_sum, error.orientation.as_slice());
        add(&mut self.position_sum, error.position.as_slice());
        self.nees_freedom = nees.degrees_of_freedom;
        Ok(())
    }

    /// Counts a trial that did not reach the step.
    pub fn push_failure(&mut self) {
        self.failures += 1;
    }

    /// Appends the trials of `next`.
    pub fn merge(&mut self, next: &Self) {
        for (mine, theirs) in self.moments.iter_mut().zip(&next.moments) {
            mine.merge(theirs);
        }
        add(&mut self.orientation_sum, &next.orientation_sum);
        add(&mut self.position_sum, &next.position_sum);
        self.nees_freedom = self.nees_freedom.max(next.nees_freedom);
        self.failures += next.failures;
    }

    /// The figures so far.
    pub fn summary(&self) -> Summary {
        let moments = |figure: Figure| &self.moments[figure as usize];
        Summary {
            trials: moments(Figure::Orientation).count(),
            failures: self.failures,
            rmse_orientation: moments(Figure::Orientation).root_mean(),
            rmse_position: moments(Figure::Position).root_mean(),
            rms_angle: moments(Figure::Angle).root_mean(),
            paper_mae: moments(Figure::ColumnAngle).root_mean(),
            bias_orientation: bias(&self.orientation_sum, moments(Figure::Orientation)),
            bias_position: bias(&self.position_sum, moments(Figure::Position)),
            claimed_orientation: moments(Figure::OrientationTrace).root_mean(),
            claimed_position: moments(Figure::PositionTrace).root_mean(),
            nees: scaled(moments(Figure::Nees).mean(), self.nees_freedom as f64),
            nees_degrees_of_freedom: self.nees_freedom,
            nis: scaled(moments(Figure::Nis).mean(), moments(Figure::NisFreedom).mean().value),
            nis_degrees_of_freedom: moments(Figure::NisFreedom).mean().value,
            event_rate: moments(Figure::Events).mean(),
            reflection_rate: moments(Figure::Reflections).mean(),
        }
    }
}

impl Flat for Tally {
    const LENGTH: usize = FIGURES * Moments::LENGTH + 9 + 3 + 2;

    fn write(&self, to: &mut Vec<f64>) {
        self.moments.iter().for_each(|moments| moments.write(to));
        to.extend(self.orientation_sum);
        to.extend(self.position_sum);
        to.extend([self.nees_freedom as f64, self.failures as f64]);
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        Self {
            moments: core::array::from_fn(|_| Moments::read(from)),
            orientation_sum: core::array::from_fn(|_| from.number()),
            position_sum: core::array::from_fn(|_| from.number()),
            nees_freedom: from.count(),
            failures: from.count(),
        }
    }
}

fn add(sum: &mut [f64], terms: &[f64]) {
    sum.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
}

/// Length of a mean error vector; sampling alone gives about the root mean square error over the root of the count.
fn bias(sum: &[f64], squared: &Moments) -> Estimate {
    let count = squared.count().max(1) as f64;
    let length = sqrt(sum.iter().map(|x| x * x).sum());
    Estimate { value: length / count, standard_error: sqrt(squared.mean().value.max(0.0) / count) }
}

fn scaled(estimate: Estimate, by: f64) -> Estimate {
    let factor = if by > 0.0 { 1.0 / by } else { 0.0 };
    Estimate { value: estimate.value * factor, standard_error: estimate.standard_error * factor }
}
