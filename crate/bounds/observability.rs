//! What the geometry lets the ranges see, for people: facts, the weakest motion, and one sentence.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector, Vector4};

use super::cause::{describe_turn, describe_vector, reason};
use super::constrained::unitary_crb;
use super::fisher::FisherInformation;
use crate::math::float::{degrees, sqrt};
use crate::math::rotation::{Angles, rotation_angles};
use crate::math::singular::singular;
use crate::math::tangent::{MAX_TANGENT, TangentVector, split, tangent_dimension};
use crate::model::lack::{Cause, Parameters, Reason, describe_flat, metres};
use crate::model::spread::{Spread, singular_values};
use crate::model::topology::Topology;

/// Facts about what can be seen from one epoch.
#[derive(Clone, Debug, PartialEq)]
pub struct Observability<const D: usize> {
    /// Number of directions in which the anchors extend.
    pub anchor_rank: usize,
    /// Largest over least extent of the anchors; infinite where the rank is deficient.
    pub anchor_condition: f64,
    /// Largest distance of an anchor from the plane (D = 2: line) that fits them best, m.
    pub anchor_thickness: f64,
    /// Rank of `[C; 1^T]`.
    pub sensor_rank: usize,
    /// Largest over least extent of the sensors about their centroid; infinite where the rank is deficient.
    pub sensor_condition: f64,
    /// Singular values of the centred anchors, decreasing, m.
    pub anchor_singular_values: [f64; D],
    /// Singular values of `[C; 1^T]`, decreasing, one more than dimensions: the entries of `Q` and `t` are seen through
    /// them. The ones have no unit, so the numbers depend on the metre.
    pub sensor_singular_values: Vec<f64>,
    /// The independent motions of the body, the one that the ranges see least first.
    pub motions: Vec<Motion<D>>,
    /// Why the pose is not seen; `None` where it is.
    pub cause: Option<Cause>,
    /// What is not seen and why; or, where all is seen, what is seen least.
    pub sentence: String,
}

/// A motion of the body, scaled so that the sensors move by about 1 m: an eigenvector of the pose information with
/// angles counted as metres at the sensors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// Rotation coordinates in the body frame, rad.
    pub rotation: Angles,
    /// Shift in the world frame, m.
    pub shift: SVector<f64, D>,
    /// Standard deviation of an estimate along it, m at the sensors; `None` where it is not seen.
    pub standard_deviation: Option<f64>,
    /// Part of the motion of the sensors that comes from the turn, 0 to 1.
    pub turning: f64,
}

/// Gathers the facts at a pose, for a body that is rigid (`Q` a rotation).
pub fn observability<const D: usize>(information: &FisherInformation<D>) -> Observability<D> {
    let (anchors, topology) = (information.model.anchors(), information.model.topology());
    let (spread, sensors) = (anchors.spread(), topology.spread());
    let seen = unitary_crb(information).is_ok();
    let motions = motions(information, seen);
    let (cause, sentence) = if seen {
        (None, describe_weakest(information, &motions[0]))
    } else {
        let Reason { cause, sentence } = reason(information, Parameters::Pose);
        (Some(cause), sentence)
    };
    Observability {
        anchor_rank: spread.rank(),
        anchor_condition: condition(&spread),
        anchor_thickness: spread.thickness(anchors.positions(), D - 1),
        sensor_rank: sensors.rank() + 1,
        sensor_condition: condition(&sensors),
        anchor_singular_values: spread.singular_values,
        sensor_singular_values: extended_singular_values(topology),
        motions,
        cause,
        sentence,
    }
}

/// Singular values of `[C; 1^T]`.
fn extended_singular_values<const D: usize>(topology: &Topology<D>) -> Vec<f64> {
    // In the plane one more coordinate is zero, and so is the value that is left out.
    let lift =
        |c: &SVector<f64, D>| Vector4::from_fn(|i, _| if i < D { c[i] } else { f64::from(u8::from(i == D)) });
    let extended: Vec<_> = topology.sensors().iter().map(lift).collect();
    singular_values(&extended, &Vector4::zeros())[..=D].to_vec()
}

fn condition<const D: usize>(spread: &Spread<D>) -> f64 {
    if spread.rank() < D { f64::INFINITY } else { spread.condition() }
}

/// The motion that the ranges see least.
pub(super) fn weakest_motion<const D: usize>(information: &FisherInformation<D>, seen: bool) -> Motion<D> {
    motions(information, seen)[0]
}

/// Eigenvectors of the pose information, with angles counted as metres at the sensors, least eigenvalue first. Where the
/// pose is not `seen`, those whose information is rounding beside the largest have no standard deviation.
fn motions<const D: usize>(information: &FisherInformation<D>, seen: bool) -> Vec<Motion<D>> {
    let size = information.model.topology().size();
    let j = information.on_tangent_space();
    let used = tangent_dimension(D);
    let scale = |i: usize| if i < rotation_angles(D) { 1.0 / size } else { 1.0 };
    let scaled = |i: usize, k: usize| j.entry(i, k) * scale(i) * scale(k);
    // Unused coordinates (D = 2) get the trace, so that they come first and are left out.
    let unused = (0..used).map(|i| scaled(i, i)).sum::<f64>();
    let matrix =
        SMatrix::<f64, MAX_TANGENT, MAX_TANGENT>::from_fn(|i, k| match (i < used && k < used, i == k) {
            (true, _) => scaled(i, k),
            (false, true) => unused,
            (false, false) => 0.0,
        });
    let s = singular(&matrix);
    let largest = s.values[MAX_TANGENT - used];
    let motion = |k: usize| {
        let direction: TangentVector = s.right.column(k).into_owned();
        let (turn, shift) = split::<D>(&direction);
        let seen = seen || s.values[k] > ROUNDING * largest;
        Motion {
            rotation: turn.map(|x| x / size),
            shift,
            standard_deviation: seen.then(|| 1.0 / sqrt(s.values[k])),
            turning: turn.iter().map(|x| x * x).sum(),
        }
    };
    (MAX_TANGENT - used..MAX_TANGENT).rev().map(motion).collect()
}

/// Information below this part of the largest is rounding.
const ROUNDING: f64 = 1e-12;

/// Anchors whose extents differ by more than this factor are called thin.
const THIN: f64 = 10.0;

fn describe_weakest<const D: usize>(information: &FisherInformation<D>, weakest: &Motion<D>) -> String {
    let anchors = information.model.anchors();
    let spread = anchors.spread();
    let opening = if condition(&spread) > THIN {
        let place = describe_flat(anchors.positions(), &spread, D - 1);
        format!("The {} anchors lie {place}", anchors.len())
    } else {
        "All motions are seen".into()
    };
    let deviation = weakest.standard_deviation.unwrap_or(f64::INFINITY);
    let (motion, size) = if weakest.turning > 0.5 {
        let angle = degrees(deviation / information.model.topology().size());
        (describe_turn::<D>(&weakest.rotation), format!("{angle:.3} deg"))
    } else {
        (format!("a shift along {}", describe_vector(weakest.shift.as_slice())), metres(deviation))
    };
    format!("{opening}; the least well seen motion is {motion}, to about {size}.")
}
