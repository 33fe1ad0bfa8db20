//! The kinds of experiments that figures are made of: trackers over steps, snapshot estimators over a sweep of the noise,
//! inertial filters over a sweep, estimators of relative kinematics over the number of stamps.

use super::experiment::Kind;
use super::report::FigureScenario;
use crate::error::Result;
use crate::model::scenario::Scenario;
use crate::study::block::Block;
use crate::study::indoor::sweep::{IndoorSweep, IndoorSweepReport, SweepBlock};
use crate::study::kinematics::sweep::{KinematicsSweep, KinematicsSweepBlock, KinematicsSweepReport};
use crate::study::localization::report::LocalizationReport;
use crate::study::localization::{LocalizationBlock, LocalizationStudy, paper_sweep};
use crate::study::monte_carlo::MonteCarlo;
use crate::study::report::StudyReport;

/// Trackers, step by step.
#[derive(Clone, Debug)]
pub(super) struct Tracking(pub Scenario);

/// Snapshot estimators at each noise of [`paper_sweep`].
#[derive(Clone, Debug)]
pub(super) struct NoiseSweep(pub Scenario);

impl Kind for Tracking {
    type Sums = Block;
    type Report = StudyReport;

    fn scenario(&self) -> FigureScenario {
        self.0.clone().into()
    }

    fn set_seed(&mut self, seed: u64) {
        self.0.seed = seed;
    }

    fn blocks(&self, trials: usize) -> Result<usize> {
        Ok(MonteCarlo::new(&self.0, trials)?.blocks())
    }

    fn start(&self) -> Block {
        Block::new(&self.0, 0)
    }

    fn block(&self, trials: usize, index: usize) -> Result<Block> {
        MonteCarlo::new(&self.0, trials)?.block(index)
    }

    fn read(&self, numbers: &[f64]) -> Result<Block> {
        Block::from_numbers(&self.0, numbers)
    }

    fn report(&self, trials: usize, sums: &Block) -> Result<StudyReport> {
        Ok(MonteCarlo::new(&self.0, trials)?.report(sums))
    }
}

impl Kind for NoiseSweep {
    type Sums = LocalizationBlock;
    type Report = LocalizationReport;

    fn scenario(&self) -> FigureScenario {
        self.0.clone().into()
    }

    fn set_seed(&mut self, seed: u64) {
        self.0.seed = seed;
    }

    fn blocks(&self, trials: usize) -> Result<usize> {
        Ok(LocalizationStudy::new(&self.0, paper_sweep(), trials)?.blocks())
    }

    fn start(&self) -> LocalizationBlock {
        LocalizationBlock::new(&self.0, paper_sweep().len(), 0)
    }

    fn block(&self, trials: usize, index: usize) -> Result<LocalizationBlock> {
        LocalizationStudy::new(&self.0, paper_sweep(), trials)?.block(index)
    }

    fn read(&self, numbers: &[f64]) -> Result<LocalizationBlock> {
        LocalizationBlock::from_numbers(&self.0, paper_sweep().len(), numbers)
    }

    fn report(&self, trials: usize, sums: &LocalizationBlock) -> Result<LocalizationReport> {
        Ok(LocalizationStudy::new(&self.0, paper_sweep(), trials)?.report(sums))
    }
}

impl Kind for IndoorSweep {
    type Sums = SweepBlock;
    type Report = IndoorSweepReport;

    fn scenario(&self) -> FigureScenario {
        self.scenario().clone().into()
    }

    fn set_seed(&mut self, seed: u64) {
        self.set_seed(seed);
    }

    fn blocks(&self, trials: usize) -> Result<usize> {
        self.blocks(trials)
    }

    fn start(&self) -> SweepBlock {
        SweepBlock::new(self, 0)
    }

    fn block(&self, trials: usize, index: usize) -> Result<SweepBlock> {
        self.block(trials, index)
    }

    fn read(&self, numbers: &[f64]) -> Result<SweepBlock> {
        SweepBlock::from_numbers(self, numbers)
    }

    fn report(&self, _trials: usize, sums: &SweepBlock) -> Result<IndoorSweepReport> {
        Ok(self.report(sums))
    }
}

impl Kind for KinematicsSweep {
    type Sums = KinematicsSweepBlock;
    type Report = KinematicsSweepReport;

    fn scenario(&self) -> FigureScenario {
        self.scenario().clone().into()
    }

    fn set_seed(&mut self, seed: u64) {
        self.set_seed(seed);
    }

    fn blocks(&self, trials: usize) -> Result<usize> {
        self.blocks(trials)
    }

    fn start(&self) -> KinematicsSweepBlock {
        self.start()
    }

    fn block(&self, trials: usize, index: usize) -> Result<KinematicsSweepBlock> {
        self.block(trials, index)
    }

    fn read(&self, numbers: &[f64]) -> Result<KinematicsSweepBlock> {
        KinematicsSweepBlock::from_numbers(self, numbers)
    }

    fn report(&self, _trials: usize, sums: &KinematicsSweepBlock) -> Result<KinematicsSweepReport> {
        Ok(self.report(sums))
    }
}
