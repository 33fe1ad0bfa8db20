//! What is counted in a block of trials, and how blocks are joined.

use alloc::vec;
use alloc::vec::Vec;

use super::bound_tally::BoundTally;
use super::flat::{Flat, Numbers};
use super::report::BoundSummary;
use super::tally::{Summary, Tally};
use crate::bounds::{BoundKind, visit_bounds};
use crate::error::{Error, Result};
use crate::model::epoch::Recording;
use crate::model::estimator_settings::EstimatorSettings;
use crate::model::scenario::Scenario;
use crate::track::estimator;

/// Sums over consecutive trials.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    first: usize,
    trials: usize,
    /// For each estimator of the settings, step by step.
    estimators: Vec<Vec<Tally>>,
    /// For each bound, step by step.
    bounds: Vec<Vec<BoundTally>>,
}

impl Block {
    /// No trials yet; the next one is number `first`.
    pub fn new(scenario: &Scenario, first: usize) -> Self {
        let steps = scenario.steps;
        Self {
            first,
            trials: 0,
            estimators: vec![vec![Tally::default(); steps]; scenario.estimators.enabled.len()],
            bounds: vec![vec![BoundTally::default(); steps]; BoundKind::ALL.len()],
        }
    }

    /// Runs every estimator and bound over the recording of one trial and counts their steps.
    ///
    /// An estimator that gives a typed error is counted as failed from that step on.
    ///
    /// # Errors
    /// When a reported covariance cannot be inverted.
    pub fn push<const D: usize>(
        &mut self,
        recording: &Recording<D>,
        settings: &EstimatorSettings,
    ) -> Result<()> {
        self.trials += 1;
        for (&name, tallies) in settings.enabled.iter().zip(&mut self.estimators) {
            let mut filter = estimator(name, settings, recording);
            let mut failed = false;
            for ((epoch, truth), tally) in recording.epochs.iter().zip(&recording.truth).zip(tallies) {
                let step = if failed { None } else { filter.step(epoch).ok() };
                failed = step.is_none();
                match (step, truth) {
                    (Some(step), Some(truth)) => tally.push(&step, truth)?,
                    (Some(_), None) => (),
                    (None, _) => tally.push_failure(),
                }
            }
        }
        self.push_bounds(recording)
    }

    fn push_bounds<const D: usize>(&mut self, recording: &Recording<D>) -> Result<()> {
        let mut k = 0;
        visit_bounds(recording, |step| {
            for (kind, tallies) in BoundKind::ALL.into_iter().zip(&mut self.bounds) {
                if let Some(Ok(bound)) = step.get(kind) {
                    tallies[k].push(bound);
                }
            }
            k += 1;
        })
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
    pub(super) fn append(&mut self, next: &Self) {
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

    /// The figures of an estimator so far, step by step; they are numbered as in the settings.
    pub fn estimator(&self, index: usize) -> impl Iterator<Item = Summary> {
        self.estimators[index].iter().map(Tally::summary)
    }

    /// The figures of a bound so far, step by step.
    pub fn bound(&self, kind: BoundKind) -> impl Iterator<Item = BoundSummary> {
        self.bounds[kind as usize].iter().map(BoundTally::summary)
    }

    /// How many numbers a block of the scenario has as a row of numbers.
    pub fn length(scenario: &Scenario) -> usize {
        let estimators = scenario.estimators.enabled.len();
        2 + scenario.steps * (estimators * Tally::LENGTH + BoundKind::ALL.len() * BoundTally::LENGTH)
    }

    /// The block as a row of numbers, from which it comes back as the same bits.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = vec![self.first as f64, self.trials as f64];
        self.estimators.iter().flatten().for_each(|tally| tally.write(&mut numbers));
        self.bounds.iter().flatten().for_each(|tally| tally.write(&mut numbers));
        numbers
    }

    /// The block of [`Block::to_numbers`], for the same scenario.
    ///
    /// # Errors
    /// [`Error::Size`] where it belongs to another scenario.
    pub fn from_numbers(scenario: &Scenario, numbers: &[f64]) -> Result<Self> {
        let (what, found, expected) = ("numbers in a block", numbers.len(), Self::length(scenario));
        if found != expected {
            return Err(Error::Size { what, found, expected });
        }
        let mut from = Numbers::new(numbers);
        let mut block = Self::new(scenario, from.count());
        block.trials = from.count();
        block.estimators.iter_mut().flatten().for_each(|tally| *tally = Tally::read(&mut from));
        block.bounds.iter_mut().flatten().for_each(|tally| *tally = BoundTally::read(&mut from));
        Ok(block)
    }
}
