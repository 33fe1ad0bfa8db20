//! Monte-Carlo of a kinematics scenario over the number of its stamps, by whole trials.

mod block;
mod report;

use alloc::vec::Vec;

pub use block::KinematicsSweepBlock;
pub use report::KinematicsSweepReport;

use super::bounds::kinematics_bounds;
use super::errors::Yardstick;
use crate::error::{Error, Result};
use crate::model::kinematics::{KinematicsScenario, KinematicsSetup};
use crate::study::monte_carlo::MAX_TRIALS;

/// Trials of one block: few, as one of many stamps takes long and a jackknife needs many blocks.
pub const TRIALS_PER_BLOCK: usize = 10;

/// A scenario at each of some numbers of stamps K, evenly over its interval. Trial `i` is the scenario's seed with random
/// stream `i`: stamp k draws the same random numbers at every K.
///
/// ```
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::study::kinematics::sweep::KinematicsSweep;
/// let mut scenario = kinematics_preset("kinematics-paper")?;
/// (scenario.steps, scenario.estimators.enabled) = (3, vec!["algorithm-2-so".parse()?]);
/// let report = KinematicsSweep::new(scenario, &[10, 40])?.run(4)?;
/// let of_velocity = |k: usize| report.points[k].estimators[0].summary.coefficients[1].value;
/// assert!(report.points[1].stamps == 40 && of_velocity(1) < of_velocity(0));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct KinematicsSweep {
    scenario: KinematicsScenario,
    points: Vec<SweepPoint>,
}

/// What is the same in all trials of one K.
#[derive(Clone, Debug)]
struct SweepPoint {
    setup: KinematicsSetup,
    yardstick: Yardstick,
}

impl KinematicsSweep {
    /// A sweep of a scenario's enabled estimators.
    ///
    /// # Errors
    /// When the scenario is not valid, as it is or at some number of stamps.
    pub fn new(scenario: KinematicsScenario, stamp_counts: &[usize]) -> Result<Self> {
        scenario.setup()?;
        let point = |&count: &usize| {
            let mut scenario = scenario.clone();
            scenario.stamps = scenario.stamps.evenly(count);
            let setup = scenario.setup()?;
            Ok(SweepPoint { yardstick: Yardstick::new(&scenario, &setup), setup })
        };
        Ok(Self { points: stamp_counts.iter().map(point).collect::<Result<_>>()?, scenario })
    }

    /// What it is a sweep of.
    pub fn scenario(&self) -> &KinematicsScenario {
        &self.scenario
    }

    /// Takes other random numbers.
    pub fn set_seed(&mut self, seed: u64) {
        self.scenario.seed = seed;
    }

    /// How many blocks so many trials have.
    ///
    /// # Errors
    /// When the number of trials is 0 or above [`MAX_TRIALS`], or the seed above 2^53.
    pub fn blocks(&self, trials: usize) -> Result<usize> {
        if !(1..=MAX_TRIALS).contains(&trials) {
            let limit = "from 1 to 1000000";
            return Err(Error::Number { what: "the number of trials", value: trials as f64, limit });
        }
        self.scenario.setup()?;
        Ok(trials.div_ceil(TRIALS_PER_BLOCK))
    }

    /// The sum of no trials, to which blocks are joined in their order. It also holds the bounds, which no trial changes.
    pub fn start(&self) -> KinematicsSweepBlock {
        let bounds =
            self.points.iter().map(|point| kinematics_bounds(&self.scenario, &point.setup, &point.yardstick));
        KinematicsSweepBlock::new(self, 0, bounds.collect())
    }

    /// Runs block `index`, from 0, of so many trials.
    ///
    /// # Errors
    /// [`Error::Number`] where a distance overflows.
    pub fn block(&self, trials: usize, index: usize) -> Result<KinematicsSweepBlock> {
        let first = index * TRIALS_PER_BLOCK;
        let mut block = KinematicsSweepBlock::new(self, first, Vec::new());
        block.run(self, trials.min(first + TRIALS_PER_BLOCK))?;
        Ok(block)
    }

    /// All blocks, one after the other.
    ///
    /// # Errors
    /// As [`KinematicsSweep::blocks`] and [`KinematicsSweep::block`].
    pub fn run(&self, trials: usize) -> Result<KinematicsSweepReport> {
        let mut sum = self.start();
        for index in 0..self.blocks(trials)? {
            sum.merge(&self.block(trials, index)?)?;
        }
        Ok(self.report(&sum))
    }

    /// The figures of the blocks joined so far, to what [`KinematicsSweep::start`] gave.
    pub fn report(&self, done: &KinematicsSweepBlock) -> KinematicsSweepReport {
        KinematicsSweepReport::new(self, done)
    }
}
