//! What is counted in a block of trials, and how blocks are joined.

use alloc::vec;
use alloc::vec::Vec;

use super::super::flat::{Flat, Numbers};
use super::bounds::{SnapshotBound, figures};
use super::report::{SnapshotBoundSummary, SnapshotSummary};
use super::tally::{SnapshotBoundTally, SnapshotTally};
use super::trial::SnapshotError;
use crate::error::{Error, Result};
use crate::localize::{Snapshot, localize};
use crate::model::epoch::Recording;
use crate::model::noise::RangeNoise;
use crate::model::scenario::Scenario;
use crate::simulate::simulate;

/// Sums over consecutive trials.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalizationBlock {
    first: usize,
    trials: usize,
    /// For each estimator of the settings, point by point.
    estimators: Vec<Vec<SnapshotTally>>,
    /// For each bound, point by point.
    bounds: Vec<Vec<SnapshotBoundTally>>,
}

impl LocalizationBlock {
    /// No trials yet; the next one is number `first`.
    pub fn new(scenario: &Scenario, points: usize, first: usize) -> Self {
        Self {
            first,
            trials: 0,
            estimators: vec![vec![SnapshotTally::default(); points]; scenario.localize.enabled.len()],
            bounds: vec![vec![SnapshotBoundTally::default(); points]; SnapshotBound::ALL.len()],
        }
    }

    /// Runs the trials up to `last`.
    pub(super) fn run<const D: usize>(
        &mut self,
        scenario: &Scenario,
        points: &[RangeNoise],
        last: usize,
    ) -> Result<()> {
        let mut at_point = Scenario { steps: 1, ..scenario.clone() };
        for trial in self.first..last {
            self.trials += 1;
            for (point, &noise) in points.iter().enumerate() {
                at_point.noise = noise;
                self.push(point, &at_point, &simulate::<D>(&at_point, trial as u64)?)?;
            }
        }
        Ok(())
    }

    fn push<const D: usize>(
        &mut self,
        point: usize,
        scenario: &Scenario,
        recording: &Recording<D>,
    ) -> Result<()> {
        let (Some(epoch), Some(Some(truth))) = (recording.epochs.first(), recording.truth.first()) else {
            return Ok(());
        };
        let (model, settings) = (&recording.model, &scenario.localize);
        let mounting_sigma = scenario.mounting_sigma;
        let snapshot = Snapshot::new(model, &epoch.ranges, epoch.weight_ranges())?;
        for (&name, tallies) in settings.enabled.iter().zip(&mut self.estimators) {
            match localize(name, &snapshot, settings, mounting_sigma) {
                Ok(estimate) => tallies[point].push(&SnapshotError::of(&estimate, &snapshot, truth)),
                Err(_) => tallies[point].push_failure(),
            }
        }
        let found = figures(&model.per_pair(), truth, &epoch.ranges, mounting_sigma)?;
        for (tallies, figures) in self.bounds.iter_mut().zip(&found) {
            if let Some(figures) = figures {
                tallies[point].push(figures);
            }
        }
        Ok(())
    }

    /// Appends the trials that come next.
    ///
    /// # Errors
    /// [`Error::Size`] where `next` starts with another trial: sums in another order have other bits.
    pub fn merge(&mut self, next: &Self) -> Result<()> {
        let expected = self.first + self.trials;
        if next.first != expected {
            let what = "trials before the block that is appended";
            return Err(Error::Size { what, found: next.first, expected });
        }
        self.append(next);
        Ok(())
    }

    /// Appends other trials, whichever they are.
    pub(in super::super) fn append(&mut self, next: &Self) {
        self.trials += next.trials;
        let mine = self.estimators.iter_mut().flatten();
        mine.zip(next.estimators.iter().flatten()).for_each(|(tally, next)| tally.merge(next));
        let mine = self.bounds.iter_mut().flatten();
        mine.zip(next.bounds.iter().flatten()).for_each(|(tally, next)| tally.merge(next));
    }

    /// Trials counted so far.
    pub fn trials(&self) -> usize {
        self.trials
    }

    /// The figures of an estimator so far, point by point; they are numbered as in the settings.
    pub fn estimator(&self, index: usize) -> impl Iterator<Item = SnapshotSummary> {
        self.estimators[index].iter().map(SnapshotTally::summary)
    }

    /// The figures of a bound so far, point by point.
    pub fn bound(&self, kind: SnapshotBound) -> impl Iterator<Item = SnapshotBoundSummary> {
        self.bounds[kind as usize].iter().map(SnapshotBoundTally::summary)
    }

    /// How many numbers a block has as a row of numbers.
    pub fn length(scenario: &Scenario, points: usize) -> usize {
        let estimators = scenario.localize.enabled.len();
        2 + points
            * (estimators * SnapshotTally::LENGTH + SnapshotBound::ALL.len() * SnapshotBoundTally::LENGTH)
    }

    /// The block as a row of numbers, from which it comes back as the same bits.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = vec![self.first as f64, self.trials as f64];
        self.estimators.iter().flatten().for_each(|tally| tally.write(&mut numbers));
        self.bounds.iter().flatten().for_each(|tally| tally.write(&mut numbers));
        numbers
    }

    /// The block of [`LocalizationBlock::to_numbers`], for the same scenario and sweep.
    ///
    /// # Errors
    /// [`Error::Size`] where it belongs to another.
    pub fn from_numbers(scenario: &Scenario, points: usize, numbers: &[f64]) -> Result<Self> {
        let (found, expected) = (numbers.len(), Self::length(scenario, points));
        if found != expected {
            return Err(Error::Size { what: "numbers in a block", found, expected });
        }
        let mut from = Numbers::new(numbers);
        let mut block = Self::new(scenario, points, from.count());
        block.trials = from.count();
        block.estimators.iter_mut().flatten().for_each(|tally| *tally = SnapshotTally::read(&mut from));
        block.bounds.iter_mut().flatten().for_each(|tally| *tally = SnapshotBoundTally::read(&mut from));
        Ok(block)
    }
}
