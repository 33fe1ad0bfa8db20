//! What is counted for the ET-KF at one threshold.

use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::budget::BudgetRow;
use super::error::PoseError;
use super::flat::{Flat, Numbers};
use super::moments::{Estimate, Moments};
use crate::model::epoch::Recording;
use crate::model::estimator_settings::{EstimatorName, EstimatorSettings};
use crate::track::estimator;

/// A figure where a run begins, over all of it, and where it ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AlongRun<T> {
    /// At the first step, at which nothing was known before.
    pub first: T,
    /// The mean square over all steps.
    pub all: T,
    /// At the last step.
    pub last: T,
}

/// Sums over trials.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Spending {
    failures: usize,
    projections: Moments,
    orientation: AlongRun<Moments>,
    angle: AlongRun<Moments>,
}

/// Squared errors of one run.
#[derive(Default)]
struct Squares {
    sum: f64,
    steps: usize,
    ends: Option<(f64, f64)>,
}

impl Spending {
    /// Runs the ET-KF over the recording of one trial.
    pub(super) fn push<const D: usize>(&mut self, recording: &Recording<D>, settings: &EstimatorSettings) {
        let mut filter = estimator(EstimatorName::EtKf, settings, recording);
        let (mut events, mut orientation, mut angle) = (0_u32, Squares::default(), Squares::default());
        for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
            let Ok(step) = filter.step(epoch) else {
                self.failures += 1;
                return;
            };
            events += u32::from(step.event);
            if let Some(truth) = truth {
                let error = PoseError::of(&step, truth);
                orientation.push(error.orientation.norm_squared());
                angle.push(error.angle * error.angle);
            }
        }
        self.projections.push(f64::from(events));
        self.orientation.push(&orientation);
        self.angle.push(&angle);
    }

    pub(super) fn merge(&mut self, next: &Self) {
        self.failures += next.failures;
        self.projections.merge(&next.projections);
        self.orientation.merge(&next.orientation);
        self.angle.merge(&next.angle);
    }

    pub(super) fn row(&self, epsilon: f64) -> BudgetRow {
        BudgetRow {
            epsilon,
            failures: self.failures,
            projections: self.projections.mean(),
            orientation: self.orientation.root_mean(),
            angle: self.angle.root_mean(),
        }
    }
}

impl Squares {
    fn push(&mut self, square: f64) {
        self.sum += square;
        self.steps += 1;
        self.ends = Some((self.ends.map_or(square, |(first, _)| first), square));
    }
}

impl AlongRun<Moments> {
    fn push(&mut self, squares: &Squares) {
        let Some((first, last)) = squares.ends else { return };
        self.first.push(first);
        self.all.push(squares.sum / squares.steps as f64);
        self.last.push(last);
    }

    fn merge(&mut self, next: &Self) {
        self.first.merge(&next.first);
        self.all.merge(&next.all);
        self.last.merge(&next.last);
    }

    fn root_mean(&self) -> AlongRun<Estimate> {
        let Self { first, all, last } = self;
        AlongRun { first: first.root_mean(), all: all.root_mean(), last: last.root_mean() }
    }
}

impl Flat for AlongRun<Moments> {
    const LENGTH: usize = 3 * Moments::LENGTH;

    fn write(&self, to: &mut Vec<f64>) {
        for moments in [self.first, self.all, self.last] {
            moments.write(to);
        }
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        Self { first: Moments::read(from), all: Moments::read(from), last: Moments::read(from) }
    }
}

impl Flat for Spending {
    const LENGTH: usize = 1 + Moments::LENGTH + 2 * AlongRun::<Moments>::LENGTH;

    fn write(&self, to: &mut Vec<f64>) {
        to.push(self.failures as f64);
        self.projections.write(to);
        self.orientation.write(to);
        self.angle.write(to);
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        Self {
            failures: from.count(),
            projections: Moments::read(from),
            orientation: AlongRun::read(from),
            angle: AlongRun::read(from),
        }
    }
}
