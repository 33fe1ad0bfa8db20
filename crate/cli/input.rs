//! Where scenarios and recordings come from: presets, files, stdin.

use std::fmt::Display;
use std::fs::File;
use std::io::{self, Read};

use clap::Args;
use rangelab::Error;
use rangelab::model::presets;
use rangelab::model::scenario::Scenario;

use super::failure::Failure;

/// A text longer than this is no document; the limits of scenarios and recordings end far below.
const LONGEST_GIB: u64 = 1;

#[derive(Args)]
pub struct ScenarioInput {
    /// Name of a preset (see `rangelab presets`), a scenario as JSON file, or - for stdin
    #[arg(value_name = "SCENARIO")]
    origin: String,

    /// Number of epochs [default: the scenario's]
    #[arg(long, value_name = "COUNT")]
    steps: Option<usize>,

    /// Seed of the random numbers [default: the scenario's]
    #[arg(long, value_name = "NUMBER")]
    seed: Option<u64>,
}

impl ScenarioInput {
    /// What messages call it.
    pub fn name(&self) -> impl Display + '_ {
        name(&self.origin)
    }

    /// The scenario with `change` made to it.
    pub fn scenario(&self, change: impl FnOnce(&mut Scenario)) -> Result<Scenario, Failure> {
        let mut scenario = self.unchanged()?;
        scenario.steps = self.steps.unwrap_or(scenario.steps);
        scenario.seed = self.seed.unwrap_or(scenario.seed);
        change(&mut scenario);
        let problems = scenario.validate();
        if problems.is_empty() {
            return Ok(scenario);
        }
        Err(Failure::about(self.name(), &Error::Invalid { document: "scenario", problems }))
    }

    fn unchanged(&self) -> Result<Scenario, Failure> {
        document(&self.origin, presets::preset(&self.origin), Scenario::from_json)
    }
}

/// The preset of a name, or else what is read from the file of that name, or from stdin for `-`.
pub fn document<T>(
    origin: &str,
    preset: rangelab::Result<T>,
    from_json: fn(&str) -> rangelab::Result<T>,
) -> Result<T, Failure> {
    let unknown = match preset {
        Ok(document) => return Ok(document),
        Err(unknown) => unknown,
    };
    let looks_like_a_name = !origin.contains(['/', '\\', '.']) && origin != "-";
    if looks_like_a_name && !std::path::Path::new(origin).exists() {
        return Err(Failure::Usage(format!("{unknown}; nor is there a file of that name")));
    }
    from_json(&read(origin)?).map_err(|error| Failure::about(name(origin), &error))
}

/// The text of a file, or of stdin for `-`.
pub fn read(origin: &str) -> Result<String, Failure> {
    let text =
        if origin == "-" { read_text(io::stdin().lock()) } else { File::open(origin).and_then(read_text) };
    text.map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => Failure::Usage(format!("{origin}: there is no such file")),
        // The kind says it without the number of the operating system.
        kind if error.raw_os_error().is_some() => Failure::Usage(format!("{origin} cannot be read: {kind}")),
        _ => Failure::Usage(format!("{origin} cannot be read: {error}")),
    })
}

fn read_text(source: impl Read) -> io::Result<String> {
    let limit = LONGEST_GIB << 30;
    let mut text = String::new();
    let length = source.take(limit + 1).read_to_string(&mut text)?;
    if length as u64 > limit {
        return Err(io::Error::other(format!("it is longer than {LONGEST_GIB} GiB")));
    }
    Ok(text)
}

/// The name shown for an origin.
pub fn name(origin: &str) -> impl Display + '_ {
    if origin == "-" { "stdin" } else { origin }
}
