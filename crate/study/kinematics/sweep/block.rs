//! What is counted in a block of trials of a sweep.

use alloc::vec::Vec;

use super::KinematicsSweep;
use crate::error::{Error, Result};
use crate::study::flat::Numbers;
use crate::study::kinematics::block::KinematicsBlock;
use crate::study::kinematics::bounds::KinematicsBoundReport;

/// Sums over consecutive trials, K by K.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsSweepBlock {
    points: Vec<KinematicsBlock>,
    /// Of each K, where the sum of all blocks began with them; they are no sums and do not travel.
    bounds: Vec<[KinematicsBoundReport; 2]>,
}

impl KinematicsSweepBlock {
    /// No trials yet; the next one is number `first`.
    pub(super) fn new(
        sweep: &KinematicsSweep,
        first: usize,
        bounds: Vec<[KinematicsBoundReport; 2]>,
    ) -> Self {
        let points = sweep.points.iter().map(|_| KinematicsBlock::new(&sweep.scenario, first));
        Self { points: points.collect(), bounds }
    }

    /// Runs the trials up to `last`.
    pub(super) fn run(&mut self, sweep: &KinematicsSweep, last: usize) -> Result<()> {
        for (block, point) in self.points.iter_mut().zip(&sweep.points) {
            block.run(&sweep.scenario, &point.setup, &point.yardstick, last)?;
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
        self.points.first().map_or(0, KinematicsBlock::trials)
    }

    /// The sums at each K.
    pub(super) fn points(&self) -> &[KinematicsBlock] {
        &self.points
    }

    /// The bounds at each K; none for a block that the sum did not begin with.
    pub(super) fn bounds(&self) -> &[[KinematicsBoundReport; 2]] {
        &self.bounds
    }

    /// The sums as a row of numbers, from which they come back as the same bits.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.points.iter().for_each(|block| block.write(&mut numbers));
        numbers
    }

    /// The sums of [`KinematicsSweepBlock::to_numbers`], for the same sweep.
    ///
    /// # Errors
    /// [`Error::Size`] where they belong to another.
    pub fn from_numbers(sweep: &KinematicsSweep, numbers: &[f64]) -> Result<Self> {
        let (what, found) = ("numbers in a block", numbers.len());
        let mut from = Numbers::new(numbers);
        let points = sweep.points.iter().map(|_| KinematicsBlock::read(&sweep.scenario, &mut from, found));
        let read = Self { points: points.collect(), bounds: Vec::new() };
        let expected = read.to_numbers().len();
        if found == expected { Ok(read) } else { Err(Error::Size { what, found, expected }) }
    }
}
