//! `rangelab anchorless run`: one trial.

use clap::{Args, ValueEnum};
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::run::{KinematicsEstimatorRun, KinematicsRun};
use rangelab::study::kinematics::bounds::{KinematicsBoundReport, kinematics_bounds};
use rangelab::study::kinematics::errors::Yardstick;
use rangelab::study::kinematics::run::run_kinematics;

use super::figures::{Figures, LEGEND, exact, failures, header};
use super::input::KinematicsInput;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::table::columns;

/// Simulate one trial and run the estimators on it
#[derive(Args)]
pub struct RunCommand {
    #[command(flatten)]
    scenario: KinematicsInput,

    /// Which trial: picks the random numbers together with the seed
    #[arg(long, value_name = "NUMBER", default_value_t = 0)]
    trial: u64,

    /// table: for people; json: everything, in full double precision; csv: a row for each figure
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
        let scenario = self.scenario.scenario()?;
        let run = run_kinematics(&scenario, self.trial).map_err(about)?;
        let bounds = || bounds(&scenario).map_err(about);
        self.output.write(&match self.format {
            Format::Table => table(&run, &bounds()?),
            Format::Json => run.to_json(),
            Format::Csv => csv(&run, &bounds()?),
        })
    }
}

fn bounds(scenario: &KinematicsScenario) -> rangelab::Result<[KinematicsBoundReport; 2]> {
    let setup = scenario.setup()?;
    Ok(kinematics_bounds(scenario, &setup, &Yardstick::new(scenario, &setup)))
}

fn figures(estimator: &KinematicsEstimatorRun) -> Figures<'_, f64> {
    Figures {
        coefficients: &estimator.coefficient_errors,
        gram: &estimator.gram_errors,
        positions: &estimator.position_errors,
        aligned_positions: &estimator.aligned_position_errors,
    }
}

fn table(run: &KinematicsRun, bounds: &[KinematicsBoundReport]) -> String {
    let estimators = run.estimators.iter().map(|estimator| {
        let last = match estimator.failure {
            Some(_) => "no estimate".to_owned(),
            None => estimator.iterations.to_string(),
        };
        figures(estimator).row(&estimator.label, |it| exact(*it), last)
    });
    let bounds_rows =
        bounds.iter().map(|bound| Figures::of_bound(bound).row(&bound.label, |it| exact(*it), String::new()));
    let rows: Vec<_> = estimators.chain(bounds_rows).collect();
    let sentences = run.estimators.iter().map(|each| (each.label.as_str(), each.failure.as_ref()));
    let of_bounds = bounds.iter().map(|bound| (bound.label.as_str(), bound.failure.as_ref()));
    let missing =
        if run.missing > 0 { format!(", {} distances missing", run.missing) } else { String::new() };
    let title = format!("{}: {} nodes, {} stamps{missing}\n\n", run.name, nodes(run), run.stamps.len());
    title + &columns(header("iterations"), &rows) + &failures(sentences.chain(of_bounds)) + LEGEND
}

fn nodes(run: &KinematicsRun) -> usize {
    run.truth.first().map_or(0, Vec::len)
}

/// A header, then a row for each figure of each estimator and bound.
fn csv(run: &KinematicsRun, bounds: &[KinematicsBoundReport]) -> String {
    let number = |figure: &f64| format!("{figure:?}");
    let mut rows = vec!["kind,name,quantity,order,time_s,rmse".to_owned()];
    for estimator in &run.estimators {
        let start = format!("estimator,{}", estimator.name);
        rows.extend(figures(estimator).rows(&start, &run.instants, number));
    }
    for bound in bounds {
        let start = format!("bound,{}", bound_name(bound));
        rows.extend(Figures::of_bound(bound).rows(&start, &run.instants, number));
    }
    rows.join("\n")
}

/// As in the figures.
pub fn bound_name(bound: &KinematicsBoundReport) -> &'static str {
    if bound.accelerations { "crb-accelerometers" } else { "crb-distances" }
}
