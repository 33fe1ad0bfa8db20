//! `rangelab run`: one trial of a scenario.

use clap::Args;
use rangelab::study::track_run::run_scenario;

use super::choices::Choices;
use super::failure::Failure;
use super::input::ScenarioInput;
use super::output::{Output, RunFormat, completed, run_text};

const EXAMPLES: &str = "\
Examples:
  rangelab run room                                        all estimators, one trial, as JSON
  rangelab run room --trial 7 --format csv -o run.csv      another trial, as a table
  rangelab run mine.json --estimators ortho,et-kf --feedback --epsilon 0.3

The run holds, for every estimator and step, the prior, innovation and posterior, the covariance, the defect of Q, NIS, \
NEES and the errors, and the bounds beside them. The same scenario, seed and trial give the same bits on every machine and in the browser.";

/// Simulate one trial and run the estimators over it
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct RunCommand {
    #[command(flatten)]
    scenario: ScenarioInput,

    /// Which trial: picks the random numbers together with the seed
    #[arg(long, value_name = "NUMBER", default_value_t = 0)]
    trial: u64,

    #[command(flatten)]
    choices: Choices,

    /// json: everything, in full double precision; csv: a row for each estimator and step
    #[arg(long, value_enum, default_value = "json", help_heading = "Output")]
    format: RunFormat,

    #[command(flatten)]
    output: Output,
}

impl RunCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let scenario = self.scenario.scenario(|scenario| self.choices.apply(&mut scenario.estimators))?;
        let run = run_scenario(&scenario, self.trial)
            .map_err(|error| Failure::about(self.scenario.name(), &error))?;
        self.output.write(&run_text(&run, self.format))?;
        completed(self.scenario.name(), &run)
    }
}
