//! `rangelab estimate`: a recording through the estimators.

use clap::Args;
use rangelab::Error;
use rangelab::model::estimator_settings::EstimatorSettings;
use rangelab::model::recording::RecordingDocument;
use rangelab::study::track_run::run_document;

use super::choices::Choices;
use super::failure::Failure;
use super::input::{name, read};
use super::output::{Output, RunFormat, completed, run_text};

const EXAMPLES: &str = "\
Examples:
  rangelab estimate recording.json                                every estimator, as JSON
  rangelab estimate recording.json --estimators uc-kf --format csv
  rangelab simulate room | rangelab estimate - --estimators eskf-raw

A recording is JSON; this is a whole one, in the plane, with one range missing:
  {\"version\": 1, \"dimension\": 2, \"noise\": {\"kind\": \"range\", \"sigma\": 0.05},
   \"anchors\": [[0, 0], [9, 0], [0, 9]], \"sensors\": [[0, 0], [1, 0]],
   \"epochs\": [{\"interval\": 0.1, \"ranges\": [[5.0, 5.7], [6.4, null], [6.7, 7.2]]}]}
Ranges are in metres: a row for each anchor, in it an entry for each sensor. Errors and bounds are written where an \
epoch has its \"truth\"; `rangelab simulate room --steps 1` shows an epoch with everything in it.";

/// Run the estimators over a recording, measured or simulated
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct EstimateCommand {
    /// A recording as JSON file, or - for stdin
    #[arg(value_name = "RECORDING")]
    recording: String,

    #[command(flatten)]
    choices: Choices,

    /// json: everything, in full double precision; csv: a row for each estimator and step
    #[arg(long, value_enum, default_value = "json", help_heading = "Output")]
    format: RunFormat,

    #[command(flatten)]
    output: Output,
}

impl EstimateCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let about = |error| Failure::about(name(&self.recording), &error);
        let recording = RecordingDocument::from_json(&read(&self.recording)?).map_err(about)?;
        let settings = self.settings()?;
        let run = run_document(&recording, &settings).map_err(about)?;
        self.output.write(&run_text(&run, self.format))?;
        completed(name(&self.recording), &run)
    }

    fn settings(&self) -> Result<EstimatorSettings, Failure> {
        let mut settings = EstimatorSettings::default();
        self.choices.apply(&mut settings);
        let problems = settings.validate();
        if problems.is_empty() {
            return Ok(settings);
        }
        let error = Error::Invalid { document: "estimator settings", problems };
        Err(Failure::about("command line", &error))
    }
}
