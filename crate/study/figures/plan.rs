//! A figure in numbered jobs: any worker computes any of them, and their sum has one value.

use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

use super::Figure;
use super::caption::caption;
use super::claim::Claim;
use super::experiment::{Experiment, Study, Sums};
use super::jackknife::{Groups, jackknifed};
use super::report::{FigureReport, NamedScenario};
use crate::error::{Error, Result};
use crate::model::document::VERSION;

/// A number of trials of every scenario of a figure.
///
/// ```
/// use rangelab::study::figures::{figure, plan::FigurePlan};
/// let plan = FigurePlan::new(figure("tracking-2")?, 20, 1)?;
/// let mut sum = plan.start();
/// for job in 0..plan.jobs() {
///     sum.merge(&plan.job(job)?)?;
/// }
/// let report = plan.report(&sum)?;
/// assert_eq!((report.trials, report.command.as_str()), (20, "rangelab figure tracking-2 --trials 20 --seed 1"));
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct FigurePlan {
    figure: &'static Figure,
    trials: usize,
    seed: u64,
    blocks: usize,
    names: Vec<&'static str>,
    experiments: Vec<Experiment>,
}

/// The sums of one job.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureBlock {
    job: usize,
    sums: Sums,
}

/// The sums of the jobs joined so far.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureSum {
    jobs: usize,
    experiments: Vec<Groups>,
}

/// What a row of numbers begins with: figure, trials, seed, job.
const HEADER: usize = 4;

impl FigurePlan {
    /// Prepares a figure.
    ///
    /// # Errors
    /// Where the number of trials is 0 or above [`crate::study::monte_carlo::MAX_TRIALS`], or the seed above 2^53.
    pub fn new(figure: &'static Figure, trials: usize, seed: u64) -> Result<Self> {
        let (names, experiments): (Vec<_>, Vec<_>) = (figure.experiments)().into_iter().unzip();
        let experiments: Vec<Experiment> = experiments.into_iter().map(|each| each.with_seed(seed)).collect();
        let mut blocks = 0;
        for experiment in &experiments {
            blocks = experiment.blocks(trials)?;
        }
        Ok(Self { figure, trials, seed, blocks, names, experiments })
    }

    /// How many jobs there are; each takes about as long.
    pub fn jobs(&self) -> usize {
        self.experiments.len() * self.blocks
    }

    /// The sum of no jobs, to which they are joined in their order.
    pub fn start(&self) -> FigureSum {
        let groups = |experiment: &Experiment| Groups::new(experiment.start(), self.blocks);
        FigureSum { jobs: 0, experiments: self.experiments.iter().map(groups).collect() }
    }

    /// Runs job `index`, from 0. The experiments take turns, so that all curves grow alike.
    ///
    /// # Errors
    /// [`Error::Size`] beyond the last; when a trial leaves double precision.
    pub fn job(&self, index: usize) -> Result<FigureBlock> {
        self.check(index)?;
        let count = self.experiments.len();
        let sums = self.experiments[index % count].block(self.trials, index / count)?;
        Ok(FigureBlock { job: index, sums })
    }

    /// A job as a row of numbers, from which it comes back as the same bits.
    #[allow(clippy::cast_precision_loss, reason = "a seed is below 2^53")]
    pub fn to_numbers(&self, block: &FigureBlock) -> Vec<f64> {
        let header = [self.figure.index() as f64, self.trials as f64, self.seed as f64, block.job as f64];
        header.into_iter().chain(block.sums.to_numbers()).collect()
    }

    /// The job of [`FigurePlan::to_numbers`].
    ///
    /// # Errors
    /// [`Error::Size`] or [`Error::Number`] where it is of another figure, number of trials or seed.
    #[allow(clippy::cast_precision_loss, reason = "a seed is below 2^53")]
    pub fn from_numbers(&self, numbers: &[f64]) -> Result<FigureBlock> {
        let Some((&[figure, trials, seed, job], rest)) = numbers.split_first_chunk::<HEADER>() else {
            let (what, found) = ("numbers at the start of a job", numbers.len());
            return Err(Error::Size { what, found, expected: HEADER });
        };
        let same =
            [(figure, self.figure.index() as f64), (trials, self.trials as f64), (seed, self.seed as f64)];
        if let Some((value, _)) = same.iter().find(|(found, own)| found.to_bits() != own.to_bits()) {
            let limit = "that of the figure it is joined to";
            return Err(Error::Number { what: "figure, trials or seed of a job", value: *value, limit });
        }
        let Some(job) = (0..self.jobs()).find(|index| (*index as f64).to_bits() == job.to_bits()) else {
            return Err(Error::Number {
                what: "the number of a job",
                value: job,
                limit: "one of the figure's",
            });
        };
        let sums = self.experiments[job % self.experiments.len()].read(rest)?;
        Ok(FigureBlock { job, sums })
    }

    /// What was found in each experiment by the jobs joined so far.
    ///
    /// # Errors
    /// None for a sum that [`FigurePlan::start`] began.
    pub fn studies(&self, sum: &FigureSum) -> Result<Vec<Study>> {
        self.studies_of(sum.experiments.iter().map(Groups::total))
    }

    /// The figure of the jobs joined so far. The standard errors of its claims are by the jackknife, so that what two
    /// estimators have in common in a trial cancels in their ratio.
    ///
    /// # Errors
    /// None for a sum that [`FigurePlan::start`] began.
    pub fn report(&self, sum: &FigureSum) -> Result<FigureReport> {
        let studies = self.studies(sum)?;
        let without: Vec<Vec<Sums>> = sum.experiments.iter().map(Groups::without_each).collect();
        let groups = without.iter().map(Vec::len).min().unwrap_or(0);
        let claims_without = (0..groups).map(|group| {
            let studies = self.studies_of(without.iter().map(|sums| sums[group].clone()))?;
            Ok((self.figure.claims)(&studies))
        });
        let (claims, without) = ((self.figure.claims)(&studies), claims_without.collect::<Result<Vec<_>>>()?);
        let claims = jackknifed(claims, &without, least_trials(&studies));
        Ok(self.with_claims(&studies, claims))
    }

    /// The figure of studies of its scenarios, each of which knows nothing of the others' trials: the standard error of a
    /// ratio is that of two independent numbers.
    pub fn report_of(&self, studies: &[Study]) -> FigureReport {
        self.with_claims(studies, (self.figure.claims)(studies))
    }

    fn with_claims(&self, studies: &[Study], claims: Vec<Claim>) -> FigureReport {
        let Figure { name, title, statement, .. } = self.figure;
        let trials = least_trials(studies);
        let named = self.names.iter().zip(&self.experiments).map(|(name, experiment)| NamedScenario {
            name: (*name).to_string(),
            scenario: experiment.scenario(),
        });
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

    fn studies_of(&self, sums: impl Iterator<Item = Sums>) -> Result<Vec<Study>> {
        let each = self.experiments.iter().zip(sums);
        each.filter_map(|(experiment, sums)| experiment.report(self.trials, &sums).transpose()).collect()
    }

    fn check(&self, index: usize) -> Result<()> {
        let expected = self.jobs();
        if index < expected {
            return Ok(());
        }
        Err(Error::Size { what: "jobs of a figure before this one", found: index, expected: expected - 1 })
    }
}

/// Trials behind every number of some studies.
fn least_trials(studies: &[Study]) -> usize {
    studies.iter().map(Study::trials).min().unwrap_or(0)
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
        let count = self.experiments.len();
        self.experiments[next.job % count].merge(&next.sums)?;
        self.jobs += 1;
        Ok(())
    }
}
