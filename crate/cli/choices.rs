//! Options that choose estimators, the same in every command that runs them.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use rangelab::math::rotation::Manifold;
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings, Metric, ThresholdKind};

/// Each option that is given replaces one choice; the others stay as they were.
#[derive(Args)]
#[command(next_help_heading = "Estimators (default: what the scenario says; for a recording as in brackets)")]
pub struct Choices {
    /// Which run, separated by commas [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = estimator_names())]
    estimators: Option<Vec<EstimatorName>>,

    /// What Q is projected onto: rotations, or with reflections as in the papers [default: so]
    #[arg(long, value_name = "GROUP", value_parser = manifolds())]
    manifold: Option<Manifold>,

    #[command(flatten)]
    switches: Switches,

    /// et-kf: project where the defect ||Q'Q - I|| exceeds this [default: 0.15]
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    epsilon: Option<f64>,

    /// ortho, et-kf: project to the nearest in this metric; information: P^-1 of Q [default: frobenius]
    #[arg(long, value_name = "METRIC", value_parser = metrics())]
    metric: Option<Metric>,
}

/// Choices of yes and no; the second is needed where the scenario says yes.
#[derive(Args)]
struct Switches {
    /// ortho, et-kf: go on from the projected Q, not only report it [default: false]
    #[arg(long, value_name = "BOOL", hide_possible_values = true)]
    #[arg(num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    feedback: Option<bool>,

    /// et-kf: epsilon counts in units of the claimed error of Q, so that it keeps acting [default: false]
    #[arg(long, value_name = "BOOL", hide_possible_values = true)]
    #[arg(num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    relative: Option<bool>,

    /// uc-kf: solve for Q and then for t, not for both at once [default: false]
    #[arg(long, value_name = "BOOL", hide_possible_values = true)]
    #[arg(num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    decoupled: Option<bool>,
}

impl Choices {
    /// Puts what was given into the settings.
    pub fn apply(&self, settings: &mut EstimatorSettings) {
        replace(&mut settings.enabled, self.estimators.clone());
        replace(&mut settings.manifold, self.manifold);
        replace(&mut settings.decoupled, self.switches.decoupled);
        replace(&mut settings.threshold.epsilon, self.epsilon);
        replace(&mut settings.threshold.kind, self.switches.relative.map(threshold_kind));
        replace(&mut settings.metric, self.metric);
        replace(&mut settings.feedback, self.switches.feedback);
    }
}

fn replace<T>(choice: &mut T, given: Option<T>) {
    if let Some(given) = given {
        *choice = given;
    }
}

fn threshold_kind(relative: bool) -> ThresholdKind {
    if relative { ThresholdKind::Relative } else { ThresholdKind::Absolute }
}

fn estimator_names() -> impl TypedValueParser<Value = EstimatorName> {
    let names = PossibleValuesParser::new(EstimatorName::ALL.map(EstimatorName::name));
    names.try_map(|name| name.parse::<EstimatorName>())
}

fn manifolds() -> impl TypedValueParser<Value = Manifold> {
    PossibleValuesParser::new(["so", "o"]).map(|name| if name == "o" { Manifold::O } else { Manifold::So })
}

fn metrics() -> impl TypedValueParser<Value = Metric> {
    let names = PossibleValuesParser::new(["frobenius", "information"]);
    names.map(|name| if name == "information" { Metric::Information } else { Metric::Frobenius })
}
