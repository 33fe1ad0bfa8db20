//! `rangelab simulate`: what the estimators would be given.

use clap::Args;
use rangelab::model::recording::RecordingDocument;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;
use rangelab::with_dimension;

use super::failure::Failure;
use super::input::ScenarioInput;
use super::output::Output;

const EXAMPLES: &str = "\
Examples:
  rangelab simulate room -o recording.json
  rangelab estimate recording.json --format csv
  rangelab simulate tracking-paper --trial 3 --steps 5 | rangelab estimate -

The recording has the form in which `rangelab estimate` reads real ranges.";

/// Simulate one trial and write the recording: the ranges, the known motion and the truth
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct SimulateCommand {
    #[command(flatten)]
    scenario: ScenarioInput,

    /// Which trial: picks the random numbers together with the seed
    #[arg(long, value_name = "NUMBER", default_value_t = 0)]
    trial: u64,

    #[command(flatten)]
    output: Output,
}

impl SimulateCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let scenario = self.scenario.scenario(|_| ())?;
        let recording =
            self.recording(&scenario).map_err(|error| Failure::about(self.scenario.name(), &error))?;
        self.output.write(&recording.to_json())
    }

    fn recording(&self, scenario: &Scenario) -> rangelab::Result<RecordingDocument> {
        with_dimension!(scenario.dimension, D => {
            Ok(RecordingDocument::new(&scenario.name, &simulate::<D>(scenario, self.trial)?))
        })
    }
}
