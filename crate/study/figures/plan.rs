//! A figure in numbered jobs: any worker computes any of them, and their sum has one value.

use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

use super::Figure;
use super::caption::caption;
use super::claim::Claim;
use super::jackknife::{Groups, jackknifed};
use super::report::{FigureReport, NamedScenario};
use crate::error::{Error, Result};
use crate::model::document::VERSION;
use crate::model::scenario::Scenario;
use crate::study::block::Block;
use crate::study::monte_carlo::MonteCarlo;
use crate::study::report::StudyReport;

/// A number of trials of every scenario of a figure.
///
/// ```
/// use rangelab::study::figures::{figure, plan::FigurePlan};
/// let plan = FigurePlan::new(figure("tracking-2")?, 20, 1)?;
/// let mut sum = plan.start();
/// for job in 0..plan.jobs() {
///     sum.merge(&plan.job(job)?)?;
/// }
/// let report = plan.report(&sum);
/// assert_eq!((report.trials, report.command.as_str()), (20, "rangelab figure tracking-2 --trials 20 --seed 1"));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct FigurePlan {
    figure: &'static Figure,
    trials: usize,
    seed: u64,
    scenarios: Vec<Scenario>,
}

/// The sums of one job.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureBlock {
    job: usize,
    block: Block,
}

/// The sums of the jobs joined so far.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureSum {
    jobs: usize,
    scenarios: Vec<Groups>,
}

/// What a row of numbers begins with: figure, trials, seed, job.
const HEADER: usize = 4;

impl FigurePlan {
    /// Prepares a figure.
    ///
    /// # Errors
    /// Where the number of trials is 0 or above [`crate::study::monte_carlo::MAX_TRIALS`], or the seed above 2^53 - 1.
    pub fn new(figure: &'static Figure, trials: usize, seed: u64) -> Result<Self> {
        let seeded = |(_, scenario): (_, Scenario)| Scenario { seed, ..scenario };
        let scenarios: Vec<Scenario> = (figure.scenarios)().into_iter().map(seeded).collect();
        scenarios.iter().try_for_each(|scenario| MonteCarlo::new(scenario, trials).map(drop))?;
        Ok(Self { figure, trials, seed, scenarios })
    }

    /// How many jobs there are; each takes about as long.
    pub fn jobs(&self) -> usize {
        self.scenarios.len() * self.study(0).blocks()
    }

    /// The sum of no jobs, to which they are joined in their order.
    pub fn start(&self) -> FigureSum {
        let groups = |scenario| Groups::new(Block::new(scenario, 0), self.study(0).blocks());
        FigureSum { jobs: 0, scenarios: self.scenarios.iter().map(groups).collect() }
    }

    /// Runs job `index`, from 0. The scenarios take turns, so that all curves grow alike.
    ///
    /// # Errors
    /// [`Error::Size`] beyond the last; when a trial leaves double precision.
    pub fn job(&self, index: usize) -> Result<FigureBlock> {
        self.check(index)?;
        let scenarios = self.scenarios.len();
        let block = self.study(index % scenarios).block(index / scenarios)?;
        Ok(FigureBlock { job: index, block })
    }

    /// A job as a row of numbers, from which it comes back as the same bits.
    #[allow(clippy::cast_precision_loss, reason = "a seed is below 2^53")]
    pub fn to_numbers(&self, block: &FigureBlock) -> Vec<f64> {
        let header = [self.figure.index() as f64, self.trials as f64, self.seed as f64, block.job as f64];
        header.into_iter().chain(block.block.to_numbers()).collect()
    }

    /// The job of [`FigurePlan::to_numbers`].
    ///
    /// # Errors
    /// [`Error::Size`] or [`Error::Number`] where it is of another figure, number of trials or seed.
    #[allow(clippy::cast_precision_loss, reason = "a seed is below 2^53")]
    pub fn from_numbers(&self, numbers: &[f64]) -> Result<FigureBlock> {
        let (found, expected) = (numbers.len(), HEADER + Block::length(&self.scenarios[0]));
        let Some((&[figure, trials, seed, job], rest)) = numbers.split_first_chunk::<HEADER>() else {
            return Err(Error::Size { what: "numbers in a job", found, expected });
        };
        let same =
            [(figure, self.figure.index() as f64), (trials, self.trials as f64), (seed, self.seed as f64)];
        if let Some((value, _)) = same.iter().find(|(found, own)| found != own) {
            let limit = "that of the figure it is joined to";
            return Err(Error::Number { what: "figure, trials or seed of a job", value: *value, limit });
        }
        let Some(job) = (0..self.jobs()).find(|index| *index as f64 == job) else {
            return Err(Error::Number {
                what: "the number of a job",
                value: job,
                limit: "one of the figure's",
            });
        };
        let block = Block::from_numbers(&self.scenarios[job % self.scenarios.len()], rest)?;
        Ok(FigureBlock { job, block })
    }

    /// What was found in each scenario by the jobs joined so far.
    pub fn studies(&self, sum: &FigureSum) -> Vec<StudyReport> {
        let studies = sum.scenarios.iter().enumerate();
        studies.map(|(i, groups)| self.study(i).report(&groups.total())).collect()
    }

    /// The figure of the jobs joined so far. The standard errors of its claims are by the jackknife, so that what two
    /// estimators have in common in a trial cancels in their ratio.
    pub fn report(&self, sum: &FigureSum) -> FigureReport {
        let studies = self.studies(sum);
        let without: Vec<Vec<Block>> = sum.scenarios.iter().map(Groups::without_each).collect();
        let groups = without.iter().map(Vec::len).min().unwrap_or(0);
        let claims_without = (0..groups).map(|group| {
            let each = without.iter().enumerate();
            let studies: Vec<StudyReport> =
                each.map(|(i, blocks)| self.study(i).report(&blocks[group])).collect();
            (self.figure.claims)(&studies)
        });
        let claims = jackknifed((self.figure.claims)(&studies), &claims_without.collect::<Vec<_>>());
        self.with_claims(&studies, claims)
    }

    /// The figure of studies of its scenarios, each of which knows nothing of the others' trials: the standard error of a
    /// ratio is that of two independent numbers.
    pub fn report_of(&self, studies: &[StudyReport]) -> FigureReport {
        self.with_claims(studies, (self.figure.claims)(studies))
    }

    fn with_claims(&self, studies: &[StudyReport], claims: Vec<Claim>) -> FigureReport {
        let Figure { name, title, statement, .. } = self.figure;
        let trials = studies.iter().map(|study| study.trials).min().unwrap_or(0);
        let names = (self.figure.scenarios)().into_iter().map(|(name, _)| name.to_string());
        let named =
            names.zip(self.scenarios.clone()).map(|(name, scenario)| NamedScenario { name, scenario });
        FigureReport {
            version: VERSION,
            name: (*name).to_string(),
            paper: self.figure.paper(),
            title: (*title).to_string(),
            statement: (*statement).to_string(),
            trials,
            seed: self.seed,
            command: format!("rangelab figure {name} --trials {} --seed {}", self.trials, self.seed),
            caption: caption(self.figure, trials, self.seed, &claims),
            claims,
            panels: (self.figure.panels)(studies),
            scenarios: named.collect(),
        }
    }

    fn study(&self, scenario: usize) -> MonteCarlo<'_> {
        MonteCarlo::new(&self.scenarios[scenario], self.trials).expect("checked when the plan was made")
    }

    fn check(&self, index: usize) -> Result<()> {
        let expected = self.jobs();
        if index < expected {
            return Ok(());
        }
        Err(Error::Size { what: "jobs of a figure before this one", found: index, expected: expected - 1 })
    }
}

impl FigureSum {
    /// Jobs joined so far.
    pub fn jobs(&self) -> usize {
        self.jobs
    }

    /// Joins the job that comes next.
    ///
    /// # Errors
    /// [`Error::Size`] where `next` is another one: sums in another order have other bits. The sum stays as it was.
    pub fn merge(&mut self, next: &FigureBlock) -> Result<()> {
        if next.job != self.jobs {
            let what = "jobs before the one that is joined";
            return Err(Error::Size { what, found: next.job, expected: self.jobs });
        }
        let scenarios = self.scenarios.len();
        self.scenarios[next.job % scenarios].merge(&next.block)?;
        self.jobs += 1;
        Ok(())
    }
}
