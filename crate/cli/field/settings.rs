//! Options that choose what a field shows.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use rangelab::math::float::radians;
use rangelab::model::field_settings::{FieldSettings, Quantity};
use rangelab::model::ranging::RangeForm;

#[derive(Args)]
#[command(next_help_heading = "Field (default: what the scenario says)")]
pub struct SettingsOptions {
    /// What is bounded: position in m or orientation in degrees
    #[arg(long, value_name = "QUANTITY", value_parser = quantities())]
    quantity: Option<Quantity>,

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
    /// Puts what was given into the settings.
    pub fn apply(&self, settings: &mut FieldSettings) {
        settings.quantity = self.quantity.unwrap_or(settings.quantity);
        settings.form = self.form.unwrap_or(settings.form);
        settings.headings = self.headings.unwrap_or(settings.headings);
        match settings.quantity {
            Quantity::Position => settings.position_limit = self.limit.or(settings.position_limit),
            Quantity::Orientation => settings.angle_limit = self.limit.map(radians).or(settings.angle_limit),
        }
    }
}

fn quantities() -> impl TypedValueParser<Value = Quantity> {
    let names = PossibleValuesParser::new(["position", "orientation"]);
    names.map(|name| if name == "position" { Quantity::Position } else { Quantity::Orientation })
}

fn forms() -> impl TypedValueParser<Value = RangeForm> {
    let names = PossibleValuesParser::new(["raw", "projected"]);
    names.map(|name| if name == "raw" { RangeForm::Raw } else { RangeForm::Projected })
}
