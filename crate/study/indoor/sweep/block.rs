//! What is counted in a block of trials of a sweep.

use alloc::vec::Vec;

use super::IndoorSweep;
use crate::error::{Error, Result};
use crate::simulate::indoor::draw;
use crate::study::flat::Numbers;
use crate::study::indoor::block::IndoorBlock;
use crate::study::indoor::report::IndoorSummary;

/// Sums over consecutive trials, point by point.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepBlock {
    points: Vec<IndoorBlock>,
}

impl SweepBlock {
    /// No trials yet; the next one is number `first`.
    pub fn new(sweep: &IndoorSweep, first: usize) -> Self {
        let blocks = sweep.points.iter().map(|point| IndoorBlock::of_whole_trials(&sweep.at(*point), first));
        Self { points: blocks.collect() }
    }

    /// Runs the trials up to `last`.
    pub(super) fn run(&mut self, sweep: &IndoorSweep, last: usize) -> Result<()> {
        for (block, point) in self.points.iter_mut().zip(&sweep.points) {
            let scenario = sweep.at(*point);
            let setup = scenario.setup()?;
            for trial in block.next()..last {
                block.push(&draw(&scenario, &setup, trial as u64), &scenario.filters)?;
            }
        }
        Ok(())
    }

    /// Appends the trials that come next.
    ///
    /// # Errors
    /// [`Error::Size`] where `next` starts with another trial: sums in another order have other bits.
    pub fn merge(&mut self, next: &Self) -> Result<()> {
        self.points.iter_mut().zip(&next.points).try_for_each(|(block, next)| block.merge(next))
    }

    /// Appends other trials, whichever they are.
    pub(in crate::study) fn append(&mut self, next: &Self) {
        self.points.iter_mut().zip(&next.points).for_each(|(block, next)| block.append(next));
    }

    /// Trials counted so far.
    pub fn trials(&self) -> usize {
        self.points.first().map_or(0, IndoorBlock::trials)
    }

    /// The figures of a filter so far, point by point; they are numbered as in the settings.
    pub fn filter(&self, index: usize) -> impl Iterator<Item = IndoorSummary> {
        self.points.iter().map(move |block| block.filter(index))
    }

    /// The block as a row of numbers, from which it comes back as the same bits.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.points.iter().for_each(|block| block.write(&mut numbers));
        numbers
    }

    /// The block of [`SweepBlock::to_numbers`], for the same sweep.
    ///
    /// # Errors
    /// [`Error::Size`] where it belongs to another.
    pub fn from_numbers(sweep: &IndoorSweep, numbers: &[f64]) -> Result<Self> {
        let (what, found) = ("numbers in a block", numbers.len());
        let mut from = Numbers::new(numbers);
        let empty = Self::new(sweep, 0);
        let read =
            Self { points: empty.points.iter().map(|block| block.read_alike(&mut from, found)).collect() };
        let expected = read.to_numbers().len();
        if found == expected { Ok(read) } else { Err(Error::Size { what, found, expected }) }
    }
}
