//! `rangelab anchorless study`: many trials.

use clap::{Args, ValueEnum};
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::kinematics::report::{KinematicsEstimatorReport, KinematicsReport};
use rangelab::study::moments::Estimate;

use super::figures::{Figures, LEGEND, exact, failures, header};
use super::input::KinematicsInput;
use super::run::bound_name;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::table::columns;
use crate::cli::workers::{Jobs, Threads};

const ERRORS: &str = "
Each figure ± its standard error; a figure alone is certain to the digits shown, or of one trial.
failed: trials that ended in an error; the figures are those of the others.
";

/// Run many trials and hold the estimators beside the bounds
#[derive(Args)]
pub struct StudyCommand {
    #[command(flatten)]
    scenario: KinematicsInput,

    /// Number of trials
    #[arg(long, value_name = "COUNT", default_value_t = 200)]
    trials: usize,

    #[command(flatten)]
    threads: Threads,

    /// table: for people; json: every figure; csv: a row for each figure
    #[arg(long, value_enum, default_value = "table", help_heading = "Output")]
    format: Format,

    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    Table,
    Json,
    Csv,
}

impl StudyCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let report = self.study(&self.scenario.scenario()?)?;
        self.output.write(&match self.format {
            Format::Table => table(&report),
            Format::Json => {
                serde_json::to_string(&report).expect("numbers and texts always have a JSON form")
            }
            Format::Csv => csv(&report),
        })
    }

    fn study(&self, scenario: &KinematicsScenario) -> Result<KinematicsReport, Failure> {
        let about = |error| Failure::about(self.scenario.name(), &error);
        let study = KinematicsMonteCarlo::new(scenario, self.trials).map_err(about)?;
        let mut total = study.start();
        let jobs = Jobs {
            count: study.blocks(),
            job: |index| study.block(index),
            merge: |block| total.merge(&block),
        };
        jobs.run(self.scenario.name(), self.threads.count())?;
        Ok(study.report(&total))
    }
}

fn figures(estimator: &KinematicsEstimatorReport) -> Figures<'_, Estimate> {
    let summary = &estimator.summary;
    Figures {
        coefficients: &summary.coefficients,
        gram: &summary.gram,
        positions: &summary.positions,
        aligned_positions: &summary.aligned_positions,
    }
}

fn table(report: &KinematicsReport) -> String {
    let estimators = report.estimators.iter().map(|estimator| {
        let failed = estimator.summary.failures;
        let last = if failed > 0 { failed.to_string() } else { String::new() };
        figures(estimator).row(&estimator.label, Estimate::to_string, last)
    });
    let bounds = &report.bounds;
    let bounds_rows =
        bounds.iter().map(|bound| Figures::of_bound(bound).row(&bound.label, |it| exact(*it), String::new()));
    let rows: Vec<_> = estimators.chain(bounds_rows).collect();
    let sentences = bounds.iter().map(|bound| (bound.label.as_str(), bound.failure.as_ref()));
    let name = if report.name.is_empty() { "no name" } else { &report.name };
    let title = format!("{name}: {} trials, {} stamps\n\n", report.trials, report.stamps);
    title + &columns(header("failed"), &rows) + &failures(sentences) + ERRORS + LEGEND
}

/// A header, then a row for each figure of each estimator and bound.
fn csv(report: &KinematicsReport) -> String {
    let mut rows =
        vec!["kind,name,trials,failures,quantity,order,time_s,rmse,rmse_standard_error".to_owned()];
    for estimator in &report.estimators {
        let summary = &estimator.summary;
        let start = format!("estimator,{},{},{}", estimator.name, summary.trials, summary.failures);
        let number = |it: &Estimate| format!("{:?},{:?}", it.value, it.standard_error);
        rows.extend(figures(estimator).rows(&start, &report.instants, number));
    }
    for bound in &report.bounds {
        let start = format!("bound,{},,", bound_name(bound));
        rows.extend(Figures::of_bound(bound).rows(&start, &report.instants, |it| format!("{it:?},")));
    }
    rows.join("\n")
}
