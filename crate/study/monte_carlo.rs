//! Monte-Carlo in blocks of trials: any number of workers, one result.

use alloc::vec::Vec;

use super::tally::{StepTallies, Tally};
use crate::error::Result;
use crate::model::epoch::Recording;
use crate::model::estimator_settings::EstimatorSettings;
use crate::track::estimator;

/// Trials of one block. Blocks are summed in their own order and joined in order, so that the result does not depend on
/// who computed which.
pub const TRIALS_PER_BLOCK: usize = 20;

/// Tallies of one block: for each estimator of the settings, step by step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block<const D: usize> {
    /// In the order of the settings' estimators.
    pub estimators: Vec<StepTallies<D>>,
}

impl<const D: usize> Block<D> {
    /// Runs every estimator over one recording and counts its steps.
    ///
    /// An estimator that gives a typed error is counted as failed from that step on.
    ///
    /// # Errors
    /// When a reported covariance cannot be inverted.
    pub fn push(&mut self, recording: &Recording<D>, settings: &EstimatorSettings) -> Result<()> {
        self.estimators.resize_with(settings.enabled.len(), Vec::new);
        for (&name, tallies) in settings.enabled.iter().zip(&mut self.estimators) {
            tallies.resize_with(recording.epochs.len(), Tally::default);
            let mut filter = estimator(name, settings, recording);
            let mut failed = false;
            for ((epoch, truth), tally) in recording.epochs.iter().zip(&recording.truth).zip(tallies) {
                let step = if failed { None } else { filter.step(epoch).ok() };
                failed = step.is_none();
                match (step, truth) {
                    (Some(step), Some(truth)) => tally.push(&step, truth)?,
                    (Some(_), None) => (),
                    (None, _) => tally.push_failure(),
                }
            }
        }
        Ok(())
    }

    /// Appends the next block.
    pub fn merge(&mut self, next: &Self) {
        if self.estimators.is_empty() {
            self.estimators.clone_from(&next.estimators);
            return;
        }
        for (mine, theirs) in self.estimators.iter_mut().zip(&next.estimators) {
            for (tally, next) in mine.iter_mut().zip(theirs) {
                tally.merge(next);
            }
        }
    }
}
