//! Why a bound does not exist, in a sentence that a student understands.

use alloc::format;
use alloc::string::String;

use super::fisher::FisherInformation;
use super::observability::weakest_motion;
use crate::error::Error;
use crate::math::float::sqrt;
use crate::math::rotation::Angles;
use crate::model::lack::{Cause, Parameters, Reason, shortfall};

/// The typed error for a singular information matrix.
pub(super) fn unobservable<const D: usize>(
    what: &'static str,
    information: &FisherInformation<D>,
    parameters: Parameters,
) -> Error {
    Error::Unobservable { what, ranges: information.ranges, reason: reason(information, parameters).sentence }
}

/// The first cause that applies: sensors, anchors, missing ranges, or else the motion that is not seen.
pub(super) fn reason<const D: usize>(information: &FisherInformation<D>, parameters: Parameters) -> Reason {
    shortfall(information.model, information.ranges, information.form, parameters)
        .unwrap_or_else(|| Reason { cause: Cause::ThisPose, sentence: unseen_motion(information) })
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
