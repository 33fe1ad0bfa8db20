//! The crate's studies, each as jobs and their total.

use std::sync::Arc;

use rangelab::Result;
use rangelab::model::indoor::IndoorScenario;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::noise::RangeNoise;
use rangelab::model::scenario::Scenario;
use rangelab::study::block::Block;
use rangelab::study::budget::{Budget, BudgetBlock};
use rangelab::study::indoor::block::IndoorBlock;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::kinematics::block::KinematicsBlock;
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::localization::{self, LocalizationBlock, LocalizationStudy};
use rangelab::study::monte_carlo::{MonteCarlo, TRIALS_PER_BLOCK};

use crate::documents::json;

/// A study in jobs.
pub trait Study: Send + Sync {
    fn jobs(&self) -> usize;
    fn trials_per_job(&self) -> usize {
        TRIALS_PER_BLOCK
    }
    fn job(&self, index: usize) -> Result<Vec<f64>>;
    fn start(&self) -> Box<dyn Total>;
}

/// The sum of the jobs of a study.
pub trait Total: Send {
    fn push(&mut self, numbers: &[f64]) -> Result<()>;
    fn trials(&self) -> usize;
    fn report(&self) -> Result<String>;
}

/// A study of which this many trials are asked for, shared by its sums.
pub struct Asked<S> {
    scenario: S,
    trials: usize,
}

type Shared<S> = Arc<Asked<S>>;

/// Trackers and bounds.
pub struct TrackStudy(Shared<Scenario>);

impl TrackStudy {
    pub fn new(scenario: Scenario, trials: usize) -> Result<Self> {
        MonteCarlo::new(&scenario, trials)?;
        Ok(Self(Arc::new(Asked { scenario, trials })))
    }
}

impl Study for TrackStudy {
    fn jobs(&self) -> usize {
        self.0.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    fn job(&self, index: usize) -> Result<Vec<f64>> {
        Ok(MonteCarlo::new(&self.0.scenario, self.0.trials)?.block(index)?.to_numbers())
    }

    fn start(&self) -> Box<dyn Total> {
        Box::new((self.0.clone(), Block::new(&self.0.scenario, 0)))
    }
}

impl Total for (Shared<Scenario>, Block) {
    fn push(&mut self, numbers: &[f64]) -> Result<()> {
        self.1.merge(&Block::from_numbers(&self.0.scenario, numbers)?)
    }

    fn trials(&self) -> usize {
        self.1.trials()
    }

    fn report(&self) -> Result<String> {
        Ok(json(&MonteCarlo::new(&self.0.scenario, self.0.trials)?.report(&self.1)))
    }
}

/// Snapshot estimators over a sweep.
pub struct LocalizeStudy(Shared<(Scenario, Vec<RangeNoise>)>);

impl LocalizeStudy {
    pub fn new(scenario: Scenario, noises: Vec<RangeNoise>, trials: usize) -> Result<Self> {
        LocalizationStudy::new(&scenario, noises.clone(), trials)?;
        Ok(Self(Arc::new(Asked { scenario: (scenario, noises), trials })))
    }
}

fn localization(of: &Asked<(Scenario, Vec<RangeNoise>)>) -> Result<LocalizationStudy<'_>> {
    let (scenario, noises) = &of.scenario;
    LocalizationStudy::new(scenario, noises.clone(), of.trials)
}

impl Study for LocalizeStudy {
    fn jobs(&self) -> usize {
        self.0.trials.div_ceil(localization::TRIALS_PER_BLOCK)
    }

    fn trials_per_job(&self) -> usize {
        localization::TRIALS_PER_BLOCK
    }

    fn job(&self, index: usize) -> Result<Vec<f64>> {
        Ok(localization(&self.0)?.block(index)?.to_numbers())
    }

    fn start(&self) -> Box<dyn Total> {
        let (scenario, noises) = &self.0.scenario;
        Box::new((self.0.clone(), LocalizationBlock::new(scenario, noises.len(), 0)))
    }
}

impl Total for (Shared<(Scenario, Vec<RangeNoise>)>, LocalizationBlock) {
    fn push(&mut self, numbers: &[f64]) -> Result<()> {
        let (scenario, noises) = &self.0.scenario;
        self.1.merge(&LocalizationBlock::from_numbers(scenario, noises.len(), numbers)?)
    }

    fn trials(&self) -> usize {
        self.1.trials()
    }

    fn report(&self) -> Result<String> {
        Ok(json(&localization(&self.0)?.report(&self.1)))
    }
}

/// What projections of the ET-KF buy.
pub struct BudgetStudy(Shared<(Scenario, Vec<f64>)>);

impl BudgetStudy {
    pub fn new(scenario: Scenario, thresholds: Vec<f64>, trials: usize) -> Result<Self> {
        Budget::new(&scenario, &thresholds, trials)?;
        Ok(Self(Arc::new(Asked { scenario: (scenario, thresholds), trials })))
    }
}

fn budget(of: &Asked<(Scenario, Vec<f64>)>) -> Result<Budget<'_>> {
    let (scenario, thresholds) = &of.scenario;
    Budget::new(scenario, thresholds, of.trials)
}

impl Study for BudgetStudy {
    fn jobs(&self) -> usize {
        self.0.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    fn job(&self, index: usize) -> Result<Vec<f64>> {
        Ok(budget(&self.0)?.block(index)?.to_numbers())
    }

    fn start(&self) -> Box<dyn Total> {
        let sum =
            budget(&self.0).map(|budget| budget.start()).expect("the study was checked when it was made");
        Box::new((self.0.clone(), sum))
    }
}

impl Total for (Shared<(Scenario, Vec<f64>)>, BudgetBlock) {
    fn push(&mut self, numbers: &[f64]) -> Result<()> {
        let thresholds = self.0.scenario.1.len();
        self.1.merge(&BudgetBlock::from_numbers(thresholds, numbers)?)
    }

    fn trials(&self) -> usize {
        self.1.trials()
    }

    fn report(&self) -> Result<String> {
        Ok(json(&budget(&self.0)?.report(&self.1)))
    }
}

/// The filters of the Indoor lab.
pub struct IndoorStudy(Shared<IndoorScenario>);

impl IndoorStudy {
    pub fn new(scenario: IndoorScenario, trials: usize) -> Result<Self> {
        IndoorMonteCarlo::new(&scenario, trials)?;
        Ok(Self(Arc::new(Asked { scenario, trials })))
    }
}

impl Study for IndoorStudy {
    fn jobs(&self) -> usize {
        self.0.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    fn job(&self, index: usize) -> Result<Vec<f64>> {
        Ok(IndoorMonteCarlo::new(&self.0.scenario, self.0.trials)?.block(index)?.to_numbers())
    }

    fn start(&self) -> Box<dyn Total> {
        Box::new((self.0.clone(), IndoorBlock::new(&self.0.scenario, 0)))
    }
}

impl Total for (Shared<IndoorScenario>, IndoorBlock) {
    fn push(&mut self, numbers: &[f64]) -> Result<()> {
        self.1.merge(&IndoorBlock::from_numbers(&self.0.scenario, numbers)?)
    }

    fn trials(&self) -> usize {
        self.1.trials()
    }

    fn report(&self) -> Result<String> {
        Ok(json(&IndoorMonteCarlo::new(&self.0.scenario, self.0.trials)?.report(&self.1)))
    }
}

/// Relative kinematics of nodes without anchors.
pub struct KinematicsStudy(Shared<KinematicsScenario>);

impl KinematicsStudy {
    pub fn new(scenario: KinematicsScenario, trials: usize) -> Result<Self> {
        KinematicsMonteCarlo::new(&scenario, trials)?;
        Ok(Self(Arc::new(Asked { scenario, trials })))
    }
}

impl Study for KinematicsStudy {
    fn jobs(&self) -> usize {
        self.0.trials.div_ceil(TRIALS_PER_BLOCK)
    }

    fn job(&self, index: usize) -> Result<Vec<f64>> {
        Ok(KinematicsMonteCarlo::new(&self.0.scenario, self.0.trials)?.block(index)?.to_numbers())
    }

    fn start(&self) -> Box<dyn Total> {
        Box::new((self.0.clone(), KinematicsBlock::new(&self.0.scenario, 0)))
    }
}

impl Total for (Shared<KinematicsScenario>, KinematicsBlock) {
    fn push(&mut self, numbers: &[f64]) -> Result<()> {
        self.1.merge(&KinematicsBlock::from_numbers(&self.0.scenario, numbers)?)
    }

    fn trials(&self) -> usize {
        self.1.trials()
    }

    fn report(&self) -> Result<String> {
        Ok(json(&KinematicsMonteCarlo::new(&self.0.scenario, self.0.trials)?.report(&self.1)))
    }
}
