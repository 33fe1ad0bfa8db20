//! `rangelab place`: where the anchors of a scenario should stand.

mod searches;
mod table;

use std::num::NonZero;
use std::path::PathBuf;
use std::thread::available_parallelism;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use rangelab::model::placement_settings::{Criterion, Over, Target};
use rangelab::model::scenario::Scenario;
use rangelab::place::{Improvement, best_next};

use super::failure::Failure;
use super::input::ScenarioInput;
use super::output::{print, save};
use super::progress::progress;

const EXAMPLES: &str = "\
Examples:
  rangelab place room                                       what moving the anchors would give
  rangelab place room --restarts 20 -o better.json          and the scenario with the best anchors
  rangelab place mine.json --target pose --over worst --criterion e

The value is the unitarily constrained Cramer-Rao bound of one epoch of ranges as one number: A is the root of its \
trace, D the geometric mean of its standard deviations, E the largest of them. Where the body may be, where anchors may \
stand and which of them are fixed says the scenario's `placement`; form of the ranges and headings its `field`. The first \
search starts from the anchors as they are and is never worse, the others from random places (--seed 2: others). The last \
line is for the anchors as they are: where in the plane of the `field` one more would help most (`rangelab field \
--quantity next-anchor` shows all of that plane).";

/// More would be waited for too long.
const MOST_RESTARTS: usize = 1000;

/// Move the anchors to where they see the body best
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct PlaceCommand {
    #[command(flatten)]
    scenario: ScenarioInput,

    /// Searches from random places, besides the one from the anchors as they are
    #[arg(long, value_name = "COUNT", default_value_t = 4, value_parser = restarts)]
    restarts: usize,

    /// Number of threads [default: one for each processor]
    #[arg(long, value_name = "COUNT")]
    threads: Option<NonZero<usize>>,

    #[command(flatten)]
    goal: Goal,

    /// Write the scenario with the best anchors to this file
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    output: Option<PathBuf>,
}

/// What is made small; what is not given stays as the scenario says.
#[derive(Args)]
#[command(next_help_heading = "What is made small (default: what the scenario says)")]
struct Goal {
    /// Which number of the bound
    #[arg(long, value_name = "NAME", value_parser = criteria())]
    criterion: Option<Criterion>,

    /// The bound of what
    #[arg(long, value_name = "NAME", value_parser = targets())]
    target: Option<Target>,

    /// How several places of the body count together
    #[arg(long, value_name = "NAME", value_parser = overs())]
    over: Option<Over>,
}

impl PlaceCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let scenario = self.scenario.scenario(|scenario| self.goal.apply(scenario))?;
        let found = self.search(&scenario).map_err(|error| Failure::about(self.scenario.name(), &error))?;
        let values = found.iter().enumerate().filter_map(|(i, search)| Some((i, search.after?)));
        let Some((best, _)) = values.min_by(|(_, a), (_, b)| a.total_cmp(b)) else {
            let cause = found[0].cause.as_deref().unwrap_or_default();
            return Err(Failure::Other(format!("{}: {cause}", self.scenario.name())));
        };
        if let Some(path) = &self.output {
            save(path, &found[best].applied_to(&scenario).to_json())?;
        }
        let next = best_next(&scenario).map_err(|error| Failure::about(self.scenario.name(), &error))?;
        print(&table::table(&scenario, &found, best, next.as_ref()))
    }

    fn search(&self, scenario: &Scenario) -> rangelab::Result<Vec<Improvement>> {
        let threads = self.threads.or(available_parallelism().ok()).map_or(1, NonZero::get);
        let bar = progress(self.restarts + 1);
        let found = searches::run(scenario, self.restarts + 1, threads, || bar.inc(1));
        bar.finish_and_clear();
        found
    }
}

impl Goal {
    /// Puts what was given into the scenario.
    fn apply(&self, scenario: &mut Scenario) {
        let placement = &mut scenario.placement;
        placement.criterion = self.criterion.unwrap_or(placement.criterion);
        placement.target = self.target.unwrap_or(placement.target);
        placement.over = self.over.unwrap_or(placement.over);
    }
}

fn restarts(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| *count <= MOST_RESTARTS);
    count.ok_or_else(|| format!("it must be a number from 0 to {MOST_RESTARTS}"))
}

/// One of several names, each of which stands for a value.
fn one_of<T: Copy + Send + Sync + 'static>(
    names: &'static [(&'static str, T)],
) -> impl TypedValueParser<Value = T> {
    let of = |name: &str| names.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
    PossibleValuesParser::new(names.iter().map(|(name, _)| *name))
        .map(move |name| of(&name).expect("the parser knows only these names"))
}

fn criteria() -> impl TypedValueParser<Value = Criterion> {
    one_of(&[("a", Criterion::A), ("d", Criterion::D), ("e", Criterion::E)])
}

fn targets() -> impl TypedValueParser<Value = Target> {
    one_of(&[("position", Target::Position), ("orientation", Target::Orientation), ("pose", Target::Pose)])
}

fn overs() -> impl TypedValueParser<Value = Over> {
    one_of(&[("mean", Over::Mean), ("worst", Over::Worst)])
}
