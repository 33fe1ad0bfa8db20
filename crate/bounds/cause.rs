//! Why a bound does not exist, in a sentence that a student understands.

use alloc::format;
use alloc::string::String;

use nalgebra::SVector;

use super::fisher::FisherInformation;
use super::observability::weakest_motion;
use crate::error::Error;
use crate::math::float::sqrt;
use crate::math::rotation::Angles;
use crate::model::ranging::RangeForm;
use crate::model::spread::Spread;

/// What the ranges are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Parameters {
    /// All entries of `[Q | t]`.
    Unconstrained,
    /// Position and rotation of a rigid body.
    Pose,
}

/// An extent below this part of the largest one is invisible within double precision, since information squares it.
const FLAT: f64 = 1e-6;

/// The typed error for a singular information matrix.
pub(super) fn unobservable<const D: usize>(
    what: &'static str,
    information: &FisherInformation<D>,
    parameters: Parameters,
) -> Error {
    Error::Unobservable { what, ranges: information.ranges, reason: reason(information, parameters) }
}

/// The first cause that applies: sensors, anchors, missing ranges, or else the motion that is not seen.
pub(super) fn reason<const D: usize>(information: &FisherInformation<D>, parameters: Parameters) -> String {
    let model = information.model;
    let (anchors, sensors) = (model.anchors().positions(), model.topology().sensors());
    let missing = anchors.len() * sensors.len() - information.ranges;
    let sensor_directions = if parameters == Parameters::Pose { D - 1 } else { D };
    let anchor_directions = if information.form == RangeForm::Projected { D } else { D - 1 };
    if missing == anchors.len() * sensors.len() {
        "No range was measured.".into()
    } else if let Some(lack) = lack("sensor", sensors, sensor_directions) {
        let unseen = match parameters {
            Parameters::Pose => "a turn about what they share moves none of them",
            Parameters::Unconstrained => "not every entry of Q moves one of them",
        };
        format!("{lack}: {unseen}.")
    } else if let Some(lack) = lack("anchor", anchors, anchor_directions) {
        let unseen = match information.form {
            RangeForm::Projected => {
                "with the unknown ||s||^2 projected out, motion across what they share is not seen"
            }
            RangeForm::Raw => "a turn of the world about what they share changes no range",
        };
        format!("{lack}: {unseen}.")
    } else if missing > 0 {
        format!("{missing} of {} ranges are missing.", anchors.len() * sensors.len())
    } else {
        unseen_motion(information)
    }
}

/// What a cloud of points lacks of extending in so many directions.
fn lack<const D: usize>(what: &str, points: &[SVector<f64, D>], directions: usize) -> Option<String> {
    let spread = Spread::of(points);
    let extends = |k: usize| spread.singular_values[k] > FLAT * spread.singular_values[0];
    let rank = (0..D).take_while(|&k| extends(k)).count();
    if rank >= directions {
        return None;
    }
    let (count, needed) = (points.len(), directions + 1);
    if count < needed {
        let plural = if count == 1 { "" } else { "s" };
        return Some(format!("{count} {what}{plural} where at least {needed} are needed"));
    }
    let flat = ["point", "line", "plane"][rank];
    let distance = points.iter().map(|p| distance_from_flat(p, &spread, rank)).fold(0.0, f64::max);
    Some(format!("The {count} {what}s lie within {} of one {flat}", metres(distance)))
}

/// Distance of a point from the flat of so many dimensions that fits its cloud best, m.
fn distance_from_flat<const D: usize>(point: &SVector<f64, D>, spread: &Spread<D>, dimensions: usize) -> f64 {
    let lever = point - spread.centroid;
    sqrt((dimensions..D).map(|k| lever.dot(&spread.directions.column(k))).map(|x| x * x).sum())
}

fn unseen_motion<const D: usize>(information: &FisherInformation<D>) -> String {
    let motion = weakest_motion(information, false);
    format!(
        "At this pose the ranges do not change while the body makes {} together with a shift along {}: \
         another place or one more anchor off the others would show it.",
        describe_turn::<D>(&motion.rotation),
        describe_vector(motion.shift.as_slice())
    )
}

/// "a turn about the body axis [..]"; in the plane there is only one turn.
pub(super) fn describe_turn<const D: usize>(rotation: &Angles) -> String {
    if D == 2 { "a turn".into() } else { format!("a turn about the body axis {}", describe_vector(rotation)) }
}

/// A direction to two decimals.
pub(super) fn describe_vector(vector: &[f64]) -> String {
    let length = sqrt(vector.iter().map(|x| x * x).sum());
    let scale = if length > 0.0 { 1.0 / length } else { 1.0 };
    // What would be shown as -0.00 is 0.
    let shown = |x: f64| if (scale * x).abs() < 0.005 { 0.0 } else { scale * x };
    match vector {
        [x, y] => format!("[{:.2}, {:.2}]", shown(*x), shown(*y)),
        [x, y, z] => format!("[{:.2}, {:.2}, {:.2}]", shown(*x), shown(*y), shown(*z)),
        _ => format!("{vector:?}"),
    }
}

/// A length in a unit that shows its digits.
pub(super) fn metres(length: f64) -> String {
    if length >= 1.0 {
        format!("{length:.1} m")
    } else if length >= 1e-2 {
        format!("{length:.3} m")
    } else if length >= 1e-6 {
        format!("{:.3} mm", 1e3 * length)
    } else {
        format!("{length:.0e} m")
    }
}
