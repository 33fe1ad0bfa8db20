//! Monte-Carlo in blocks of trials: any number of workers, one result.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::bound_tally::BoundTally;
use super::report::{BoundReport, EstimatorReport, StudyReport};
use super::tally::Tally;
use crate::bounds::{BoundKind, bounds_along};
use crate::error::{Error, Result};
use crate::model::document::VERSION;
use crate::model::epoch::Recording;
use crate::model::estimator_settings::EstimatorSettings;
use crate::model::scenario::Scenario;
use crate::simulate::simulate;
use crate::track::estimator;

/// Trials of one block. Blocks are summed in their own order and joined in order, so that the result does not depend on
/// who computed which.
pub const TRIALS_PER_BLOCK: usize = 20;

/// The most trials of one study.
pub const MAX_TRIALS: usize = 1_000_000;

/// A study of one scenario: trial `i` is the scenario's seed with random stream `i`.
#[derive(Clone, Debug)]
pub struct MonteCarlo<'a, const D: usize> {
    scenario: &'a Scenario,
    trials: usize,
}

/// Tallies of one or more blocks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block<const D: usize> {
    trials: usize,
    /// For each estimator of the settings, step by step.
    estimators: Vec<Vec<Tally<D>>>,
    /// For each bound, step by step.
    bounds: Vec<Vec<BoundTally>>,
}

impl<'a, const D: usize> MonteCarlo<'a, D> {
    /// Prepares a study.
    ///
    /// # Errors
    /// When the scenario is not valid or not of dimension `D`, or the number of trials is 0 or above [`MAX_TRIALS`].
    pub fn new(scenario: &'a Scenario, trials: usize) -> Result<Self> {
        if !(1..=MAX_TRIALS).contains(&trials) {
            let limit = "from 1 to 1000000";
            return Err(Error::Number { what: "the number of trials", value: trials as f64, limit });
        }
        scenario.setup::<D>()?;
        Ok(Self { scenario, trials })
    }

    /// How many blocks there are.
    pub fn blocks(&self) -> usize {
        self.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    /// Runs block `index`, from 0.
    ///
    /// # Errors
    /// When a simulated recording or a reported covariance is beyond double precision.
    pub fn block(&self, index: usize) -> Result<Block<D>> {
        let first = index * TRIALS_PER_BLOCK;
        let mut block = Block::default();
        for trial in first..self.trials.min(first + TRIALS_PER_BLOCK) {
            block.push(&simulate::<D>(self.scenario, trial as u64)?, &self.scenario.estimators)?;
        }
        Ok(block)
    }

    /// The figures of the blocks joined so far.
    pub fn report(&self, done: &Block<D>) -> StudyReport {
        let estimators = self.scenario.estimators.enabled.iter().zip(&done.estimators);
        let bounds = BoundKind::ALL.into_iter().zip(&done.bounds);
        StudyReport {
            version: VERSION,
            name: self.scenario.name.clone(),
            trials: done.trials,
            estimators: estimators
                .map(|(name, tallies)| EstimatorReport {
                    name: *name,
                    label: name.label().to_string(),
                    steps: tallies.iter().map(Tally::summary).collect(),
                })
                .collect(),
            bounds: bounds
                .map(|(kind, tallies)| BoundReport {
                    name: kind.name().to_string(),
                    label: kind.label().to_string(),
                    steps: tallies.iter().map(BoundTally::summary).collect(),
                })
                .collect(),
        }
    }
}

impl<const D: usize> Block<D> {
    /// Runs every estimator and bound over one recording and counts their steps.
    ///
    /// An estimator that gives a typed error is counted as failed from that step on.
    ///
    /// # Errors
    /// When a reported covariance cannot be inverted.
    pub fn push(&mut self, recording: &Recording<D>, settings: &EstimatorSettings) -> Result<()> {
        let steps = recording.epochs.len();
        self.trials += 1;
        self.estimators.resize_with(settings.enabled.len(), Vec::new);
        for (&name, tallies) in settings.enabled.iter().zip(&mut self.estimators) {
            tallies.resize_with(steps, Tally::default);
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

    fn push_bounds(&mut self, recording: &Recording<D>) -> Result<()> {
        self.bounds.resize_with(BoundKind::ALL.len(), Vec::new);
        let along = bounds_along(recording)?;
        for (kind, tallies) in BoundKind::ALL.into_iter().zip(&mut self.bounds) {
            tallies.resize_with(along.len(), BoundTally::default);
            for (step, tally) in along.iter().zip(tallies) {
                if let Some(Ok(bound)) = step.get(kind) {
                    tally.push(bound);
                }
            }
        }
        Ok(())
    }

    /// Appends the next block.
    pub fn merge(&mut self, next: &Self) {
        if self.trials == 0 {
            self.clone_from(next);
            return;
        }
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
}
