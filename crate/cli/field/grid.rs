//! A field with all that table and picture say of it.

use rangelab::bounds::field::{FieldLayout, NONE, field_of, layout_of};
use rangelab::math::float::degrees;
use rangelab::model::field_settings::{FieldPlane, Quantity};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::with_dimension;

use crate::cli::picture::scale::short;

pub struct Grid {
    pub scenario: Scenario,
    pub layout: FieldLayout,
    /// Row by row, m or degrees; `None` where no bound exists.
    pub values: Vec<Option<f64>>,
    /// Larger values are marked; in the unit of the values.
    pub limit: Option<f64>,
}

impl Grid {
    pub fn new(scenario: Scenario, resolution: usize) -> rangelab::Result<Self> {
        let (layout, values) = with_dimension!(scenario.dimension, D => {
            let layout = layout_of::<D>(&scenario, resolution)?;
            rangelab::Result::Ok((layout, field_of::<D>(&scenario)?.rows(&layout, 0, layout.height)))
        })?;
        let quantity = scenario.field.quantity;
        let values = values.iter().map(|value| (*value < NONE).then(|| shown(quantity, *value))).collect();
        let limit = scenario.field.limit().map(|limit| shown(quantity, limit));
        Ok(Self { scenario, layout, values, limit })
    }

    pub fn unit(&self) -> &'static str {
        match self.scenario.field.quantity {
            Quantity::Position => "m",
            Quantity::Orientation => "deg",
        }
    }

    pub fn quantity(&self) -> &'static str {
        match self.scenario.field.quantity {
            Quantity::Position => "position",
            Quantity::Orientation => "orientation",
        }
    }

    /// Where the body starts, m.
    pub fn body(&self) -> [f64; 3] {
        lifted(&self.scenario.start.position)
    }

    /// What is shown, of what.
    pub fn title(&self) -> String {
        let name = &self.scenario.name;
        let of = if name.is_empty() { String::new() } else { format!(": {name}") };
        format!("Bound (UC-CRB) on the {}, {}{of}", self.quantity(), self.unit())
    }

    /// Over which plane, of which ranges and headings.
    pub fn subtitle(&self) -> String {
        let field = &self.scenario.field;
        let plane = match field.plane {
            FieldPlane::Level if self.scenario.dimension == 2 => "in the plane".to_owned(),
            FieldPlane::Level => format!("level through the body, z = {} m", self.layout.corner[2]),
            FieldPlane::Horizontal { height } => format!("horizontal, z = {height} m"),
            FieldPlane::Vertical { heading, offset } => {
                format!("vertical, heading {} deg, offset {offset} m", short(degrees(heading)))
            }
            FieldPlane::Body => "along the body's x and y axes".to_owned(),
        };
        let form = match field.form {
            RangeForm::Raw => "raw ranges",
            RangeForm::Projected => "projected ranges",
        };
        let heading = match field.headings {
            1 => "the body's attitude".to_owned(),
            headings => format!("root mean square of {headings} headings"),
        };
        format!("{plane}; {form}; {heading}")
    }
}

/// Metres stay, radians become degrees.
fn shown(quantity: Quantity, value: f64) -> f64 {
    match quantity {
        Quantity::Position => value,
        Quantity::Orientation => degrees(value),
    }
}

/// A point of the plane or of space; the third coordinate of the plane is 0.
pub fn lifted(point: &[f64]) -> [f64; 3] {
    core::array::from_fn(|i| point.get(i).copied().unwrap_or(0.0))
}
