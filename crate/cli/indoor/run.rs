//! `rangelab indoor run`: one trial.

use clap::{Args, ValueEnum};
use rangelab::math::float::degrees;
use rangelab::model::indoor::run::{IndoorFilterRun, IndoorRun};
use rangelab::study::indoor::run::run_indoor;

use super::input::IndoorInput;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::table::columns;

const HEADER: [&str; 6] = ["", "position, m", "angle, deg", "NEES/9", "last position, m", "R stretched by"];
const LEGEND: &str = "
  position, angle  root mean square of the errors over the steps of this trial
  NEES/9           squared error in units of the claimed covariance; 1 where it is right
  R stretched by   largest singular value of the filter's R at the end; 1 for a rotation
";

/// Simulate one trial and run the filters over it
#[derive(Args)]
pub struct RunCommand {
    #[command(flatten)]
    scenario: IndoorInput,

    /// Which trial: picks the random numbers together with the seed
    #[arg(long, value_name = "NUMBER", default_value_t = 0)]
    trial: u64,

    /// table: for people; json: everything, in full double precision; csv: a row for each filter and step
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

impl RunCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let about = |error| Failure::about(self.scenario.name(), &error);
        let run = run_indoor(&self.scenario.scenario()?, self.trial).map_err(about)?;
        self.output.write(&match self.format {
            Format::Table => table(&run),
            Format::Json => run.to_json(),
            Format::Csv => csv(&run),
        })?;
        self.completed(&run)
    }

    /// A failure that names the filters that stopped early.
    fn completed(&self, run: &IndoorRun) -> Result<(), Failure> {
        let stopped = run.filters.iter().filter_map(|filter| {
            let failure = filter.failure.as_ref()?;
            Some(format!("{} stopped at step {}: {}", filter.name, failure.step, failure.message))
        });
        let stopped: Vec<String> = stopped.collect();
        if stopped.is_empty() {
            return Ok(());
        }
        Err(Failure::Other(format!("{}: {}", self.scenario.name(), stopped.join("; "))))
    }
}

fn table(run: &IndoorRun) -> String {
    let row = |filter: &IndoorFilterRun| {
        let last = filter.steps.last();
        let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:.4}"));
        let of_steps = |figure: f64| number(last.map(|_| figure));
        [
            filter.label.clone(),
            of_steps(filter.rms_position_error()),
            of_steps(degrees(filter.rms_angle_error())),
            of_steps(filter.mean_nees()),
            number(last.map(|step| step.position_error)),
            number(last.map(|step| step.singular_values[0])),
        ]
    };
    let rows: Vec<_> = run.filters.iter().map(row).collect();
    let seconds = run.times.last().copied().unwrap_or_default();
    let title = format!("{}: {} steps in {seconds:.1} s\n\n", run.name, run.times.len());
    title + &columns(HEADER, &rows) + LEGEND
}

/// A header, then a row for each filter and step.
fn csv(run: &IndoorRun) -> String {
    let header = "filter,step,time_s,x_m,y_m,z_m,position_error_m,angle_error_rad,\
                  nees_per_degree_of_freedom,nis_per_degree_of_freedom,\
                  largest_singular_value,smallest_singular_value,repairs";
    let mut rows = vec![header.to_owned()];
    for filter in &run.filters {
        for ((index, step), time) in filter.steps.iter().enumerate().zip(&run.times) {
            let nis = step.nis.map_or_else(String::new, |nis| format!("{nis:?}"));
            let mut row = vec![filter.name.to_string(), index.to_string(), format!("{time:?}")];
            row.extend(step.pose.position.iter().map(|x| format!("{x:?}")));
            row.extend([step.position_error, step.angle_error, step.nees].map(|x| format!("{x:?}")));
            row.push(nis);
            row.extend([step.singular_values[0], step.singular_values[2]].map(|x| format!("{x:?}")));
            row.push(step.repairs.to_string());
            rows.push(row.join(","));
        }
    }
    rows.join("\n")
}
