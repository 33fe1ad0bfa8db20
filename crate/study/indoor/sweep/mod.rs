//! Monte-Carlo of an indoor scenario over a sweep of one of its settings, by whole trials.

mod block;
mod report;

use alloc::string::ToString;
use alloc::vec::Vec;

pub use block::SweepBlock;
pub use report::{IndoorSweepFilter, IndoorSweepReport};

use crate::error::{Error, Result};
use crate::math::float::{ratio_from_db, sqrt};
use crate::model::indoor::IndoorScenario;
use crate::study::monte_carlo::MAX_TRIALS;

/// Trials of one block: few, as one on the stairs takes long and a jackknife needs many blocks.
pub const TRIALS_PER_BLOCK: usize = 4;

/// The setting that changes from point to point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Swept {
    /// The accuracy of a range, `20 log10(1 m/sigma)`, dB.
    Accuracy,
    /// Samples of the IMU in a second.
    ImuRate,
}

/// A scenario at each point of a sweep. Trial `i` is the scenario's seed with random stream `i`, the same numbers at every
/// point.
///
/// ```
/// use rangelab::model::indoor::presets::indoor_preset;
/// use rangelab::study::indoor::sweep::{IndoorSweep, Swept};
/// let sweep = IndoorSweep::new(indoor_preset("indoor-bridge")?, Swept::Accuracy, vec![0.0, 20.0]);
/// assert_eq!(sweep.at(20.0).ranging.sigma, 0.1);
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct IndoorSweep {
    scenario: IndoorScenario,
    swept: Swept,
    points: Vec<f64>,
}

impl IndoorSweep {
    /// A sweep of a scenario's enabled filters.
    pub fn new(scenario: IndoorScenario, swept: Swept, points: Vec<f64>) -> Self {
        Self { scenario, swept, points }
    }

    /// What it is a sweep of.
    pub fn scenario(&self) -> &IndoorScenario {
        &self.scenario
    }

    /// Takes other random numbers.
    pub fn set_seed(&mut self, seed: u64) {
        self.scenario.seed = seed;
    }

    /// The scenario at a point.
    pub fn at(&self, point: f64) -> IndoorScenario {
        let mut scenario = self.scenario.clone();
        match self.swept {
            Swept::Accuracy => scenario.ranging.sigma = sqrt(ratio_from_db(-point)),
            Swept::ImuRate => scenario.imu.rate_hz = point,
        }
        scenario
    }

    /// How many blocks so many trials have.
    ///
    /// # Errors
    /// When the scenario is not valid at some point, or the number of trials is 0 or above [`MAX_TRIALS`].
    pub fn blocks(&self, trials: usize) -> Result<usize> {
        if !(1..=MAX_TRIALS).contains(&trials) {
            let limit = "from 1 to 1000000";
            return Err(Error::Number { what: "the number of trials", value: trials as f64, limit });
        }
        for point in &self.points {
            self.at(*point).setup()?;
        }
        Ok(trials.div_ceil(TRIALS_PER_BLOCK))
    }

    /// Runs block `index`, from 0, of so many trials.
    ///
    /// # Errors
    /// When the scenario is not valid at some point.
    pub fn block(&self, trials: usize, index: usize) -> Result<SweepBlock> {
        let first = index * TRIALS_PER_BLOCK;
        let mut block = SweepBlock::new(self, first);
        block.run(self, trials.min(first + TRIALS_PER_BLOCK))?;
        Ok(block)
    }

    /// All blocks, one after the other.
    ///
    /// # Errors
    /// As [`IndoorSweep::blocks`].
    pub fn run(&self, trials: usize) -> Result<IndoorSweepReport> {
        let mut sum = SweepBlock::new(self, 0);
        for index in 0..self.blocks(trials)? {
            sum.merge(&self.block(trials, index)?)?;
        }
        Ok(self.report(&sum))
    }

    /// The figures of the blocks joined so far.
    pub fn report(&self, done: &SweepBlock) -> IndoorSweepReport {
        let filters = self.scenario.filters.enabled.iter().enumerate();
        IndoorSweepReport {
            name: self.scenario.name.clone(),
            trials: done.trials(),
            points: self.points.clone(),
            filters: filters
                .map(|(index, name)| IndoorSweepFilter {
                    name: *name,
                    label: name.label().to_string(),
                    points: done.filter(index).collect(),
                })
                .collect(),
        }
    }
}
