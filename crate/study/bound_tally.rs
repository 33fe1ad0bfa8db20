//! What is counted for one bound at one step over many trials.

use alloc::vec::Vec;

use super::flat::{Flat, Numbers};
use super::moments::Moments;
use super::report::BoundSummary;
use crate::bounds::Bound;

/// Sums over trials for one bound at one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundTally {
    orientation: Moments,
    angle: Moments,
    position: Moments,
}

impl BoundTally {
    /// Counts a bound.
    pub fn push<const D: usize>(&mut self, bound: &Bound<D>) {
        self.orientation.push(bound.orientation_trace);
        self.position.push(bound.position_trace);
        if let Some(variance) = bound.angle_variance {
            self.angle.push(variance);
        }
    }

    /// Appends the trials of `next`.
    pub fn merge(&mut self, next: &Self) {
        self.orientation.merge(&next.orientation);
        self.angle.merge(&next.angle);
        self.position.merge(&next.position);
    }

    /// The figures so far.
    pub fn summary(&self) -> BoundSummary {
        BoundSummary {
            trials: self.orientation.count(),
            orientation: self.orientation.root_mean(),
            angle: self.angle.root_mean(),
            position: self.position.root_mean(),
        }
    }
}

impl Flat for BoundTally {
    const LENGTH: usize = 3 * Moments::LENGTH;

    fn write(&self, to: &mut Vec<f64>) {
        for moments in [self.orientation, self.angle, self.position] {
            moments.write(to);
        }
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        let [orientation, angle, position] = core::array::from_fn(|_| Moments::read(from));
        Self { orientation, angle, position }
    }
}
