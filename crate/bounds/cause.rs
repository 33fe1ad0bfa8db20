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
pub(super) const FLAT: f64 = 1e-6;

/// The typed error for a singular information matrix.
pub(super) fn unobservable<const D: usize>(
    what: &'static str,
    information: &FisherInformation<D>,
    parameters: Parameters,
) -> Error {
    Error::Unobservable { what, ranges: information.ranges, reason: reason(information, parameters).sentence }
}

/// Why some motion of the body is not seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// There is no range at all.
    NoRanges,
    /// Fewer sensors than the question needs, however they lie.
    TooFewSensors,
    /// All sensors lie in one point.
    SensorsAtOnePoint,
    /// All sensors lie on one line.
    SensorsOnOneLine,
    /// All sensors lie in one plane.
    SensorsInOnePlane,
    /// Fewer anchors than the question needs, however they lie.
    TooFewAnchors,
    /// All anchors lie in one point.
    AnchorsAtOnePoint,
    /// All anchors lie on one line.
    AnchorsOnOneLine,
    /// All anchors lie in one plane.
    AnchorsInOnePlane,
    /// Too many ranges are missing.
    MissingRanges,
    /// Only this pose is not seen.
    ThisPose,
}

impl Cause {
    /// Its name in documents; it stays.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NoRanges => "no-ranges",
            Self::TooFewSensors => "too-few-sensors",
            Self::SensorsAtOnePoint => "sensors-at-one-point",
            Self::SensorsOnOneLine => "sensors-on-one-line",
            Self::SensorsInOnePlane => "sensors-in-one-plane",
            Self::TooFewAnchors => "too-few-anchors",
            Self::AnchorsAtOnePoint => "anchors-at-one-point",
            Self::AnchorsOnOneLine => "anchors-on-one-line",
            Self::AnchorsInOnePlane => "anchors-in-one-plane",
            Self::MissingRanges => "missing-ranges",
            Self::ThisPose => "this-pose",
        }
    }
}

/// A cause and its sentence.
pub(super) struct Reason {
    pub(super) cause: Cause,
    pub(super) sentence: String,
}

/// The first cause that applies: sensors, anchors, missing ranges, or else the motion that is not seen.
pub(super) fn reason<const D: usize>(information: &FisherInformation<D>, parameters: Parameters) -> Reason {
    let model = information.model;
    let (anchors, sensors) = (model.anchors().positions(), model.topology().sensors());
    let pairs = anchors.len() * sensors.len();
    let missing = pairs - information.ranges;
    if missing == pairs {
        return Reason { cause: Cause::NoRanges, sentence: "No range was measured.".into() };
    }
    let geometry = match parameters {
        Parameters::Pose => {
            lack(SENSOR, sensors, D - 1).map(|lack| lack.explain("a turn about", "moves no sensor"))
        }
        Parameters::Unconstrained => {
            lack(SENSOR, sensors, D).map(|lack| lack.explain("what Q does off", "moves no sensor"))
        }
    };
    let geometry = geometry.or_else(|| match information.form {
        RangeForm::Projected => lack(ANCHOR, anchors, D)
            .map(|lack| lack.explain("with the unknown ||s||^2 projected out, motion off", "is not seen")),
        RangeForm::Raw => lack(ANCHOR, anchors, D - 1)
            .map(|lack| lack.explain("turning the body about", "changes no range")),
    });
    geometry.unwrap_or_else(|| {
        if missing > 0 {
            let sentence = format!("{missing} of {pairs} ranges are missing.");
            Reason { cause: Cause::MissingRanges, sentence }
        } else {
            Reason { cause: Cause::ThisPose, sentence: unseen_motion(information) }
        }
    })
}

/// What points are called, the cause where they are too few, and that where they lie in a flat of 0, 1, 2 dimensions.
type Named = (&'static str, Cause, [Cause; 3]);
const SENSOR: Named = (
    "sensor",
    Cause::TooFewSensors,
    [Cause::SensorsAtOnePoint, Cause::SensorsOnOneLine, Cause::SensorsInOnePlane],
);
const ANCHOR: Named = (
    "anchor",
    Cause::TooFewAnchors,
    [Cause::AnchorsAtOnePoint, Cause::AnchorsOnOneLine, Cause::AnchorsInOnePlane],
);

/// What a cloud of points lacks of extending in enough directions.
struct Lack {
    cause: Cause,
    /// How many there are, or how they lie.
    finding: String,
    /// What they share.
    flat: &'static str,
}

impl Lack {
    fn explain(&self, motion: &str, effect: &str) -> Reason {
        let sentence = format!("{}: {motion} that {} {effect}.", self.finding, self.flat);
        Reason { cause: self.cause, sentence }
    }
}

fn lack<const D: usize>(
    (what, too_few, flat): Named,
    points: &[SVector<f64, D>],
    directions: usize,
) -> Option<Lack> {
    let spread = Spread::of(points);
    let extends = |k: usize| spread.singular_values[k] > FLAT * spread.singular_values[0];
    let rank = (0..D).take_while(|&k| extends(k)).count();
    if rank >= directions {
        return None;
    }
    let (count, needed) = (points.len(), directions + 1);
    let plural = if count == 1 { "" } else { "s" };
    let place = describe_flat(points, &spread, rank);
    let finding = if count < needed {
        let verb = if count == 1 { "lies" } else { "lie" };
        format!("{count} {what}{plural} where at least {needed} are needed {verb} {place}")
    } else {
        format!("The {count} {what}{plural} lie {place}")
    };
    let cause = if count < needed { too_few } else { flat[rank] };
    Some(Lack { cause, finding, flat: FLATS[rank].1 })
}

/// Flats by dimension: how one lies in it, and its name.
const FLATS: [(&str, &str); 3] = [("at one", "point"), ("on one", "line"), ("in one", "plane")];

/// "in one plane", or "within 0.3 m of one plane" where it is not just rounding.
pub(super) fn describe_flat<const D: usize>(
    points: &[SVector<f64, D>],
    spread: &Spread<D>,
    dimensions: usize,
) -> String {
    let distance = spread.thickness(points, dimensions);
    let size = points.iter().map(SVector::norm).fold(0.0, f64::max);
    let (preposition, flat) = FLATS[dimensions];
    if distance <= 1e-12 * size {
        format!("{preposition} {flat}")
    } else {
        format!("within {} of one {flat}", metres(distance))
    }
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
