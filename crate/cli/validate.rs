//! `rangelab validate`: all that is wrong with a document.

use clap::{Args, ValueEnum};
use rangelab::model::indoor::IndoorScenario;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::recording::RecordingDocument;
use rangelab::model::scenario::Scenario;
use rangelab::{Error, Problem};
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::failure::Failure;
use super::input::{name, read};
use super::output::Output;

const EXAMPLES: &str = "\
Examples:
  rangelab validate mine.json
  rangelab validate recording.json --format json

Exit code 0: no problem; 2: there are problems, one a line on stdout.";

/// Check a scenario of any kind or a recording and list every problem: path, value, limit
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct ValidateCommand {
    /// A scenario, an indoor or a kinematics scenario, or a recording as JSON file, or - for stdin
    #[arg(value_name = "FILE")]
    file: String,

    /// text: a sentence for each problem; json: a list of {path, value, limit}
    #[arg(long, value_enum, default_value = "text", help_heading = "Output")]
    format: ListFormat,

    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, ValueEnum)]
enum ListFormat {
    Text,
    Json,
}

/// What tells a recording, an indoor scenario and a kinematics scenario from a scenario.
#[derive(Default, Deserialize)]
struct Kind {
    epochs: Option<IgnoredAny>,
    path: Option<IgnoredAny>,
    beacons: Option<IgnoredAny>,
    transmitters: Option<IgnoredAny>,
    imu: Option<IgnoredAny>,
    ranging: Option<IgnoredAny>,
    filters: Option<IgnoredAny>,
    coefficients: Option<IgnoredAny>,
    stamps: Option<IgnoredAny>,
}

impl Kind {
    fn is_indoor(&self) -> bool {
        let Self { path, beacons, transmitters, imu, ranging, filters, .. } = self;
        [path, beacons, transmitters, imu, ranging, filters].into_iter().any(Option::is_some)
    }
}

impl ValidateCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let text = read(&self.file)?;
        let kind = serde_json::from_str::<Kind>(&text).unwrap_or_default();
        let (document, result) = if kind.epochs.is_some() {
            ("recording", RecordingDocument::from_json(&text).map(|_| ()))
        } else if kind.coefficients.is_some() || kind.stamps.is_some() {
            ("kinematics scenario", KinematicsScenario::from_json(&text).map(|_| ()))
        } else if kind.is_indoor() {
            ("indoor scenario", IndoorScenario::from_json(&text).map(|_| ()))
        } else {
            ("scenario", Scenario::from_json(&text).map(|_| ()))
        };
        let problems = match result {
            Ok(()) => Vec::new(),
            Err(Error::Invalid { problems, .. }) => problems,
            Err(error) => return Err(Failure::about(name(&self.file), &error)),
        };
        self.output.write(&self.list(document, &problems))?;
        if problems.is_empty() {
            return Ok(());
        }
        Err(Failure::Usage(format!("{}: the {document} has {} problem(s)", name(&self.file), problems.len())))
    }

    fn list(&self, document: &str, problems: &[Problem]) -> String {
        match self.format {
            ListFormat::Json => {
                serde_json::to_string_pretty(problems).expect("texts always have a JSON form")
            }
            ListFormat::Text if problems.is_empty() => {
                let article = if document.starts_with('i') { "an" } else { "a" };
                format!("{article} {document} without problems")
            }
            ListFormat::Text => problems.iter().map(Problem::to_string).collect::<Vec<_>>().join("\n"),
        }
    }
}
