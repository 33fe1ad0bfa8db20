//! `rangelab indoor`: an IMU and ranges, one trial or many.

mod input;
mod run;
mod study;

use clap::{Args, Subcommand};

use super::failure::Failure;

const EXAMPLES: &str = "\
Examples:
  rangelab indoor run indoor-u                             every filter, one trial
  rangelab indoor study indoor-bridge --trials 1000        where EKFRie is not better than EKF
  rangelab indoor study indoor-u --convention disc         what another IMU makes of it
  rangelab presets indoor-u > mine.json                    to edit, then: rangelab indoor run mine.json
  rangelab figure indoor-5                                 what the paper claims, and what holds";

/// Follow a body by an IMU and ranges now and then
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct IndoorCommand {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    Run(run::RunCommand),
    Study(study::StudyCommand),
}

impl IndoorCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        match &self.task {
            Task::Run(command) => command.execute(),
            Task::Study(command) => command.execute(),
        }
    }
}
