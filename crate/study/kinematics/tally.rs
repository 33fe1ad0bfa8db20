//! What is counted for one estimator over many trials.

use alloc::vec;
use alloc::vec::Vec;

use super::errors::{GRAM_COEFFICIENTS, KinematicsErrors};
use super::report::KinematicsSummary;
use crate::math::float::sqrt;
use crate::study::flat::{Flat, Numbers};
use crate::study::moments::{Estimate, Moments};

/// How many of each kind of error there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// L + 1.
    pub coefficients: usize,
    /// Instants at which positions are compared.
    pub instants: usize,
}

/// Sums over trials for one estimator.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsTally {
    trials: usize,
    failures: usize,
    /// Of `Y_0, Y_1, ...`, of `B_0, B_1, B_2`, of positions with one alignment and each with its own.
    kinds: [Vec<Moments>; 4],
    /// Root mean square errors of `Y_1` of the trials, for their distribution.
    velocities: Vec<f64>,
}

impl KinematicsTally {
    /// No trials yet.
    pub fn new(sizes: Sizes) -> Self {
        let lengths = [sizes.coefficients, GRAM_COEFFICIENTS, sizes.instants, sizes.instants];
        let kinds = lengths.map(|length| vec![Moments::default(); length]);
        Self { trials: 0, failures: 0, kinds, velocities: Vec::new() }
    }

    /// Counts a trial; `None` is one in which the estimator gave a typed error.
    pub fn push(&mut self, errors: Option<&KinematicsErrors>) {
        let Some(errors) = errors else {
            self.failures += 1;
            return;
        };
        self.trials += 1;
        let KinematicsErrors { coefficients, gram, positions, aligned_positions } = errors;
        for (moments, values) in self.kinds.iter_mut().zip([coefficients, gram, positions, aligned_positions])
        {
            moments.iter_mut().zip(values).for_each(|(moments, &value)| moments.push(value));
        }
        self.velocities.extend(coefficients.get(1).map(|&value| sqrt(value)));
    }

    /// Appends the trials of `next`.
    pub fn merge(&mut self, next: &Self) {
        self.trials += next.trials;
        self.failures += next.failures;
        for (mine, theirs) in self.kinds.iter_mut().flatten().zip(next.kinds.iter().flatten()) {
            mine.merge(theirs);
        }
        self.velocities.extend(&next.velocities);
    }

    /// The figures so far.
    pub fn summary(&self) -> KinematicsSummary {
        let [coefficients, gram, positions, aligned_positions] =
            self.kinds.each_ref().map(|kind| roots(kind));
        let mut velocity_distribution = self.velocities.clone();
        velocity_distribution.sort_by(f64::total_cmp);
        KinematicsSummary {
            trials: self.trials,
            failures: self.failures,
            coefficients,
            gram,
            positions,
            aligned_positions,
            velocity_distribution,
        }
    }

    /// Appends all numbers.
    pub fn write(&self, to: &mut Vec<f64>) {
        to.extend([self.trials as f64, self.failures as f64, self.velocities.len() as f64]);
        to.extend(&self.velocities);
        self.kinds.iter().flatten().for_each(|moments| moments.write(to));
    }

    /// Reads them back from a row of `length` numbers, which is also more than it can have trials.
    pub fn read(from: &mut Numbers<'_>, sizes: Sizes, length: usize) -> Self {
        let (trials, failures, velocities) = (from.count(), from.count(), from.count().min(length));
        let mut tally = Self::new(sizes);
        tally.velocities = (0..velocities).map(|_| from.number()).collect();
        tally.kinds.iter_mut().flatten().for_each(|moments| *moments = Moments::read(from));
        Self { trials, failures, ..tally }
    }
}

/// Root mean squares up to where nothing was counted: a motion of degree 0 gives no `B_1`, and none of its errors is zero.
fn roots(moments: &[Moments]) -> Vec<Estimate> {
    moments.iter().take_while(|moments| moments.count() > 0).map(Moments::root_mean).collect()
}
