//! Monte-Carlo of an indoor scenario, in blocks of trials: any number of workers, one result.

use alloc::string::ToString;

use super::block::IndoorBlock;
use super::report::{IndoorFilterReport, IndoorReport};
use crate::error::{Error, Result};
use crate::model::document::VERSION;
use crate::model::indoor::{IndoorScenario, IndoorSetup};
use crate::simulate::indoor::draw;
use crate::study::monte_carlo::{MAX_TRIALS, TRIALS_PER_BLOCK};

/// A study of one indoor scenario: trial `i` is the scenario's seed with random stream `i`.
#[derive(Clone, Debug)]
pub struct IndoorMonteCarlo<'a> {
    scenario: &'a IndoorScenario,
    setup: IndoorSetup,
    trials: usize,
}

impl<'a> IndoorMonteCarlo<'a> {
    /// Prepares a study.
    ///
    /// # Errors
    /// When the scenario is not valid, or the number of trials is 0 or above [`MAX_TRIALS`].
    pub fn new(scenario: &'a IndoorScenario, trials: usize) -> Result<Self> {
        if !(1..=MAX_TRIALS).contains(&trials) {
            let limit = "from 1 to 1000000";
            return Err(Error::Number { what: "the number of trials", value: trials as f64, limit });
        }
        Ok(Self { scenario, setup: scenario.setup()?, trials })
    }

    /// How many blocks there are.
    pub fn blocks(&self) -> usize {
        self.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    /// The sum of no trials, to which blocks are joined in their order.
    pub fn start(&self) -> IndoorBlock {
        IndoorBlock::new(self.scenario, 0)
    }

    /// Runs block `index`, from 0.
    ///
    /// # Errors
    /// As [`IndoorBlock::push`].
    pub fn block(&self, index: usize) -> Result<IndoorBlock> {
        let first = index * TRIALS_PER_BLOCK;
        let mut block = IndoorBlock::new(self.scenario, first);
        for trial in first..self.trials.min(first + TRIALS_PER_BLOCK) {
            block.push(&draw(self.scenario, &self.setup, trial as u64), &self.scenario.filters)?;
        }
        Ok(block)
    }

    /// All blocks, one after the other.
    ///
    /// # Errors
    /// As [`IndoorBlock::push`].
    pub fn run(&self) -> Result<IndoorReport> {
        let mut done = self.start();
        for index in 0..self.blocks() {
            done.merge(&self.block(index)?)?;
        }
        Ok(self.report(&done))
    }

    /// The figures of the blocks joined so far.
    pub fn report(&self, done: &IndoorBlock) -> IndoorReport {
        let interval = self.setup.interval;
        let filters = self.scenario.filters.enabled.iter().enumerate();
        IndoorReport {
            version: VERSION,
            name: self.scenario.name.clone(),
            trials: done.trials(),
            times: (1..self.setup.truth.len()).map(|k| k as f64 * interval).collect(),
            filters: filters
                .map(|(index, name)| IndoorFilterReport {
                    name: *name,
                    label: name.label().to_string(),
                    summary: done.filter(index),
                })
                .collect(),
        }
    }
}
