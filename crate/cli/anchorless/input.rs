//! The kinematics scenario of a command, with the choices made on the command line.

use std::fmt::Display;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use rangelab::Error;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::presets::kinematics_preset;
use rangelab::model::kinematics::settings::KinematicsName;

use crate::cli::failure::Failure;
use crate::cli::input::{document, name};

#[derive(Args)]
pub struct KinematicsInput {
    /// Name of a kinematics preset (see `rangelab presets`), a kinematics scenario as JSON file, or - for stdin
    #[arg(value_name = "SCENARIO")]
    origin: String,

    /// Seed of the random numbers [default: the scenario's]
    #[arg(long, value_name = "NUMBER")]
    seed: Option<u64>,

    /// How many stamps, evenly over the scenario's time [default: the scenario's]
    #[arg(long, value_name = "COUNT")]
    stamps: Option<usize>,

    /// Standard deviation of a distance, m [default: the scenario's]
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    sigma: Option<f64>,

    /// Which estimators run, separated by commas [default: the scenario's]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = estimator_names())]
    estimators: Option<Vec<KinematicsName>>,
}

impl KinematicsInput {
    /// What messages call it.
    pub fn name(&self) -> impl Display + '_ {
        name(&self.origin)
    }

    /// The scenario with what was given.
    pub fn scenario(&self) -> Result<KinematicsScenario, Failure> {
        let mut scenario =
            document(&self.origin, kinematics_preset(&self.origin), KinematicsScenario::from_json)?;
        scenario.seed = self.seed.unwrap_or(scenario.seed);
        scenario.noise.sigma_distance = self.sigma.unwrap_or(scenario.noise.sigma_distance);
        if let Some(count) = self.stamps {
            scenario.stamps = scenario.stamps.evenly(count);
        }
        if let Some(estimators) = &self.estimators {
            scenario.estimators.enabled.clone_from(estimators);
        }
        let problems = scenario.validate();
        if problems.is_empty() {
            return Ok(scenario);
        }
        Err(Failure::about(self.name(), &Error::Invalid { document: "kinematics scenario", problems }))
    }
}

fn estimator_names() -> impl TypedValueParser<Value = KinematicsName> {
    PossibleValuesParser::new(KinematicsName::ALL.map(KinematicsName::name))
        .try_map(|name| name.parse::<KinematicsName>())
}
