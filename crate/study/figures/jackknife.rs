//! Standard errors of whatever is computed from a study, by leaving out a part of its trials at a time.
//!
//! Two estimators see the same ranges, so that their errors rise and fall together and their ratio is known far better than
//! either. What is computed without one of `G` groups of trials, for each of them, tells by how much it varies:
//! `se^2 = (G-1)/G sum_g (x_g - mean)^2` (B. Efron, *The Jackknife, the Bootstrap and Other Resampling Plans*, 1982).

use alloc::vec::Vec;

use super::claim::Claim;
use super::experiment::Sums;
use crate::error::Result;
use crate::math::float::sqrt;
use crate::study::moments::Estimate;

/// So many groups at most: enough for the standard error of a standard error to be a tenth.
const GROUPS: usize = 50;
/// With fewer, the jackknife says too little.
const LEAST_GROUPS: usize = 10;
/// With fewer, a standard error says too little: of a single trial it would be zero.
const LEAST_TRIALS: usize = 20;

/// The sums of a study, in groups of blocks that come one after another.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Groups {
    start: Sums,
    blocks_per_group: usize,
    blocks: usize,
    sums: Vec<Sums>,
}

impl Groups {
    /// No trials yet of a study of so many blocks.
    pub(super) fn new(start: Sums, blocks: usize) -> Self {
        Self { start, blocks_per_group: blocks.div_ceil(GROUPS).max(1), blocks: 0, sums: Vec::new() }
    }

    /// Joins the block that comes next.
    pub(super) fn merge(&mut self, next: &Sums) -> Result<()> {
        let opens = self.blocks.is_multiple_of(self.blocks_per_group);
        match self.sums.last_mut().filter(|_| !opens) {
            Some(group) => group.merge(next)?,
            None => self.sums.push(next.clone()),
        }
        self.blocks += 1;
        Ok(())
    }

    /// All trials.
    pub(super) fn total(&self) -> Sums {
        self.sums.iter().fold(self.start.clone(), |mut total, group| {
            total.append(group);
            total
        })
    }

    /// For each group, all trials but its own.
    pub(super) fn without_each(&self) -> Vec<Sums> {
        let mut after: Vec<Sums> = Vec::with_capacity(self.sums.len());
        for group in self.sums.iter().rev() {
            let mut sum = group.clone();
            after.last().into_iter().for_each(|rest| sum.append(rest));
            after.push(sum);
        }
        after.reverse();
        let mut before = self.start.clone();
        let without = self.sums.iter().enumerate().map(|(i, group)| {
            let mut sum = before.clone();
            after.get(i + 1).into_iter().for_each(|rest| sum.append(rest));
            before.append(group);
            sum
        });
        without.collect()
    }
}

/// The claims with the standard errors that come from those without each group. A claim that needs the trials of a group
/// to have a number at all keeps its own standard error. Of few trials only what does not depend on them is decided: a
/// ratio of bounds.
pub(super) fn jackknifed(claims: Vec<Claim>, without: &[Vec<Claim>], trials: usize) -> Vec<Claim> {
    let each = claims.into_iter().enumerate();
    each.map(|(i, claim)| {
        let values: Option<Vec<f64>> = without.iter().map(|claims| Some(claims[i].found?.value)).collect();
        let values = values.unwrap_or_default();
        if let Some(found) = claim.found.filter(|_| !values.is_empty()) {
            if values.iter().all(|value| value.to_bits() == found.value.to_bits()) {
                return claim;
            }
            if values.len() >= LEAST_GROUPS {
                let found = Estimate { standard_error: spread(&values), ..found };
                return Claim::new(claim.source, claim.what, Some(found), claim.target);
            }
        }
        if trials < LEAST_TRIALS { claim.undecided() } else { claim }
    })
    .collect()
}

fn spread(values: &[f64]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    sqrt((count - 1.0) / count * squares)
}
