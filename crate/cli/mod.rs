//! The door from a shell: what can be asked, and who answers.

mod anchorless;
mod choices;
mod estimate;
mod failure;
mod field;
mod figure;
mod indoor;
mod input;
mod localize;
mod output;
mod picture;
mod place;
mod presets;
mod progress;
mod run;
mod simulate;
mod study;
mod table;
mod text;
mod validate;
mod workers;

use clap::{Parser, Subcommand};

use failure::Failure;

const ABOUT: &str =
    "Position and orientation of a rigid body from ranges between sensors on it and known anchors";
const EXAMPLES: &str = "\
Examples:
  rangelab presets                               what is there to try
  rangelab study tracking-paper --trials 1000    errors, bounds and their ratios over many trials
  rangelab figure tracking-2 -o figure.svg       a figure of a paper, with what holds of it
  rangelab indoor study indoor-u                 filters of an IMU and ranges
  rangelab anchorless study kinematics-paper     nodes that move, without anchors
  rangelab place room -o better.json             where the anchors should stand
  rangelab run room --format csv -o run.csv      one trial, every step of every estimator
  rangelab field room --format png -o field.png  the bound as a landscape
  rangelab presets room > mine.json              a scenario to edit, then: rangelab run mine.json
  rangelab simulate room | rangelab estimate -   what real ranges go through

`rangelab COMMAND --help` says more about each. Lengths are in metres, times in seconds, angles in radians, unless a \
name says otherwise.
Only data go to stdout. Exit code 2: the command line or the data are wrong; 1: anything else.";

/// All arguments.
#[derive(Parser)]
#[command(name = "rangelab", version, about = ABOUT, after_help = EXAMPLES, arg_required_else_help = true)]
pub struct CommandLine {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    Run(run::RunCommand),
    Simulate(simulate::SimulateCommand),
    Estimate(estimate::EstimateCommand),
    Localize(localize::LocalizeCommand),
    Indoor(indoor::IndoorCommand),
    Anchorless(anchorless::AnchorlessCommand),
    Study(study::StudyCommand),
    Figure(figure::FigureCommand),
    Field(field::FieldCommand),
    Place(place::PlaceCommand),
    Presets(presets::PresetsCommand),
    Validate(validate::ValidateCommand),
}

impl Command {
    /// Does what was asked.
    pub fn execute(&self) -> Result<(), Failure> {
        match self {
            Self::Run(command) => command.execute(),
            Self::Simulate(command) => command.execute(),
            Self::Estimate(command) => command.execute(),
            Self::Localize(command) => command.execute(),
            Self::Indoor(command) => command.execute(),
            Self::Anchorless(command) => command.execute(),
            Self::Study(command) => command.execute(),
            Self::Figure(command) => command.execute(),
            Self::Field(command) => command.execute(),
            Self::Place(command) => command.execute(),
            Self::Presets(command) => command.execute(),
            Self::Validate(command) => command.execute(),
        }
    }
}
