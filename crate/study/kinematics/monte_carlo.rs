//! Monte-Carlo of a kinematics scenario, in blocks of trials: any number of workers, one result.

use alloc::vec::Vec;

use super::block::KinematicsBlock;
use super::bounds::{KinematicsBoundReport, kinematics_bounds};
use super::errors::Yardstick;
use super::report::KinematicsReport;
use crate::error::{Error, Result};
use crate::model::kinematics::{KinematicsScenario, KinematicsSetup};
use crate::study::monte_carlo::{MAX_TRIALS, TRIALS_PER_BLOCK};

/// A study of one kinematics scenario: trial `i` is the scenario's seed with random stream `i`.
///
/// ```
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
/// let mut scenario = kinematics_preset("kinematics-sparse")?;
/// scenario.estimators.enabled.truncate(2);
/// let report = KinematicsMonteCarlo::new(&scenario, 3)?.run()?;
/// assert_eq!((report.stamps, report.estimators[1].summary.coefficients.len()), (10, 3));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct KinematicsMonteCarlo<'a> {
    scenario: &'a KinematicsScenario,
    setup: KinematicsSetup,
    yardstick: Yardstick,
    trials: usize,
}

impl<'a> KinematicsMonteCarlo<'a> {
    /// Prepares a study.
    ///
    /// # Errors
    /// When the scenario is not valid, or the number of trials is 0 or above [`MAX_TRIALS`].
    pub fn new(scenario: &'a KinematicsScenario, trials: usize) -> Result<Self> {
        if !(1..=MAX_TRIALS).contains(&trials) {
            let limit = "from 1 to 1000000";
            return Err(Error::Number { what: "the number of trials", value: trials as f64, limit });
        }
        let setup = scenario.setup()?;
        let yardstick = Yardstick::new(scenario, &setup);
        Ok(Self { scenario, setup, yardstick, trials })
    }

    /// How many blocks there are.
    pub fn blocks(&self) -> usize {
        self.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    /// The sum of no trials, to which blocks are joined in their order.
    pub fn start(&self) -> KinematicsBlock {
        KinematicsBlock::new(self.scenario, 0)
    }

    /// Runs block `index`, from 0.
    ///
    /// # Errors
    /// [`Error::Number`] where a distance overflows.
    pub fn block(&self, index: usize) -> Result<KinematicsBlock> {
        let first = index * TRIALS_PER_BLOCK;
        let mut block = KinematicsBlock::new(self.scenario, first);
        let last = self.trials.min(first + TRIALS_PER_BLOCK);
        block.run(self.scenario, &self.setup, &self.yardstick, last)?;
        Ok(block)
    }

    /// All blocks, one after the other.
    ///
    /// # Errors
    /// As [`KinematicsMonteCarlo::block`].
    pub fn run(&self) -> Result<KinematicsReport> {
        let mut done = self.start();
        for index in 0..self.blocks() {
            done.merge(&self.block(index)?)?;
        }
        Ok(self.report(&done))
    }

    /// The figures of the blocks joined so far, beside their bounds.
    pub fn report(&self, done: &KinematicsBlock) -> KinematicsReport {
        self.report_beside(done, kinematics_bounds(self.scenario, &self.setup, &self.yardstick).to_vec())
    }

    /// The same beside bounds that are there already: they do not change from block to block, and take a while.
    pub fn report_beside(
        &self,
        done: &KinematicsBlock,
        bounds: Vec<KinematicsBoundReport>,
    ) -> KinematicsReport {
        KinematicsReport::new(self.scenario, (&self.setup, &self.yardstick), done, bounds)
    }
}
