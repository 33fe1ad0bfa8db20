//! What is counted for one inertial filter over many trials.

use alloc::vec;
use alloc::vec::Vec;

use super::report::{IndoorStepSummary, IndoorSummary};
use crate::error::Result;
use crate::inertial::filter::InertialStep;
use crate::math::float::sqrt;
use crate::math::singular::singular;
use crate::model::indoor::epoch::NavigationState;
use crate::study::flat::{Flat, Numbers};
use crate::study::moments::{Estimate, Moments};

/// Errors of one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepErrors {
    /// Squared distance from the true position, m^2.
    pub squared_position: f64,
    /// Squared geodesic angle between the rotation next to the filter's `R` and the true one, rad^2.
    pub squared_angle: f64,
    /// Normalized estimation error squared, over its 9 degrees of freedom.
    pub nees: f64,
    /// Largest and smallest singular value of the filter's `R`: both 1 for a rotation.
    pub stretch: [f64; 2],
}

impl StepErrors {
    /// Measures a step against the truth.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the covariance reported cannot be inverted.
    pub fn of(step: &InertialStep, truth: &NavigationState) -> Result<Self> {
        let error = step.error(truth);
        let values = singular(&step.orientation).values;
        Ok(Self {
            squared_position: error.fixed_rows::<3>(3).norm_squared(),
            squared_angle: error.fixed_rows::<3>(0).norm_squared(),
            nees: step.nees(truth)? / 9.0,
            stretch: [values[0], values[2]],
        })
    }
}

/// Sums over trials for one filter at one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct StepTally {
    position: Moments,
    angle: Moments,
    nees: Moments,
    largest: Moments,
    smallest: Moments,
}

impl StepTally {
    fn parts(&mut self) -> [&mut Moments; 5] {
        [&mut self.position, &mut self.angle, &mut self.nees, &mut self.largest, &mut self.smallest]
    }

    fn summary(&self) -> IndoorStepSummary {
        IndoorStepSummary {
            position: self.position.root_mean(),
            angle: self.angle.root_mean(),
            nees: self.nees.mean(),
            largest_singular_value: self.largest.mean(),
            smallest_singular_value: self.smallest.mean(),
        }
    }
}

impl Flat for StepTally {
    const LENGTH: usize = 5 * Moments::LENGTH;

    fn write(&self, to: &mut Vec<f64>) {
        let Self { position, angle, nees, largest, smallest } = self;
        for moments in [position, angle, nees, largest, smallest] {
            moments.write(to);
        }
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        let [position, angle, nees, largest, smallest] = core::array::from_fn(|_| Moments::read(from));
        Self { position, angle, nees, largest, smallest }
    }
}

/// Sums over trials for one filter.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorTally {
    /// Steps of a whole trial.
    length: usize,
    /// One for each of them, or none where only whole trials are looked at.
    steps: Vec<StepTally>,
    /// Root mean square errors over the time of each trial.
    position: Vec<f64>,
    angle: Vec<f64>,
    nees: Moments,
    repairs: Moments,
    failures: usize,
}

impl IndoorTally {
    /// No trials yet, of so many steps each.
    pub(super) fn new(length: usize) -> Self {
        Self { steps: vec![StepTally::default(); length], ..Self::of_whole_trials(length) }
    }

    /// The same, but what happens in each step is not kept.
    pub(super) fn of_whole_trials(length: usize) -> Self {
        Self {
            length,
            steps: Vec::new(),
            position: Vec::new(),
            angle: Vec::new(),
            nees: Moments::default(),
            repairs: Moments::default(),
            failures: 0,
        }
    }

    /// Counts a trial by the errors of its steps; one that ended early is counted as failed and nothing else.
    pub(super) fn push(&mut self, errors: &[StepErrors], repairs: usize) {
        if errors.len() < self.length {
            self.failures += 1;
            return;
        }
        for (tally, error) in self.steps.iter_mut().zip(errors) {
            let [largest, smallest] = error.stretch;
            let values = [error.squared_position, error.squared_angle, error.nees, largest, smallest];
            tally.parts().into_iter().zip(values).for_each(|(moments, value)| moments.push(value));
        }
        let mean = |part: fn(&StepErrors) -> f64| errors.iter().map(part).sum::<f64>() / errors.len() as f64;
        self.position.push(sqrt(mean(|error| error.squared_position)));
        self.angle.push(sqrt(mean(|error| error.squared_angle)));
        self.nees.push(mean(|error| error.nees));
        self.repairs.push(repairs as f64);
    }

    /// Appends the trials of `next`.
    pub(super) fn merge(&mut self, next: &Self) {
        for (mine, theirs) in self.steps.iter_mut().zip(&next.steps) {
            let mut theirs = *theirs;
            mine.parts().into_iter().zip(theirs.parts()).for_each(|(mine, theirs)| mine.merge(theirs));
        }
        self.position.extend(&next.position);
        self.angle.extend(&next.angle);
        self.nees.merge(&next.nees);
        self.repairs.merge(&next.repairs);
        self.failures += next.failures;
    }

    /// The figures so far.
    pub fn summary(&self) -> IndoorSummary {
        let steps: &[StepTally] = if self.position.is_empty() { &[] } else { &self.steps };
        IndoorSummary {
            trials: self.position.len(),
            failures: self.failures,
            position: mean(&self.position),
            angle: mean(&self.angle),
            nees: self.nees.mean(),
            repairs: self.repairs.mean(),
            position_distribution: sorted(&self.position),
            angle_distribution: sorted(&self.angle),
            steps: steps.iter().map(StepTally::summary).collect(),
        }
    }

    /// Appends all numbers.
    pub(super) fn write(&self, to: &mut Vec<f64>) {
        to.extend([self.position.len() as f64, self.failures as f64]);
        to.extend(&self.position);
        to.extend(&self.angle);
        self.nees.write(to);
        self.repairs.write(to);
        self.steps.iter().for_each(|tally| tally.write(to));
    }

    /// Reads back one of the same shape from a row of `most` numbers, which is also more than it can have trials.
    pub(super) fn read_alike(&self, from: &mut Numbers<'_>, most: usize) -> Self {
        let (trials, failures) = (from.count().min(most), from.count());
        Self {
            length: self.length,
            position: (0..trials).map(|_| from.number()).collect(),
            angle: (0..trials).map(|_| from.number()).collect(),
            nees: Moments::read(from),
            repairs: Moments::read(from),
            failures,
            steps: self.steps.iter().map(|_| StepTally::read(from)).collect(),
        }
    }
}

fn mean(values: &[f64]) -> Estimate {
    let mut moments = Moments::default();
    for value in values {
        moments.push(*value);
    }
    moments.mean()
}

fn sorted(values: &[f64]) -> Vec<f64> {
    let mut values = values.to_vec();
    values.sort_unstable_by(f64::total_cmp);
    values
}
