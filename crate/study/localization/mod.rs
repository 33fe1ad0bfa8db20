//! Monte-Carlo of snapshot estimators over a sweep of the noise.

pub mod block;
mod bounds;
pub mod report;
pub mod run;
pub mod tally;
pub mod trial;

use alloc::vec::Vec;

use crate::error::{Error, Result};
use crate::model::noise::RangeNoise;
use crate::model::scenario::Scenario;
use crate::with_dimension;
pub use block::LocalizationBlock;
pub use bounds::SnapshotBound;
use report::{LocalizationReport, SnapshotBoundReport, SnapshotPoint, SnapshotReport};

use super::monte_carlo::MAX_TRIALS;

/// Trials of one block; blocks are summed in their own order and joined in order.
pub const TRIALS_PER_BLOCK: usize = 50;

/// The most points of a sweep.
pub const MAX_POINTS: usize = 1000;

/// A study: trial `i` is the scenario's seed with random stream `i`, the same numbers at every point of the sweep.
#[derive(Clone, Debug)]
pub struct LocalizationStudy<'a> {
    scenario: &'a Scenario,
    points: Vec<RangeNoise>,
    trials: usize,
}

/// The paper's sweep, zeta from 0 to 100 dB in steps of 5.
pub fn paper_sweep() -> Vec<RangeNoise> {
    (0..=20).map(|k| RangeNoise::Toa { zeta_db: 5.0 * f64::from(k) }).collect()
}

impl<'a> LocalizationStudy<'a> {
    /// Prepares a study of the scenario's enabled localizers at each noise of a sweep. Only the first epoch is looked at.
    ///
    /// # Errors
    /// When the scenario or a noise is not valid, when there is no point or more than [`MAX_POINTS`], or when the number of
    /// trials is 0 or above [`MAX_TRIALS`].
    pub fn new(scenario: &'a Scenario, points: Vec<RangeNoise>, trials: usize) -> Result<Self> {
        let count = |what, value: usize, limit, most| {
            if (1..=most).contains(&value) {
                Ok(())
            } else {
                Err(Error::Number { what, value: value as f64, limit })
            }
        };
        count("the number of trials", trials, "from 1 to 1000000", MAX_TRIALS)?;
        count("the number of points of a sweep", points.len(), "from 1 to 1000", MAX_POINTS)?;
        points.iter().try_for_each(RangeNoise::check)?;
        with_dimension!(scenario.dimension, D => scenario.setup::<D>().map(drop))?;
        Ok(Self { scenario, points, trials })
    }

    /// How many blocks there are.
    pub fn blocks(&self) -> usize {
        self.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    /// The sum of no trials, to which blocks are joined in their order.
    pub fn start(&self) -> LocalizationBlock {
        LocalizationBlock::new(self.scenario, self.points.len(), 0)
    }

    /// Runs block `index`, from 0.
    ///
    /// # Errors
    /// When a simulated recording is beyond double precision.
    pub fn block(&self, index: usize) -> Result<LocalizationBlock> {
        let first = index * TRIALS_PER_BLOCK;
        let last = self.trials.min(first + TRIALS_PER_BLOCK);
        let mut block = LocalizationBlock::new(self.scenario, self.points.len(), first);
        with_dimension!(self.scenario.dimension, D => block.run::<D>(self.scenario, &self.points, last).map(|()| block))
    }

    /// All blocks, one after the other.
    ///
    /// # Errors
    /// When a simulated recording is beyond double precision.
    pub fn run(&self) -> Result<LocalizationReport> {
        let mut sum = self.start();
        for index in 0..self.blocks() {
            sum.merge(&self.block(index)?)?;
        }
        Ok(self.report(&sum))
    }

    /// What a noise means in metres.
    fn point(&self, noise: RangeNoise) -> SnapshotPoint {
        let range_error = with_dimension!(self.scenario.dimension, D => {
            let setup = self.scenario.setup::<D>();
            setup.and_then(|setup| Ok(noise.range_error(&setup.model.exact_ranges(&setup.start.into())?)))
        });
        SnapshotPoint { noise, range_error: range_error.unwrap_or_default() }
    }

    /// The figures of the blocks joined so far.
    pub fn report(&self, done: &LocalizationBlock) -> LocalizationReport {
        let names = self.scenario.localize.enabled.iter().enumerate();
        LocalizationReport {
            name: self.scenario.name.clone(),
            trials: done.trials(),
            points: self.points.iter().map(|&noise| self.point(noise)).collect(),
            estimators: names
                .map(|(index, &name)| SnapshotReport {
                    name,
                    label: name.label().into(),
                    points: done.estimator(index).collect(),
                })
                .collect(),
            bounds: SnapshotBound::ALL
                .map(|kind| SnapshotBoundReport {
                    name: kind.name().into(),
                    label: kind.label().into(),
                    points: done.bound(kind).collect(),
                })
                .into(),
        }
    }
}
