//! What is drawn as a field, over which plane.

use serde::{Deserialize, Serialize};

use super::document::check::{Check, Limit};
use super::placement_settings::Target;
use super::ranging::RangeForm;

/// A bound over a plane: what it says of a body that stands at each point of it, or of one more anchor there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct FieldSettings {
    /// Where the body, or one more anchor, is put.
    pub plane: FieldPlane,
    /// Which of the two.
    pub subject: Subject,
    /// What is bounded, where the body is put at each point. For one more anchor that is the target of the placement.
    pub quantity: Quantity,
    /// Which ranges the bound is of.
    pub form: RangeForm,
    /// 1 for the attitude that the body has; more: averaged (root mean square) over so many headings, evenly about the
    /// vertical.
    pub headings: usize,
    /// Positions worse than this, m, are marked; null marks none.
    pub position_limit: Option<f64>,
    /// Orientations worse than this, rad, are marked; null marks none.
    pub angle_limit: Option<f64>,
}

/// A plane of the world. In two dimensions there is one, and it is [`FieldPlane::Level`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum FieldPlane {
    /// Horizontal, through the body's position.
    #[default]
    Level,
    /// Horizontal at a height.
    Horizontal {
        /// m.
        height: f64,
    },
    /// Upright, along `(cos heading, sin heading, 0)`.
    Vertical {
        /// rad, from the x axis.
        heading: f64,
        /// Distance from the origin along `(-sin heading, cos heading, 0)`, m.
        offset: f64,
    },
    /// Through the body's position along its own x and y axes.
    Body,
}

/// What is put at each point of a field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "snake_case")]
pub enum Subject {
    /// The body: how well it is found there.
    #[default]
    Body,
    /// One more anchor: what the placement adviser counts with it there.
    NextAnchor,
}

/// What a bound is about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Root of the trace of the bound on the position, m.
    #[default]
    Position,
    /// Root of the trace of the bound on the rotation angles, rad.
    Orientation,
}

/// Most headings that are averaged over.
pub const MAX_HEADINGS: usize = 72;

impl Default for FieldSettings {
    fn default() -> Self {
        Self {
            plane: FieldPlane::default(),
            subject: Subject::default(),
            quantity: Quantity::default(),
            form: RangeForm::Raw,
            headings: 1,
            position_limit: None,
            angle_limit: None,
        }
    }
}

impl FieldSettings {
    /// Whether the field is one of angles, rad; else it is one of lengths, m. `target` is that of the placement.
    pub fn in_angles(&self, target: Target) -> bool {
        match self.subject {
            Subject::Body => self.quantity == Quantity::Orientation,
            Subject::NextAnchor => target == Target::Orientation,
        }
    }

    /// The limit of what is shown: m or rad.
    pub fn limit(&self, target: Target) -> Option<f64> {
        if self.in_angles(target) { self.angle_limit } else { self.position_limit }
    }

    pub(super) fn check(&self, check: &mut Check, dimension: Option<usize>) {
        match self.plane {
            FieldPlane::Level => {}
            _ if dimension == Some(2) => {
                check.problem("field.plane", "tilted or raised", "level in two dimensions");
            }
            FieldPlane::Body => {}
            FieldPlane::Horizontal { height } => {
                check.number("field.plane.height", height, Limit::COORDINATE);
            }
            FieldPlane::Vertical { heading, offset } => {
                check.number("field.plane.heading", heading, Limit::ANGLE);
                check.number("field.plane.offset", offset, Limit::COORDINATE);
            }
        }
        if !(1..=MAX_HEADINGS).contains(&self.headings) {
            check.problem("field.headings", self.headings, format_args!("1 to {MAX_HEADINGS}"));
        }
        if let Some(limit) = self.position_limit {
            check.number("field.position_limit", limit, Limit::LENGTH);
        }
        if let Some(limit) = self.angle_limit {
            check.number("field.angle_limit", limit, Limit::ANGLE_LIMIT);
        }
    }
}
