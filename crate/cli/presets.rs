//! `rangelab presets`: the scenarios that come along.

use clap::Args;
use rangelab::model::presets::{PRESETS, preset};

use super::failure::Failure;
use super::output::Output;
use super::text::wrapped;

const EXAMPLES: &str = "\
Examples:
  rangelab presets                     their names and what they show
  rangelab presets room > mine.json    one as JSON, to edit and then `rangelab run mine.json`";

/// Longest line of the list.
const LINE: usize = 100;

/// List the scenarios that come along, or write one as JSON
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct PresetsCommand {
    /// Name of the preset to write
    #[arg(value_name = "NAME")]
    name: Option<String>,

    #[command(flatten)]
    output: Output,
}

impl PresetsCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        self.output.write(&match &self.name {
            None => list(),
            Some(name) => preset(name).map_err(|error| Failure::Usage(error.to_string()))?.to_json(),
        })
    }
}

/// Name, title and summary of each, the summaries wrapped to the width of a terminal.
fn list() -> String {
    let width = PRESETS.iter().map(|preset| preset.name.len()).max().unwrap_or(0);
    let entries = PRESETS.iter().map(|preset| {
        let lines = wrapped(preset.summary, LINE - width - 2);
        let first = format!("{:<width$}  {}\n", preset.name, preset.title);
        lines.iter().fold(first, |entry, line| entry + &format!("{:width$}  {line}\n", ""))
    });
    entries.collect::<Vec<_>>().join("\n")
}
