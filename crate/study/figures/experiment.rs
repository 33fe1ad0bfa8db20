//! What a figure simulates: trackers over the steps of a scenario, or snapshot estimators over a sweep of the noise.

use alloc::vec::Vec;

use crate::error::Result;
use crate::model::scenario::Scenario;
use crate::study::block::Block;
use crate::study::localization::report::LocalizationReport;
use crate::study::localization::{LocalizationBlock, LocalizationStudy, paper_sweep};
use crate::study::monte_carlo::MonteCarlo;
use crate::study::report::StudyReport;

/// A scenario and what is done with it.
#[derive(Clone, Debug)]
pub(super) enum Experiment {
    /// Trackers, step by step.
    Track(Scenario),
    /// Snapshot estimators at each noise of [`paper_sweep`].
    Sweep(Scenario),
}

/// Sums over consecutive trials of an experiment.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Sums {
    Track(Block),
    Sweep(LocalizationBlock),
}

/// What an experiment found.
#[derive(Clone, Debug, PartialEq)]
pub enum Study {
    /// Trackers, step by step.
    Track(StudyReport),
    /// Snapshot estimators, noise by noise.
    Sweep(LocalizationReport),
}

impl Experiment {
    pub(super) fn scenario(&self) -> &Scenario {
        match self {
            Self::Track(scenario) | Self::Sweep(scenario) => scenario,
        }
    }

    pub(super) fn with_seed(mut self, seed: u64) -> Self {
        match &mut self {
            Self::Track(scenario) | Self::Sweep(scenario) => scenario.seed = seed,
        }
        self
    }

    /// How many blocks so many trials have.
    pub(super) fn blocks(&self, trials: usize) -> Result<usize> {
        Ok(match self {
            Self::Track(scenario) => MonteCarlo::new(scenario, trials)?.blocks(),
            Self::Sweep(scenario) => LocalizationStudy::new(scenario, paper_sweep(), trials)?.blocks(),
        })
    }

    /// No trials yet.
    pub(super) fn start(&self) -> Sums {
        match self {
            Self::Track(scenario) => Sums::Track(Block::new(scenario, 0)),
            Self::Sweep(scenario) => Sums::Sweep(LocalizationBlock::new(scenario, paper_sweep().len(), 0)),
        }
    }

    /// Block `index` of so many trials.
    pub(super) fn block(&self, trials: usize, index: usize) -> Result<Sums> {
        Ok(match self {
            Self::Track(scenario) => Sums::Track(MonteCarlo::new(scenario, trials)?.block(index)?),
            Self::Sweep(scenario) => {
                Sums::Sweep(LocalizationStudy::new(scenario, paper_sweep(), trials)?.block(index)?)
            }
        })
    }

    /// The block of [`Sums::to_numbers`].
    pub(super) fn read(&self, numbers: &[f64]) -> Result<Sums> {
        Ok(match self {
            Self::Track(scenario) => Sums::Track(Block::from_numbers(scenario, numbers)?),
            Self::Sweep(scenario) => {
                Sums::Sweep(LocalizationBlock::from_numbers(scenario, paper_sweep().len(), numbers)?)
            }
        })
    }

    /// What was found; nothing where the sums are of another experiment.
    pub(super) fn report(&self, trials: usize, sums: &Sums) -> Result<Option<Study>> {
        Ok(match (self, sums) {
            (Self::Track(scenario), Sums::Track(block)) => {
                Some(Study::Track(MonteCarlo::new(scenario, trials)?.report(block)))
            }
            (Self::Sweep(scenario), Sums::Sweep(block)) => {
                Some(Study::Sweep(LocalizationStudy::new(scenario, paper_sweep(), trials)?.report(block)))
            }
            _ => None,
        })
    }
}

impl Sums {
    /// Appends the trials that come next.
    pub(super) fn merge(&mut self, next: &Self) -> Result<()> {
        match (self, next) {
            (Self::Track(sum), Self::Track(next)) => sum.merge(next),
            (Self::Sweep(sum), Self::Sweep(next)) => sum.merge(next),
            _ => Ok(()),
        }
    }

    /// Appends other trials of the same experiment, whichever they are.
    pub(super) fn append(&mut self, next: &Self) {
        match (self, next) {
            (Self::Track(sum), Self::Track(next)) => sum.append(next),
            (Self::Sweep(sum), Self::Sweep(next)) => sum.append(next),
            _ => (),
        }
    }

    pub(super) fn to_numbers(&self) -> Vec<f64> {
        match self {
            Self::Track(block) => block.to_numbers(),
            Self::Sweep(block) => block.to_numbers(),
        }
    }
}

impl Study {
    /// Trials that were run.
    pub fn trials(&self) -> usize {
        match self {
            Self::Track(report) => report.trials,
            Self::Sweep(report) => report.trials,
        }
    }

    /// The trackers, if it is about them.
    pub fn track(&self) -> Option<&StudyReport> {
        if let Self::Track(report) = self { Some(report) } else { None }
    }

    /// The snapshot estimators, if it is about them.
    pub fn sweep(&self) -> Option<&LocalizationReport> {
        if let Self::Sweep(report) = self { Some(report) } else { None }
    }
}
