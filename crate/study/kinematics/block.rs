//! What is counted in a block of trials, and how blocks are joined.

use alloc::vec::Vec;

use super::errors::Yardstick;
use super::report::KinematicsSummary;
use super::tally::{KinematicsTally, Sizes};
use crate::anchorless::estimate;
use crate::error::{Error, Result};
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::settings::KinematicsSettings;
use crate::model::kinematics::{KinematicsScenario, KinematicsSetup};
use crate::simulate::kinematics::draw;
use crate::study::flat::Numbers;

/// Sums over consecutive trials.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsBlock {
    first: usize,
    trials: usize,
    /// For each estimator of the settings.
    estimators: Vec<KinematicsTally>,
}

fn sizes(scenario: &KinematicsScenario) -> Sizes {
    let coefficients = scenario.degree().max(scenario.estimators.degree) + 1;
    Sizes { coefficients, instants: scenario.steps }
}

impl KinematicsBlock {
    /// No trials yet; the next one is number `first`.
    pub fn new(scenario: &KinematicsScenario, first: usize) -> Self {
        let enabled = &scenario.estimators.enabled;
        let estimators = enabled.iter().map(|_| KinematicsTally::new(sizes(scenario))).collect();
        Self { first, trials: 0, estimators }
    }

    /// Runs every estimator on the record of one trial and counts its errors; one that gives a typed error is counted as
    /// failed.
    ///
    /// # Errors
    /// As [`Yardstick::errors`].
    pub fn push(
        &mut self,
        record: &DistanceRecord,
        yardstick: &Yardstick,
        settings: &KinematicsSettings,
    ) -> Result<()> {
        self.trials += 1;
        for (&name, tally) in settings.enabled.iter().zip(&mut self.estimators) {
            let found = estimate(name, settings, record).ok();
            let errors = found.map(|found| yardstick.errors(&found)).transpose()?;
            tally.push(errors.as_ref());
        }
        Ok(())
    }

    /// Draws the trials up to `last` and counts them.
    ///
    /// # Errors
    /// [`Error::Number`] where a distance overflows.
    pub fn run(
        &mut self,
        scenario: &KinematicsScenario,
        setup: &KinematicsSetup,
        yardstick: &Yardstick,
        last: usize,
    ) -> Result<()> {
        for trial in self.first + self.trials..last {
            let drawn = draw(scenario, setup, trial as u64)?;
            self.push(&drawn.record, yardstick, &scenario.estimators)?;
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
    pub(super) fn append(&mut self, next: &Self) {
        self.trials += next.trials;
        self.estimators.iter_mut().zip(&next.estimators).for_each(|(tally, next)| tally.merge(next));
    }

    /// Trials counted so far.
    pub fn trials(&self) -> usize {
        self.trials
    }

    /// The figures of an estimator so far; they are numbered as in the settings.
    pub fn estimator(&self, index: usize) -> KinematicsSummary {
        self.estimators[index].summary()
    }

    /// The block as a row of numbers, from which it comes back as the same bits.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.write(&mut numbers);
        numbers
    }

    /// Appends all numbers.
    pub(super) fn write(&self, to: &mut Vec<f64>) {
        to.extend([self.first as f64, self.trials as f64]);
        self.estimators.iter().for_each(|tally| tally.write(to));
    }

    /// Reads one back from a row of `length` numbers.
    pub(super) fn read(scenario: &KinematicsScenario, from: &mut Numbers<'_>, length: usize) -> Self {
        let (first, trials) = (from.count(), from.count());
        let enabled = scenario.estimators.enabled.iter();
        let estimators = enabled.map(|_| KinematicsTally::read(from, sizes(scenario), length)).collect();
        Self { first, trials, estimators }
    }

    /// The block of [`KinematicsBlock::to_numbers`], for the same scenario.
    ///
    /// # Errors
    /// [`Error::Size`] where it belongs to another scenario.
    pub fn from_numbers(scenario: &KinematicsScenario, numbers: &[f64]) -> Result<Self> {
        let (what, found) = ("numbers in a block", numbers.len());
        let block = Self::read(scenario, &mut Numbers::new(numbers), found);
        let expected = block.to_numbers().len();
        if found == expected { Ok(block) } else { Err(Error::Size { what, found, expected }) }
    }
}
