//! A field with all that table and picture say of it.

use rangelab::bounds::field::{FieldLayout, NONE, layout_of};
use rangelab::math::float::degrees;
use rangelab::model::field_settings::{FieldPlane, Quantity, Subject};
use rangelab::model::placement_settings::{Criterion, Over, Target};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::place::{NextPlace, best_next, field_rows};
use rangelab::with_dimension;

use crate::cli::picture::scale::short;

pub struct Grid {
    pub scenario: Scenario,
    pub layout: FieldLayout,
    /// Row by row, m or degrees; `None` where no bound exists.
    pub values: Vec<Option<f64>>,
    /// Larger values are marked; in the unit of the values.
    pub limit: Option<f64>,
    /// The best place of one more anchor, where the field shows that.
    pub best: Option<NextPlace>,
}

impl Grid {
    pub fn new(scenario: Scenario, resolution: usize) -> rangelab::Result<Self> {
        let layout = with_dimension!(scenario.dimension, D => layout_of::<D>(&scenario, resolution))?;
        let values = field_rows(&scenario, &layout, 0, layout.height)?;
        let target = scenario.placement.target;
        let shown = |value: f64| if scenario.field.in_angles(target) { degrees(value) } else { value };
        let values = values.iter().map(|value| (*value < NONE).then(|| shown(*value))).collect();
        let limit = scenario.field.limit(target).map(shown);
        let best = match scenario.field.subject {
            Subject::Body => None,
            Subject::NextAnchor => best_next(&scenario)?,
        };
        Ok(Self { scenario, layout, values, limit, best })
    }

    pub fn unit(&self) -> &'static str {
        if self.scenario.field.in_angles(self.scenario.placement.target) { "deg" } else { "m" }
    }

    /// What is bounded.
    pub fn quantity(&self) -> &'static str {
        match (self.scenario.field.subject, self.scenario.field.quantity, self.scenario.placement.target) {
            (Subject::Body, Quantity::Position, _) | (Subject::NextAnchor, _, Target::Position) => "position",
            (Subject::Body, Quantity::Orientation, _) | (Subject::NextAnchor, _, Target::Orientation) => {
                "orientation"
            }
            (Subject::NextAnchor, _, Target::Pose) => "pose",
        }
    }

    /// Whether the field is that of one more anchor.
    pub fn of_next_anchor(&self) -> bool {
        self.scenario.field.subject == Subject::NextAnchor
    }

    /// The heading of the values in a table.
    pub fn column(&self) -> String {
        let subject = if self.of_next_anchor() { "_with_one_more_anchor" } else { "" };
        format!("{}_bound{subject}_{}", self.quantity(), self.unit())
    }

    /// Where the body starts, m.
    pub fn body(&self) -> [f64; 3] {
        lifted(&self.scenario.start.position)
    }

    /// What is shown, of what.
    pub fn title(&self) -> String {
        let name = &self.scenario.name;
        let of = if name.is_empty() { String::new() } else { format!(": {name}") };
        let subject = if self.of_next_anchor() { " with one more anchor here" } else { "" };
        format!("Bound (UC-CRB) on the {}{subject}, {}{of}", self.quantity(), self.unit())
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
        let goal = if self.of_next_anchor() { format!("; {}", self.goal()) } else { String::new() };
        format!("{plane}; {form}; {heading}{goal}")
    }

    /// What the adviser makes small.
    fn goal(&self) -> String {
        let placement = &self.scenario.placement;
        let criterion = match placement.criterion {
            Criterion::A => "A-optimal",
            Criterion::D => "D-optimal",
            Criterion::E => "E-optimal",
        };
        match (&placement.region, placement.over) {
            (None, _) => criterion.to_owned(),
            (Some(_), Over::Mean) => format!("{criterion}, mean of the region"),
            (Some(_), Over::Worst) => format!("{criterion}, worst of the region"),
        }
    }
}

/// A point of the plane or of space; the third coordinate of the plane is 0.
pub fn lifted(point: &[f64]) -> [f64; 3] {
    core::array::from_fn(|i| point.get(i).copied().unwrap_or(0.0))
}
