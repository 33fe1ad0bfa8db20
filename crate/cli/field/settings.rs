//! Options that choose what a field shows.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use rangelab::math::float::radians;
use rangelab::model::field_settings::{Quantity, Subject};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;

#[derive(Args)]
#[command(next_help_heading = "Field (default: what the scenario says)")]
pub struct SettingsOptions {
    /// position of the body in m; its orientation in degrees; next-anchor: what the placement counts with one more anchor at
    /// each point
    #[arg(long, value_name = "QUANTITY", value_parser = quantities())]
    quantity: Option<Shown>,

    /// Which ranges: raw squares, or with the sensors' squared distance from the origin projected out
    #[arg(long, value_name = "FORM", value_parser = forms())]
    form: Option<RangeForm>,

    /// Average over so many headings, evenly about the vertical; 1: only the attitude that the body has
    #[arg(long, value_name = "COUNT")]
    headings: Option<usize>,

    /// Worse than this is hatched in the picture: m, or degrees for orientation
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    limit: Option<f64>,
}

impl SettingsOptions {
    /// Puts what was given into the scenario.
    pub fn apply(&self, scenario: &mut Scenario) {
        let (settings, target) = (&mut scenario.field, scenario.placement.target);
        match self.quantity {
            None => {}
            Some(Shown::Body(quantity)) => (settings.subject, settings.quantity) = (Subject::Body, quantity),
            Some(Shown::NextAnchor) => settings.subject = Subject::NextAnchor,
        }
        settings.form = self.form.unwrap_or(settings.form);
        settings.headings = self.headings.unwrap_or(settings.headings);
        if settings.in_angles(target) {
            settings.angle_limit = self.limit.map(radians).or(settings.angle_limit);
        } else {
            settings.position_limit = self.limit.or(settings.position_limit);
        }
    }

    /// Whether a bound of the body alone was asked for.
    pub fn is_of_body(&self) -> bool {
        matches!(self.quantity, Some(Shown::Body(_)))
    }
}

#[derive(Clone, Copy)]
enum Shown {
    Body(Quantity),
    NextAnchor,
}

fn quantities() -> impl TypedValueParser<Value = Shown> {
    let names = PossibleValuesParser::new(["position", "orientation", "next-anchor"]);
    names.map(|name| match name.as_str() {
        "position" => Shown::Body(Quantity::Position),
        "orientation" => Shown::Body(Quantity::Orientation),
        _ => Shown::NextAnchor,
    })
}

fn forms() -> impl TypedValueParser<Value = RangeForm> {
    let names = PossibleValuesParser::new(["raw", "projected"]);
    names.map(|name| if name == "raw" { RangeForm::Raw } else { RangeForm::Projected })
}
