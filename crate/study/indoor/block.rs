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
        Self::counted_by(IndoorTally::new, scenario, first)
    }

    /// The same, but what happens in each step is not kept.
    pub(super) fn of_whole_trials(scenario: &IndoorScenario, first: usize) -> Self {
        Self::counted_by(IndoorTally::of_whole_trials, scenario, first)
    }

    fn counted_by(tally: fn(usize) -> IndoorTally, scenario: &IndoorScenario, first: usize) -> Self {
        let length = steps(scenario.path, scenario.imu.interval());
        Self { first, trials: 0, filters: scenario.filters.enabled.iter().map(|_| tally(length)).collect() }
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
        let expected = self.next();
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
        self.filters.iter_mut().zip(&next.filters).for_each(|(tally, next)| tally.merge(next));
    }

    /// The number of the trial that comes next.
    pub(super) fn next(&self) -> usize {
        self.first + self.trials
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
        let mut numbers = Vec::new();
        self.write(&mut numbers);
        numbers
    }

    /// Appends all numbers.
    pub(super) fn write(&self, to: &mut Vec<f64>) {
        to.extend([self.first as f64, self.trials as f64]);
        self.filters.iter().for_each(|tally| tally.write(to));
    }

    /// Reads back one of the same shape from a row of `most` numbers.
    pub(super) fn read_alike(&self, from: &mut Numbers<'_>, most: usize) -> Self {
        let (first, trials) = (from.count(), from.count());
        let filters = self.filters.iter().map(|tally| tally.read_alike(from, most)).collect();
        Self { first, trials, filters }
    }

    /// The block of [`IndoorBlock::to_numbers`], for the same scenario.
    ///
    /// # Errors
    /// [`Error::Size`] where it belongs to another scenario.
    pub fn from_numbers(scenario: &IndoorScenario, numbers: &[f64]) -> Result<Self> {
        let (what, found) = ("numbers in a block", numbers.len());
        let block = Self::new(scenario, 0).read_alike(&mut Numbers::new(numbers), found);
        let expected = block.to_numbers().len();
        if found == expected { Ok(block) } else { Err(Error::Size { what, found, expected }) }
    }
}
