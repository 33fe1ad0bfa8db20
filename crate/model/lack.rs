//! What a cloud of sensors or anchors lacks, in words that a student understands.

use alloc::format;
use alloc::string::String;

use nalgebra::SVector;

use super::ranging::{RangeForm, RangeModel};
use super::spread::Spread;

/// An extent below this part of the largest one is invisible within double precision, since information squares it.
pub(crate) const FLAT: f64 = 1e-6;

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

/// What the ranges are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parameters {
    /// All entries of `[Q | t]`.
    Unconstrained,
    /// Position and rotation of a rigid body.
    Pose,
    /// The position of each sensor by itself.
    Sensors,
}

/// A cause and its sentence.
pub(crate) struct Reason {
    pub(crate) cause: Cause,
    pub(crate) sentence: String,
}

/// The first cause that geometry or the number of ranges gives: sensors, anchors, missing ranges.
pub(crate) fn shortfall<const D: usize>(
    model: &RangeModel<D>,
    ranges: usize,
    form: RangeForm,
    parameters: Parameters,
) -> Option<Reason> {
    let (anchors, sensors) = (model.anchors().positions(), model.topology().sensors());
    let pairs = anchors.len() * sensors.len();
    let missing = pairs - ranges;
    if missing == pairs {
        return Some(Reason { cause: Cause::NoRanges, sentence: "No range was measured.".into() });
    }
    let geometry = match parameters {
        Parameters::Pose => {
            lack(SENSOR, sensors, D - 1).map(|lack| lack.explain("a turn about", "moves no sensor"))
        }
        Parameters::Unconstrained => {
            lack(SENSOR, sensors, D).map(|lack| lack.explain("what Q does off", "moves no sensor"))
        }
        Parameters::Sensors => None,
    };
    let geometry = geometry.or_else(|| match form {
        RangeForm::Projected => lack(ANCHOR, anchors, D)
            .map(|lack| lack.explain("with the unknown ||s||^2 projected out, motion off", "is not seen")),
        RangeForm::Raw => lack(ANCHOR, anchors, D - 1)
            .map(|lack| lack.explain("turning the body about", "changes no range")),
    });
    geometry.or_else(|| {
        let sentence = format!("{missing} of {pairs} ranges are missing.");
        (missing > 0).then_some(Reason { cause: Cause::MissingRanges, sentence })
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
pub(crate) fn describe_flat<const D: usize>(
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

/// A length in a unit that shows its digits.
pub(crate) fn metres(length: f64) -> String {
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
