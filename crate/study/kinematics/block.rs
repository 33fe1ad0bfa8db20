//! What is counted in a block of trials, and how blocks are joined.

use alloc::vec::Vec;

use super::errors::Yardstick;
use super::report::KinematicsSummary;
use super::tally::{KinematicsTally, Sizes};
use crate::anchorless::estimate;
use crate::error::{Error, Result};
use crate::model::kinematics::KinematicsScenario;
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::settings::KinematicsSettings;
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
        self.trials += next.trials;
        self.estimators.iter_mut().zip(&next.estimators).for_each(|(tally, next)| tally.merge(next));
        Ok(())
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
        let mut numbers = Vec::from([self.first as f64, self.trials as f64]);
        self.estimators.iter().for_each(|tally| tally.write(&mut numbers));
        numbers
    }

    /// The block of [`KinematicsBlock::to_numbers`], for the same scenario.
    ///
    /// # Errors
    /// [`Error::Size`] where it belongs to another scenario.
    pub fn from_numbers(scenario: &KinematicsScenario, numbers: &[f64]) -> Result<Self> {
        let mut from = Numbers::new(numbers);
        let (first, trials) = (from.count(), from.count());
        let (what, found) = ("numbers in a block", numbers.len());
        let enabled = scenario.estimators.enabled.iter();
        let estimators = enabled.map(|_| KinematicsTally::read(&mut from, sizes(scenario), found)).collect();
        let block = Self { first, trials, estimators };
        let expected = block.to_numbers().len();
        if found == expected { Ok(block) } else { Err(Error::Size { what, found, expected }) }
    }
}
