//! `rangelab presets`: the scenarios that come along.

use clap::Args;
use rangelab::model::indoor::presets::{INDOOR_PRESETS, indoor_preset};
use rangelab::model::kinematics::presets::{KINEMATICS_PRESETS, kinematics_preset};
use rangelab::model::presets::{PRESETS, preset};

use super::failure::Failure;
use super::output::Output;
use super::text::wrapped;

const EXAMPLES: &str = "\
Examples:
  rangelab presets                     their names and what they show
  rangelab presets room > mine.json    one as JSON, to edit and then `rangelab run mine.json`

Those called indoor-… are for `rangelab indoor`, those called kinematics-… for `rangelab anchorless`, the others for all \
other commands; `rangelab validate` takes any.";

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
        let text = self.name.as_ref().map_or_else(|| Ok(list()), |name| json(name));
        self.output.write(&text.map_err(|error| Failure::Usage(error.to_string()))?)
    }
}

fn json(name: &str) -> rangelab::Result<String> {
    if name.starts_with("indoor") {
        return Ok(indoor_preset(name)?.to_json());
    }
    if name.starts_with("kinematics") {
        return Ok(kinematics_preset(name)?.to_json());
    }
    Ok(preset(name)?.to_json())
}

/// Name, title and summary of each, the summaries wrapped to the width of a terminal.
fn list() -> String {
    let rigid = PRESETS.iter().map(|preset| (preset.name, preset.title, preset.summary));
    let indoor = INDOOR_PRESETS.iter().map(|preset| (preset.name, preset.title, preset.summary));
    let kinematics = KINEMATICS_PRESETS.iter().map(|preset| (preset.name, preset.title, preset.summary));
    let presets: Vec<_> = rigid.chain(indoor).chain(kinematics).collect();
    let width = presets.iter().map(|(name, ..)| name.len()).max().unwrap_or(0);
    let entries = presets.iter().map(|(name, title, summary)| {
        let lines = wrapped(summary, LINE - width - 2);
        let first = format!("{name:<width$}  {title}\n");
        lines.iter().fold(first, |entry, line| entry + &format!("{:width$}  {line}\n", ""))
    });
    entries.collect::<Vec<_>>().join("\n")
}
