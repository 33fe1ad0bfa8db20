//! `rangelab indoor study`: many trials.

use clap::{Args, ValueEnum};
use rangelab::math::float::degrees;
use rangelab::model::indoor::IndoorScenario;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::indoor::report::{IndoorFilterReport, IndoorReport, IndoorStepSummary};
use rangelab::study::moments::Estimate;

use super::input::IndoorInput;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::table::columns;
use crate::cli::workers::{Jobs, Threads};

const HEADER: [&str; 7] = ["", "position, m", "angle, deg", "NEES/9", "90 % below, m", "repairs", "failed"];
const LEGEND: &str = "
Each figure ± its standard error; a figure alone is certain to the digits shown, or of one trial.
  position, angle  mean over trials of the root mean square error over time
  NEES/9           squared error in units of the claimed covariance; 1 where it is right
  90 % below       position error that nine tenths of the trials stay below
  repairs          times in a trial that the covariance had to be made positive definite again
  failed           trials that ended in an error; the figures are those of the others
";

/// Run many trials and compare the filters
#[derive(Args)]
pub struct StudyCommand {
    #[command(flatten)]
    scenario: IndoorInput,

    /// Number of trials
    #[arg(long, value_name = "COUNT", default_value_t = 200)]
    trials: usize,

    #[command(flatten)]
    threads: Threads,

    /// table: for people; json: every step and figure; csv: a row for each filter and step
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

    fn study(&self, scenario: &IndoorScenario) -> Result<IndoorReport, Failure> {
        let about = |error| Failure::about(self.scenario.name(), &error);
        let study = IndoorMonteCarlo::new(scenario, self.trials).map_err(about)?;
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

fn table(report: &IndoorReport) -> String {
    let rows: Vec<_> = report.filters.iter().map(row).collect();
    let name = if report.name.is_empty() { "no name" } else { &report.name };
    format!("{name}: {} trials\n\n", report.trials) + &columns(HEADER, &rows) + LEGEND
}

fn row(filter: &IndoorFilterReport) -> [String; 7] {
    let summary = &filter.summary;
    let figure = |of: Estimate| if summary.trials > 0 { of.to_string() } else { String::new() };
    let rare = |count: usize| if count > 0 { count.to_string() } else { String::new() };
    let decile = rangelab::study::quantile::quantile(summary.position_distribution.iter().copied(), 0.9);
    let angle = Estimate {
        value: degrees(summary.angle.value),
        standard_error: degrees(summary.angle.standard_error),
    };
    [
        filter.label.clone(),
        figure(summary.position),
        figure(angle),
        figure(summary.nees),
        decile.map_or_else(String::new, |decile| format!("{decile:.4}")),
        if summary.repairs.value > 0.0 { figure(summary.repairs) } else { String::new() },
        rare(summary.failures),
    ]
}

type Figure = (&'static str, fn(&IndoorStepSummary) -> Estimate);

const FIGURES: [Figure; 5] = [
    ("rms_position_m", |step| step.position),
    ("rms_angle_rad", |step| step.angle),
    ("nees_per_degree_of_freedom", |step| step.nees),
    ("largest_singular_value", |step| step.largest_singular_value),
    ("smallest_singular_value", |step| step.smallest_singular_value),
];

/// A header, then a row for each filter and step.
fn csv(report: &IndoorReport) -> String {
    let mut header = ["filter", "step", "time_s", "trials", "failures"].map(str::to_owned).to_vec();
    header
        .extend(FIGURES.iter().flat_map(|(name, _)| [(*name).to_owned(), format!("{name}_standard_error")]));
    let mut rows = vec![header.join(",")];
    for IndoorFilterReport { name, summary, .. } in &report.filters {
        for ((index, step), time) in summary.steps.iter().enumerate().zip(&report.times) {
            let mut row = vec![name.to_string(), index.to_string(), format!("{time:?}")];
            row.extend([summary.trials, summary.failures].map(|count| count.to_string()));
            row.extend(FIGURES.iter().flat_map(|(_, of)| {
                let Estimate { value, standard_error } = of(step);
                [value, standard_error].map(|number| format!("{number:?}"))
            }));
            rows.push(row.join(","));
        }
    }
    rows.join("\n")
}
