//! What the projections of the ET-KF buy: errors against projections spent, over a list of thresholds.

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::flat::{Flat, Numbers};
use super::moments::Estimate;
use super::monte_carlo::{MonteCarlo, TRIALS_PER_BLOCK};
use super::spending::{AlongRun, Spending};
use crate::error::{Error, Result};
use crate::model::document::VERSION;
use crate::model::estimator_settings::{EstimatorName, EstimatorSettings, Threshold, ThresholdKind};
use crate::model::scenario::Scenario;
use crate::simulate::simulate;
use crate::with_dimension;

/// The most thresholds of one budget.
pub const MAX_THRESHOLDS: usize = 100;

/// A study of the ET-KF at several thresholds `epsilon`, every trial with the same ranges for all of them.
///
/// What `epsilon` multiplies and what becomes of the projected `Q` are the scenario's settings; whether the scenario
/// enables the ET-KF does not matter.
///
/// ```
/// use rangelab::model::presets::preset;
/// use rangelab::study::budget::Budget;
/// let scenario = preset("tracking-paper")?;
/// let budget = Budget::new(&scenario, &[0.0, 0.15, 1e6], 20)?;
/// let rows = budget.report(&budget.block(0)?).rows;
/// assert_eq!((rows[0].projections.value, rows[2].projections.value), (20.0, 0.0));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Budget<'a> {
    scenario: &'a Scenario,
    trials: usize,
    thresholds: Vec<f64>,
}

/// Sums over consecutive trials.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetBlock {
    first: usize,
    trials: usize,
    thresholds: Vec<Spending>,
}

/// What the thresholds cost and give.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BudgetReport {
    /// Version of the format, 1.
    pub version: u32,
    /// Name of the scenario.
    pub name: String,
    /// Trials that were run.
    pub trials: usize,
    /// What the thresholds multiply.
    pub kind: ThresholdKind,
    /// One entry a threshold, in the order given.
    pub rows: Vec<BudgetRow>,
}

/// The ET-KF at one threshold.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BudgetRow {
    /// The threshold.
    pub epsilon: f64,
    /// Trials that ended in a typed error; they count nowhere else.
    pub failures: usize,
    /// Projections in a run.
    pub projections: Estimate,
    /// `RMSE(Q) = sqrt(mean ||Q_hat - Q||_F^2)`.
    pub orientation: AlongRun<Estimate>,
    /// Root mean square rotation angle, rad.
    pub angle: AlongRun<Estimate>,
}

impl<'a> Budget<'a> {
    /// Prepares a study.
    ///
    /// # Errors
    /// Where the scenario is not valid, the number of trials is 0 or above
    /// [`super::monte_carlo::MAX_TRIALS`], there are no or more than [`MAX_THRESHOLDS`] thresholds, or one of them is
    /// negative or beyond a million.
    pub fn new(scenario: &'a Scenario, thresholds: &[f64], trials: usize) -> Result<Self> {
        MonteCarlo::new(scenario, trials)?;
        let (what, count) = ("the number of thresholds", thresholds.len());
        if !(1..=MAX_THRESHOLDS).contains(&count) {
            return Err(Error::Number { what, value: count as f64, limit: "from 1 to 100" });
        }
        match thresholds.iter().find(|&epsilon| !(0.0..=1e6).contains(epsilon)) {
            None => Ok(Self { scenario, trials, thresholds: thresholds.to_vec() }),
            Some(&value) => Err(Error::Number { what: "a threshold", value, limit: "from 0 to 1000000" }),
        }
    }

    /// How many blocks of [`TRIALS_PER_BLOCK`] trials there are.
    pub fn blocks(&self) -> usize {
        self.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    /// The sum of no trials, to which blocks are joined in their order.
    pub fn start(&self) -> BudgetBlock {
        BudgetBlock::new(self.thresholds.len(), 0)
    }

    /// Runs block `index`, from 0.
    ///
    /// # Errors
    /// When a simulated recording is beyond double precision.
    pub fn block(&self, index: usize) -> Result<BudgetBlock> {
        let first = index * TRIALS_PER_BLOCK;
        let mut block = BudgetBlock::new(self.thresholds.len(), first);
        let settings: Vec<_> = self.thresholds.iter().map(|&epsilon| self.settings(epsilon)).collect();
        with_dimension!(self.scenario.dimension, D => {
            for trial in first..self.trials.min(first + TRIALS_PER_BLOCK) {
                let recording = simulate::<D>(self.scenario, trial as u64)?;
                block.trials += 1;
                for (settings, spending) in settings.iter().zip(&mut block.thresholds) {
                    spending.push(&recording, settings);
                }
            }
            Ok(block)
        })
    }

    fn settings(&self, epsilon: f64) -> EstimatorSettings {
        let given = &self.scenario.estimators;
        EstimatorSettings {
            enabled: vec![EstimatorName::EtKf],
            threshold: Threshold { epsilon, ..given.threshold },
            ..given.clone()
        }
    }

    /// The figures of the blocks joined so far.
    pub fn report(&self, done: &BudgetBlock) -> BudgetReport {
        let rows = self.thresholds.iter().zip(&done.thresholds);
        BudgetReport {
            version: VERSION,
            name: self.scenario.name.clone(),
            trials: done.trials,
            kind: self.scenario.estimators.threshold.kind,
            rows: rows.map(|(&epsilon, spending)| spending.row(epsilon)).collect(),
        }
    }
}

impl BudgetBlock {
    fn new(thresholds: usize, first: usize) -> Self {
        Self { first, trials: 0, thresholds: vec![Spending::default(); thresholds] }
    }

    /// Appends the trials that come next.
    ///
    /// # Errors
    /// [`Error::Size`] where `next` starts with another trial, or has other thresholds.
    pub fn merge(&mut self, next: &Self) -> Result<()> {
        let (found, expected) = (next.first, self.first + self.trials);
        if found != expected {
            return Err(Error::Size { what: "trials before the block that is appended", found, expected });
        }
        let (found, expected) = (next.thresholds.len(), self.thresholds.len());
        if found != expected {
            return Err(Error::Size { what: "thresholds in a block", found, expected });
        }
        self.trials += next.trials;
        self.thresholds.iter_mut().zip(&next.thresholds).for_each(|(mine, next)| mine.merge(next));
        Ok(())
    }

    /// Trials counted so far.
    pub fn trials(&self) -> usize {
        self.trials
    }

    /// How many numbers a block has as a row of numbers.
    pub fn length(thresholds: usize) -> usize {
        2 + thresholds * Spending::LENGTH
    }

    /// The block as a row of numbers, from which it comes back as the same bits.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = vec![self.first as f64, self.trials as f64];
        self.thresholds.iter().for_each(|spending| spending.write(&mut numbers));
        numbers
    }

    /// The block of [`BudgetBlock::to_numbers`], for as many thresholds.
    ///
    /// # Errors
    /// [`Error::Size`] where it has other thresholds.
    pub fn from_numbers(thresholds: usize, numbers: &[f64]) -> Result<Self> {
        let (found, expected) = (numbers.len(), Self::length(thresholds));
        if found != expected {
            return Err(Error::Size { what: "numbers in a block", found, expected });
        }
        let mut from = Numbers::new(numbers);
        let mut block = Self::new(thresholds, from.count());
        block.trials = from.count();
        block.thresholds.iter_mut().for_each(|spending| *spending = Spending::read(&mut from));
        Ok(block)
    }
}
