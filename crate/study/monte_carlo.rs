//! Monte-Carlo in blocks of trials: any number of workers, one result.

use alloc::string::ToString;

use super::block::Block;
use super::report::{BoundReport, EstimatorReport, StudyReport};
use crate::bounds::BoundKind;
use crate::error::{Error, Result};
use crate::model::document::VERSION;
use crate::model::scenario::Scenario;
use crate::simulate::simulate;
use crate::with_dimension;

/// Trials of one block. Blocks are summed in their own order and joined in order, so that the result does not depend on
/// who computed which.
pub const TRIALS_PER_BLOCK: usize = 20;

/// The most trials of one study.
pub const MAX_TRIALS: usize = 1_000_000;

/// A study of one scenario: trial `i` is the scenario's seed with random stream `i`.
#[derive(Clone, Debug)]
pub struct MonteCarlo<'a> {
    scenario: &'a Scenario,
    trials: usize,
}

impl<'a> MonteCarlo<'a> {
    /// Prepares a study.
    ///
    /// # Errors
    /// When the scenario is not valid, or the number of trials is 0 or above [`MAX_TRIALS`].
    pub fn new(scenario: &'a Scenario, trials: usize) -> Result<Self> {
        if !(1..=MAX_TRIALS).contains(&trials) {
            let limit = "from 1 to 1000000";
            return Err(Error::Number { what: "the number of trials", value: trials as f64, limit });
        }
        with_dimension!(scenario.dimension, D => scenario.setup::<D>().map(drop))?;
        Ok(Self { scenario, trials })
    }

    /// How many blocks there are.
    pub fn blocks(&self) -> usize {
        self.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    /// The sum of no trials, to which blocks are joined in their order.
    pub fn start(&self) -> Block {
        Block::new(self.scenario, 0)
    }

    /// Runs block `index`, from 0.
    ///
    /// # Errors
    /// When a simulated recording or a reported covariance is beyond double precision.
    pub fn block(&self, index: usize) -> Result<Block> {
        let first = index * TRIALS_PER_BLOCK;
        let mut block = Block::new(self.scenario, first);
        with_dimension!(self.scenario.dimension, D => {
            for trial in first..self.trials.min(first + TRIALS_PER_BLOCK) {
                block.push(&simulate::<D>(self.scenario, trial as u64)?, &self.scenario.estimators)?;
            }
            Ok(block)
        })
    }

    /// The figures of the blocks joined so far.
    pub fn report(&self, done: &Block) -> StudyReport {
        let estimators = self.scenario.estimators.enabled.iter().enumerate();
        StudyReport {
            version: VERSION,
            name: self.scenario.name.clone(),
            trials: done.trials(),
            estimators: estimators
                .map(|(index, name)| EstimatorReport {
                    name: *name,
                    label: name.label().to_string(),
                    steps: done.estimator(index).collect(),
                })
                .collect(),
            bounds: BoundKind::ALL
                .map(|kind| BoundReport {
                    name: kind.name().to_string(),
                    label: kind.label().to_string(),
                    steps: done.bound(kind).collect(),
                })
                .into(),
        }
    }
}
