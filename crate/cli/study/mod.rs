//! `rangelab study`: many trials, and what they say.

mod budget;
mod columns;
mod comparison;
mod table;

use clap::{Args, ValueEnum};
use rangelab::model::scenario::Scenario;
use rangelab::study::budget::{Budget, BudgetReport};
use rangelab::study::monte_carlo::MonteCarlo;
use rangelab::study::report::StudyReport;

use super::choices::Choices;
use super::failure::Failure;
use super::input::ScenarioInput;
use super::output::Output;
use super::workers::{Jobs, Threads};

const EXAMPLES: &str = "\
Examples:
  rangelab study tracking-paper --trials 1000            the tracking paper's experiment
  rangelab study tracking-paper-redrawn --trials 1000    the same, new anchors in every trial
  rangelab study room --estimators uc-kf,eskf --steps 50 --steps-shown 0,9,49
  rangelab study mine.json --format csv -o study.csv     every step and figure, for a plot
  rangelab study tracking-paper --thresholds 0.05,0.1,0.15,0.2,0.3
                                                         what the projections of the ET-KF cost and give

The table holds root mean square errors with their standard errors, their ratios to the posterior Cramer-Rao bound and \
to what the estimator's own covariance claims, NEES, and how often Q was projected.
Trial i always gets the same random numbers, and sums are taken in the order of the trials: the result does not depend \
on the number of threads. Another seed (--seed 2) shows what is chance. Ctrl-C stops and writes nothing.";

/// Run many trials and compare the errors with what is claimed and what is possible
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct StudyCommand {
    #[command(flatten)]
    scenario: ScenarioInput,

    /// Number of trials
    #[arg(long, value_name = "COUNT", default_value_t = 1000)]
    trials: usize,

    #[command(flatten)]
    threads: Threads,

    #[command(flatten)]
    choices: Choices,

    /// table: for people, at chosen steps; json and csv: every step and figure
    #[arg(long, value_enum, default_value = "table", help_heading = "Output")]
    format: StudyFormat,

    /// Steps in the table, from 0, separated by commas [default: 0,1,2,4,9,19,49,... and the last]
    #[arg(long, value_name = "STEPS", value_delimiter = ',', help_heading = "Output")]
    steps_shown: Option<Vec<usize>>,

    /// Instead of the averages: errors of the ET-KF and projections in a run at these thresholds, separated by commas
    #[arg(long, value_name = "EPSILONS", value_delimiter = ',', conflicts_with = "steps_shown")]
    thresholds: Option<Vec<f64>>,

    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum StudyFormat {
    Table,
    Json,
    Csv,
}

impl StudyCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let scenario = self.scenario.scenario(|scenario| self.choices.apply(&mut scenario.estimators))?;
        if let Some(thresholds) = &self.thresholds {
            let report = self.budget(&scenario, thresholds)?;
            return self.output.write(&match self.format {
                StudyFormat::Table => budget::table(&report),
                StudyFormat::Csv => budget::csv(&report),
                StudyFormat::Json => json(&report),
            });
        }
        let steps = self.steps(scenario.steps)?;
        let report = self.study(&scenario)?;
        self.output.write(&match self.format {
            StudyFormat::Table => table::table(&report, &steps),
            StudyFormat::Csv => columns::csv(&report),
            StudyFormat::Json => json(&report),
        })
    }

    fn study(&self, scenario: &Scenario) -> Result<StudyReport, Failure> {
        let about = |error| Failure::about(self.scenario.name(), &error);
        let study = MonteCarlo::new(scenario, self.trials).map_err(about)?;
        let mut total = study.start();
        let jobs = Jobs {
            count: study.blocks(),
            job: |index| study.block(index),
            merge: |block| total.merge(&block),
        };
        jobs.run(self.scenario.name(), self.threads.count())?;
        Ok(study.report(&total))
    }

    fn budget(&self, scenario: &Scenario, thresholds: &[f64]) -> Result<BudgetReport, Failure> {
        let about = |error| Failure::about(self.scenario.name(), &error);
        let budget = Budget::new(scenario, thresholds, self.trials).map_err(about)?;
        let mut total = budget.start();
        let jobs = Jobs {
            count: budget.blocks(),
            job: |index| budget.block(index),
            merge: |block| total.merge(&block),
        };
        jobs.run(self.scenario.name(), self.threads.count())?;
        Ok(budget.report(&total))
    }

    /// The steps of the table.
    fn steps(&self, count: usize) -> Result<Vec<usize>, Failure> {
        let Some(given) = &self.steps_shown else {
            let marks = [0, 1, 2, 4, 9, 19, 49, 99, 199, 499, 999, 1999, 4999].into_iter();
            return Ok(marks.take_while(|&step| step + 1 < count).chain([count - 1]).collect());
        };
        match given.iter().find(|&&step| step >= count) {
            None => Ok(given.clone()),
            Some(step) => Err(Failure::Usage(format!(
                "--steps-shown {step}: the scenario has {count} steps, 0 to {}",
                count - 1
            ))),
        }
    }
}

fn json(report: &impl serde::Serialize) -> String {
    serde_json::to_string(report).expect("numbers and texts always have a JSON form")
}
