//! `rangelab anchorless`: mobile nodes and the distances between them, one trial or many.

mod figures;
mod input;
mod run;
mod study;

use clap::{Args, Subcommand};

use super::failure::Failure;

const EXAMPLES: &str = "\
Examples:
  rangelab anchorless run kinematics-paper                           every estimator, one trial
  rangelab anchorless study kinematics-paper --trials 1000           beside the bounds
  rangelab anchorless study kinematics-paper --stamps 10             what few stamps leave
  rangelab anchorless run kinematics-four --estimators algorithm-1-rank1,maximum-likelihood
  rangelab presets kinematics-paper > mine.json                      to edit, then: rangelab anchorless run mine.json
  rangelab figure kinematics-2a                                      what the paper claims, and what holds";

/// Find how nodes move relative to each other, from the distances between them alone or with accelerations
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct AnchorlessCommand {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    Run(run::RunCommand),
    Study(study::StudyCommand),
}

impl AnchorlessCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        match &self.task {
            Task::Run(command) => command.execute(),
            Task::Study(command) => command.execute(),
        }
    }
}
