//! `rangelab field`: the bound as a landscape over a plane.

mod grid;
mod picture;
mod plane;
mod point;
mod settings;
mod table;

use clap::{Args, ValueEnum};

use super::failure::Failure;
use super::input::ScenarioInput;
use super::output::Output;
use grid::Grid;
use plane::PlaneOptions;
use settings::SettingsOptions;

const EXAMPLES: &str = "\
Examples:
  rangelab field room --format png -o field.png          where the body's position is found how well
  rangelab field room --quantity orientation --limit 2   in degrees, as a table
  rangelab field room --plane vertical --heading-deg 90 --offset -3
  rangelab field room --at 4,3,1                         the bounds at one point, with a sentence
  rangelab field room --quantity next-anchor             where one more anchor helps most; goal: see `rangelab place`

The bound is the UC-CRB: no unbiased estimator is better from the ranges of one epoch. The body has the attitude that it \
starts with. A cell's value is empty where some motion of the body is not seen at all. Table and picture hold the \
scenario.";

/// Write the bound on position or orientation over a plane, as table or picture, or at one point: of the body there, or
/// with one more anchor there
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct FieldCommand {
    #[command(flatten)]
    scenario: ScenarioInput,

    #[command(flatten)]
    plane: PlaneOptions,

    #[command(flatten)]
    settings: SettingsOptions,

    /// Cells along the longer edge
    #[arg(long, value_name = "COUNT", default_value_t = 128, help_heading = "Output")]
    resolution: usize,

    /// Only the bounds at this point of the world, m: a sentence, or json
    #[arg(
        long,
        value_name = "X,Y[,Z]",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help_heading = "Output"
    )]
    #[arg(conflicts_with_all = ["plane", "height", "heading_deg", "offset", "headings", "limit", "resolution"])]
    at: Option<Vec<f64>>,

    /// csv: a row for each cell; json: rows of numbers, null without a bound; png: a picture [default: csv]
    #[arg(long, value_enum, help_heading = "Output")]
    format: Option<FieldFormat>,

    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, ValueEnum)]
enum FieldFormat {
    Csv,
    Json,
    Png,
}

impl FieldCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let plane = self.plane.choice()?;
        let scenario = self.scenario.scenario(|scenario| {
            plane.apply(&mut scenario.field.plane);
            self.settings.apply(scenario);
        })?;
        let about = |error| Failure::about(self.scenario.name(), &error);
        if let Some(point) = &self.at {
            if self.settings.is_of_body() {
                let sentence = "--at gives both bounds of the body; with --quantity next-anchor, those of one more anchor";
                return Err(Failure::Usage(sentence.to_owned()));
            }
            let found = point::found(&scenario, point).map_err(about)?;
            return self.output.write(&match self.format {
                None => found.sentence(),
                Some(FieldFormat::Json) => found.json(),
                Some(_) => return Err(Failure::Usage("--at gives a sentence, or json".to_owned())),
            });
        }
        let grid = Grid::new(scenario, self.resolution).map_err(about)?;
        match self.format {
            Some(FieldFormat::Json) => self.output.write(&table::json(&grid)),
            Some(FieldFormat::Png) => self.output.write_bytes(&picture::png(&grid)?),
            Some(FieldFormat::Csv) | None => self.output.write(&table::csv(&grid)),
        }
    }
}
