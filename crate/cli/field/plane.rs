//! Options that choose the plane of a field.

use clap::{Args, ValueEnum};
use rangelab::math::float::radians;
use rangelab::model::field_settings::FieldPlane;

use crate::cli::failure::Failure;

#[derive(Args)]
#[command(next_help_heading = "Plane (default: what the scenario says)")]
pub struct PlaneOptions {
    /// level: horizontal through the body; horizontal; vertical; body: along its own x and y axes
    #[arg(long, value_enum, value_name = "PLANE")]
    plane: Option<PlaneName>,

    /// horizontal: its height, m [default: 0]
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    height: Option<f64>,

    /// vertical: its direction from the x axis, degrees [default: 0]
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    heading_deg: Option<f64>,

    /// vertical: how far it is to the left of the origin, m [default: 0]
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    offset: Option<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum PlaneName {
    Level,
    Horizontal,
    Vertical,
    Body,
}

/// Options that fit each other.
pub struct PlaneChoice<'a> {
    name: Option<PlaneName>,
    options: &'a PlaneOptions,
}

impl PlaneOptions {
    /// The plane that was asked for; a height asks for a horizontal one, a heading or an offset for an upright one.
    pub fn choice(&self) -> Result<PlaneChoice<'_>, Failure> {
        let upright = self.heading_deg.is_some() || self.offset.is_some();
        let numbers = match (self.height, upright) {
            (Some(_), true) => {
                let sentence =
                    "--height is of a horizontal plane, --heading-deg and --offset of a vertical one";
                return Err(Failure::Usage(sentence.to_owned()));
            }
            (Some(_), false) => Some((PlaneName::Horizontal, "--height", "horizontal")),
            (None, true) => Some((PlaneName::Vertical, "--heading-deg and --offset", "vertical")),
            (None, false) => None,
        };
        match (self.plane, numbers) {
            (Some(plane), Some((name, options, kind))) if plane != name => {
                Err(Failure::Usage(format!("{options}: only for --plane {kind}")))
            }
            (plane, numbers) => {
                Ok(PlaneChoice { name: plane.or(numbers.map(|(name, ..)| name)), options: self })
            }
        }
    }
}

impl PlaneChoice<'_> {
    /// Replaces the plane by what was given; what was not given of a plane of the same kind stays.
    pub fn apply(&self, plane: &mut FieldPlane) {
        let Some(name) = self.name else { return };
        let options = self.options;
        *plane = match (name, *plane) {
            (PlaneName::Level, _) => FieldPlane::Level,
            (PlaneName::Body, _) => FieldPlane::Body,
            (PlaneName::Horizontal, before) => {
                let before = if let FieldPlane::Horizontal { height } = before { height } else { 0.0 };
                FieldPlane::Horizontal { height: options.height.unwrap_or(before) }
            }
            (PlaneName::Vertical, before) => {
                let before = if let FieldPlane::Vertical { heading, offset } = before {
                    (heading, offset)
                } else {
                    (0.0, 0.0)
                };
                FieldPlane::Vertical {
                    heading: options.heading_deg.map_or(before.0, radians),
                    offset: options.offset.unwrap_or(before.1),
                }
            }
        };
    }
}
