//! What is counted for one estimator, and for one bound, at one noise.

use alloc::vec::Vec;

use super::super::flat::{Flat, Numbers};
use super::super::moments::{Estimate, Moments};
use super::report::{SnapshotBoundSummary, SnapshotSummary};
use super::trial::SnapshotError;
use crate::bounds::Bound;
use crate::math::float::sqrt;

/// What is averaged over trials.
#[derive(Clone, Copy)]
enum Figure {
    Orientation,
    Angle,
    ColumnAngle,
    Position,
    Sensors,
    Reflections,
    Uncertain,
    Iterations,
}

const FIGURES: usize = Figure::Iterations as usize + 1;

/// Sums over trials for one estimator at one noise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SnapshotTally {
    moments: [Moments; FIGURES],
    /// Sum of `Q_hat - Q`, entry by entry; unused entries (D = 2) are zero.
    orientation_sum: [f64; 9],
    /// Sum of `t_hat - t`, m.
    position_sum: [f64; 3],
    most_iterations: usize,
    failures: usize,
}

impl SnapshotTally {
    /// Counts an estimate.
    pub fn push<const D: usize>(&mut self, error: &SnapshotError<D>) {
        let flag = |x: bool| f64::from(u8::from(x));
        if let Some(pose) = &error.pose {
            self.count(Figure::Orientation, pose.orientation.norm_squared());
            self.count(Figure::Angle, pose.angle * pose.angle);
            self.count(Figure::ColumnAngle, pose.column_angle);
            self.count(Figure::Position, pose.position.norm_squared());
            self.count(Figure::Reflections, flag(error.reflected));
            self.count(Figure::Uncertain, flag(error.uncertain));
            add(&mut self.orientation_sum, pose.orientation.as_slice());
            add(&mut self.position_sum, pose.position.as_slice());
        }
        self.count(Figure::Sensors, error.sensors);
        self.count(Figure::Iterations, error.iterations as f64);
        self.most_iterations = self.most_iterations.max(error.iterations);
    }

    /// Counts a trial in which the estimator gave a typed error.
    pub fn push_failure(&mut self) {
        self.failures += 1;
    }

    fn count(&mut self, figure: Figure, value: f64) {
        self.moments[figure as usize].push(value);
    }

    /// Appends the trials of `next`.
    pub fn merge(&mut self, next: &Self) {
        self.moments.iter_mut().zip(&next.moments).for_each(|(mine, theirs)| mine.merge(theirs));
        add(&mut self.orientation_sum, &next.orientation_sum);
        add(&mut self.position_sum, &next.position_sum);
        self.most_iterations = self.most_iterations.max(next.most_iterations);
        self.failures += next.failures;
    }

    /// The figures so far.
    pub fn summary(&self) -> SnapshotSummary {
        let moments = |figure: Figure| &self.moments[figure as usize];
        let of_pose = |value: Estimate| (moments(Figure::Orientation).count() > 0).then_some(value);
        SnapshotSummary {
            trials: moments(Figure::Sensors).count(),
            failures: self.failures,
            rmse_orientation: of_pose(moments(Figure::Orientation).root_mean()),
            rms_angle: of_pose(moments(Figure::Angle).root_mean()),
            paper_mae: of_pose(moments(Figure::ColumnAngle).root_mean()),
            rmse_position: of_pose(moments(Figure::Position).root_mean()),
            rmse_sensors: moments(Figure::Sensors).root_mean(),
            bias_orientation: of_pose(bias(&self.orientation_sum, moments(Figure::Orientation))),
            bias_position: of_pose(bias(&self.position_sum, moments(Figure::Position))),
            reflection_rate: of_pose(moments(Figure::Reflections).mean()),
            uncertain_rate: of_pose(moments(Figure::Uncertain).mean()),
            iterations: moments(Figure::Iterations).mean(),
            most_iterations: self.most_iterations,
        }
    }
}

impl Flat for SnapshotTally {
    const LENGTH: usize = FIGURES * Moments::LENGTH + 9 + 3 + 2;

    fn write(&self, to: &mut Vec<f64>) {
        self.moments.iter().for_each(|moments| moments.write(to));
        to.extend(self.orientation_sum);
        to.extend(self.position_sum);
        to.extend([self.most_iterations as f64, self.failures as f64]);
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        Self {
            moments: core::array::from_fn(|_| Moments::read(from)),
            orientation_sum: core::array::from_fn(|_| from.number()),
            position_sum: core::array::from_fn(|_| from.number()),
            most_iterations: from.count(),
            failures: from.count(),
        }
    }
}

/// The traces of one bound in one trial; `None` for what it does not speak of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundFigures {
    /// Least mean of `||Q_hat - Q||_F^2`.
    pub orientation: Option<f64>,
    /// Least mean square rotation angle, rad^2.
    pub angle: Option<f64>,
    /// Least mean of `||t_hat - t||^2`, m^2; of the centroid for sensors by themselves.
    pub position: Option<f64>,
    /// Least mean of `||S_hat - S||_F^2`, m^2.
    pub sensors: f64,
}

impl BoundFigures {
    pub(super) fn new<const D: usize>(bound: &Bound<D>, sensors: f64) -> Self {
        Self {
            orientation: Some(bound.orientation_trace),
            angle: bound.angle_variance,
            position: Some(bound.position_trace),
            sensors,
        }
    }
}

/// Sums over trials for one bound at one noise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SnapshotBoundTally([Moments; 4]);

impl SnapshotBoundTally {
    /// Counts a bound.
    pub fn push(&mut self, figures: &BoundFigures) {
        let values = [figures.orientation, figures.angle, figures.position, Some(figures.sensors)];
        for (moments, value) in self.0.iter_mut().zip(values) {
            if let Some(value) = value {
                moments.push(value);
            }
        }
    }

    /// Appends the trials of `next`.
    pub fn merge(&mut self, next: &Self) {
        self.0.iter_mut().zip(&next.0).for_each(|(mine, theirs)| mine.merge(theirs));
    }

    /// The figures so far.
    pub fn summary(&self) -> SnapshotBoundSummary {
        let root = |moments: &Moments| (moments.count() > 0).then(|| moments.root_mean());
        let [orientation, angle, position, sensors] = &self.0;
        SnapshotBoundSummary {
            trials: sensors.count(),
            orientation: root(orientation),
            angle: root(angle),
            position: root(position),
            sensors: root(sensors),
        }
    }
}

impl Flat for SnapshotBoundTally {
    const LENGTH: usize = 4 * Moments::LENGTH;

    fn write(&self, to: &mut Vec<f64>) {
        self.0.iter().for_each(|moments| moments.write(to));
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        Self(core::array::from_fn(|_| Moments::read(from)))
    }
}

fn add(sum: &mut [f64], terms: &[f64]) {
    sum.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
}

/// Length of a mean error; sampling alone gives about the root mean square error over the root of the count.
fn bias(sum: &[f64], squared: &Moments) -> Estimate {
    let count = squared.count().max(1) as f64;
    let length = sqrt(sum.iter().map(|x| x * x).sum());
    Estimate { value: length / count, standard_error: sqrt(squared.mean().value.max(0.0) / count) }
}
