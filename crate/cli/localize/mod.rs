//! `rangelab localize`: the pose from one snapshot.

mod table;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use rangelab::math::rotation::Manifold;
use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName};
use rangelab::study::localization::run::localize_trial;

use super::failure::Failure;
use super::input::ScenarioInput;
use super::output::Output;

const EXAMPLES: &str = "\
Examples:
  rangelab localize localization-paper                     the localization paper's estimators on one snapshot
  rangelab localize room --localizers ouc-ls,maximum-likelihood --trial 7
  rangelab localize localization-paper --group o           over all orthogonal matrices: it may mirror the body
  rangelab localize mine.json --format json -o poses.json  poses, sensors, errors and bounds

Only the ranges of the first epoch are used: no past, no motion. Each estimate stands beside its errors and, below, the \
least root mean square errors that the bounds allow.";

/// Find the pose from the ranges of one epoch alone
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct LocalizeCommand {
    #[command(flatten)]
    scenario: ScenarioInput,

    /// Which trial: picks the random numbers together with the seed
    #[arg(long, value_name = "NUMBER", default_value_t = 0)]
    trial: u64,

    #[command(flatten)]
    choices: LocalizerChoices,

    /// table: for people; json: everything, in full double precision; csv: a row for each estimator and bound
    #[arg(long, value_enum, default_value = "table", help_heading = "Output")]
    format: SnapshotFormat,

    #[command(flatten)]
    output: Output,
}

/// Each option that is given replaces one choice of the scenario.
#[derive(Args)]
#[command(next_help_heading = "Localizers (default: what the scenario says)")]
struct LocalizerChoices {
    /// Which run, separated by commas [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = localizer_names())]
    localizers: Option<Vec<LocalizerName>>,

    /// Rotations, or with reflections as in the papers [default: so]
    #[arg(long, value_name = "GROUP", value_parser = PossibleValuesParser::new(["so", "o"]))]
    group: Option<String>,

    /// ouc-tls: standard deviation of the mounting errors that it assumes, m [default: those of the scenario]
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    tls_sigma: Option<f64>,

    /// Search from more starts where an optimum cannot be certified
    #[arg(long)]
    multi_start: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum SnapshotFormat {
    Table,
    Json,
    Csv,
}

impl LocalizerChoices {
    fn apply(&self, settings: &mut LocalizeSettings) {
        if let Some(names) = &self.localizers {
            settings.enabled.clone_from(names);
        }
        if let Some(group) = &self.group {
            settings.manifold = if group == "o" { Manifold::O } else { Manifold::So };
        }
        settings.tls_sigma = self.tls_sigma.or(settings.tls_sigma);
        settings.multi_start |= self.multi_start;
    }
}

impl LocalizeCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let scenario = self.scenario.scenario(|scenario| self.choices.apply(&mut scenario.localize))?;
        let run = localize_trial(&scenario, self.trial)
            .map_err(|error| Failure::about(self.scenario.name(), &error))?;
        self.output.write(&match self.format {
            SnapshotFormat::Table => table::table(&run),
            SnapshotFormat::Csv => table::csv(&run),
            SnapshotFormat::Json => {
                serde_json::to_string(&run).expect("numbers and texts always have a JSON form")
            }
        })
    }
}

fn localizer_names() -> impl TypedValueParser<Value = LocalizerName> {
    let names = PossibleValuesParser::new(LocalizerName::ALL.map(LocalizerName::name));
    names.try_map(|name| name.parse::<LocalizerName>())
}
