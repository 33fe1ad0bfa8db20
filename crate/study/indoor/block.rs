//! What is counted in a block of trials, and how blocks are joined.

use alloc::vec::Vec;

use super::report::IndoorSummary;
use super::tally::{IndoorTally, StepErrors};
use crate::error::{Error, Result};
use crate::inertial::inertial_filter;
use crate::model::indoor::IndoorScenario;
use crate::model::indoor::epoch::IndoorRecording;
use crate::model::indoor::filter_settings::FilterSettings;
use crate::model::indoor::trajectory::steps;
use crate::study::flat::Numbers;

/// Sums over consecutive trials.
#[derive(Clone, Debug, PartialEq)]
pub struct IndoorBlock {
    first: usize,
    trials: usize,
    /// For each filter of the settings.
    filters: Vec<IndoorTally>,
}

impl IndoorBlock {
    /// No trials yet; the next one is number `first`.
    pub fn new(scenario: &IndoorScenario, first: usize) -> Self {
        let steps = steps(scenario.path, scenario.imu.interval());
        let filters = scenario.filters.enabled.iter().map(|_| IndoorTally::new(steps)).collect();
        Self { first, trials: 0, filters }
    }

    /// Runs every filter over the recording of one trial and counts its errors.
    ///
    /// # Errors
    /// Where the prior of the recording is no covariance. A filter that gives a typed error later, or a covariance without
    /// an inverse, is counted as failed.
    pub fn push(&mut self, recording: &IndoorRecording, settings: &FilterSettings) -> Result<()> {
        self.trials += 1;
        for (&name, tally) in settings.enabled.iter().zip(&mut self.filters) {
            let mut filter = inertial_filter(name, settings, &recording.model, &recording.start)?;
            let mut repairs = 0;
            let mut errors = Vec::with_capacity(recording.epochs.len());
            for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
                let measured = filter.step(epoch).and_then(|step| {
                    repairs += step.events.repairs;
                    StepErrors::of(&step, truth)
                });
                match measured {
                    Ok(measured) => errors.push(measured),
                    Err(_) => break,
                }
            }
            tally.push(&errors, repairs);
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
        self.filters.iter_mut().zip(&next.filters).for_each(|(tally, next)| tally.merge(next));
        Ok(())
    }

    /// Trials counted so far.
    pub fn trials(&self) -> usize {
        self.trials
    }

    /// The figures of a filter so far; they are numbered as in the settings.
    pub fn filter(&self, index: usize) -> IndoorSummary {
        self.filters[index].summary()
    }

    /// The block as a row of numbers, from which it comes back as the same bits.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::from([self.first as f64, self.trials as f64]);
        self.filters.iter().for_each(|tally| tally.write(&mut numbers));
        numbers
    }

    /// The block of [`IndoorBlock::to_numbers`], for the same scenario.
    ///
    /// # Errors
    /// [`Error::Size`] where it belongs to another scenario.
    pub fn from_numbers(scenario: &IndoorScenario, numbers: &[f64]) -> Result<Self> {
        let steps = steps(scenario.path, scenario.imu.interval());
        let mut from = Numbers::new(numbers);
        let (first, trials) = (from.count(), from.count());
        let (what, found) = ("numbers in a block", numbers.len());
        let filters =
            scenario.filters.enabled.iter().map(|_| IndoorTally::read(&mut from, steps, found)).collect();
        let block = Self { first, trials, filters };
        let expected = block.to_numbers().len();
        if found == expected { Ok(block) } else { Err(Error::Size { what, found, expected }) }
    }
}
