//! The indoor scenario of a command, with the choices made on the command line.

use std::fmt::Display;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use rangelab::Error;
use rangelab::model::imu::Convention;
use rangelab::model::indoor::IndoorScenario;
use rangelab::model::indoor::filter_settings::FilterName;
use rangelab::model::indoor::presets::indoor_preset;

use crate::cli::failure::Failure;
use crate::cli::input::{document, name};

#[derive(Args)]
pub struct IndoorInput {
    /// Name of an indoor preset (see `rangelab presets`), an indoor scenario as JSON file, or - for stdin
    #[arg(value_name = "SCENARIO")]
    origin: String,

    /// Seed of the random numbers [default: the scenario's]
    #[arg(long, value_name = "NUMBER")]
    seed: Option<u64>,

    /// Which filters run, separated by commas [default: the scenario's]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = filter_names())]
    filters: Option<Vec<FilterName>>,

    /// How a sample of the IMU belongs to its interval: at its beginning, made for the paper's discretization, integrated
    /// over it, or the mean of both ends [default: the scenario's]
    #[arg(long, value_name = "NAME", value_parser = conventions())]
    convention: Option<Convention>,

    /// Standard deviation of a range, m [default: the scenario's]
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    sigma: Option<f64>,
}

impl IndoorInput {
    /// What messages call it.
    pub fn name(&self) -> impl Display + '_ {
        name(&self.origin)
    }

    /// The scenario with what was given.
    pub fn scenario(&self) -> Result<IndoorScenario, Failure> {
        let mut scenario = document(&self.origin, indoor_preset(&self.origin), IndoorScenario::from_json)?;
        scenario.seed = self.seed.unwrap_or(scenario.seed);
        scenario.imu.convention = self.convention.unwrap_or(scenario.imu.convention);
        scenario.ranging.sigma = self.sigma.unwrap_or(scenario.ranging.sigma);
        if let Some(filters) = &self.filters {
            scenario.filters.enabled.clone_from(filters);
        }
        let problems = scenario.validate();
        if problems.is_empty() {
            return Ok(scenario);
        }
        Err(Failure::about(self.name(), &Error::Invalid { document: "indoor scenario", problems }))
    }
}

fn filter_names() -> impl TypedValueParser<Value = FilterName> {
    PossibleValuesParser::new(FilterName::ALL.map(FilterName::name))
        .try_map(|name| name.parse::<FilterName>())
}

fn conventions() -> impl TypedValueParser<Value = Convention> {
    PossibleValuesParser::new(Convention::ALL.map(Convention::name))
        .try_map(|name| serde_json::from_value::<Convention>(name.into()))
}
