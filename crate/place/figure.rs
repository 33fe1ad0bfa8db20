//! One number of a bound, and how it changes with the information.

use core::ops::Range;

use crate::math::float::{pow, sqrt};
use crate::math::linalg::spd_inverse;
use crate::math::rotation::rotation_angles;
use crate::math::singular::singular;
use crate::math::tangent::{MAX_TANGENT, TangentMatrix, TangentTransform, tangent_dimension};
use crate::model::placement_settings::{Criterion, Target};

/// The number that a placement makes small: a criterion of the block `P` of the bound that belongs to the target.
///
/// `P` is the bound on the position (m^2), on the rotation angles (rad^2), or on both with angles times the size of the
/// body (m^2 at the sensors).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// A: `sqrt(tr P)`, D: `det(P)^(1/(2k))` for the `k` rows of `P`, E: `sqrt(lambda_max(P))`.
    pub criterion: Criterion,
    /// Which block of the bound.
    pub target: Target,
    /// Root mean square distance of the sensors from the origin of the body frame, m.
    pub body_size: f64,
}

/// How sharp a maximum is: the largest of several numbers itself, which has kinks, or a smooth mean of high order
/// `2^doublings` that lies near it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharpness {
    /// The maximum.
    Exact,
    /// The mean of order `2^doublings`.
    Smooth {
        /// 1 to 8; what lies beyond counts as the nearer of them, as higher powers leave the range of doubles.
        doublings: u32,
    },
}

impl Sharpness {
    /// The doublings of the mean, and its order.
    pub(super) fn order(self) -> Option<(u32, f64)> {
        match self {
            Self::Exact => None,
            Self::Smooth { doublings } => {
                let doublings = doublings.clamp(1, 8);
                Some((doublings, f64::from(1_u32 << doublings)))
            }
        }
    }
}

impl Figure {
    /// The unit of the number.
    pub fn unit(&self) -> &'static str {
        if self.target == Target::Orientation { "rad" } else { "m" }
    }

    /// The number of a covariance of the tangent coordinates, m or rad; infinite where D finds the block singular.
    pub fn value<const D: usize>(&self, covariance: &TangentMatrix<D>) -> f64 {
        let (p, block) = (self.scaled(covariance), self.block::<D>());
        match self.criterion {
            Criterion::A => sqrt(p.trace()),
            Criterion::D => geometric_mean(&p, &block).0,
            Criterion::E => root_of_largest(&p).0,
        }
    }

    /// The number `f` and `df/dJ`, `J` the information whose inverse `C` is the covariance: with `E = df/dP`, placed where
    /// `P` lies in `C`, `df/dJ = -C E C`. Coordinates that `D` does not use are zero.
    pub fn differentiate<const D: usize>(
        &self,
        covariance: &TangentMatrix<D>,
        sharpness: Sharpness,
    ) -> (f64, TangentTransform) {
        let (p, block, scale) = (self.scaled(covariance), self.block::<D>(), |i| self.scale::<D>(i));
        let (value, slope) = match (self.criterion, sharpness.order()) {
            (Criterion::A, _) => root_of_trace(&p, &block),
            (Criterion::D, _) => geometric_mean(&p, &block),
            (Criterion::E, None) => root_of_largest(&p),
            (Criterion::E, Some((doublings, order))) => root_of_norm(&p, doublings, order),
        };
        let placed = TangentTransform::from_fn(|i, j| slope[(i, j)] * scale(i) * scale(j));
        let c = TangentTransform::from_fn(|i, j| {
            let inside = i < tangent_dimension(D) && j < tangent_dimension(D);
            if inside { covariance.entry(i, j) } else { 0.0 }
        });
        (value, -(c * placed * c))
    }

    /// The block `P`, zero beside it.
    fn scaled<const D: usize>(&self, covariance: &TangentMatrix<D>) -> TangentTransform {
        let (block, scale) = (self.block::<D>(), |i| self.scale::<D>(i));
        let used = |i: usize, j: usize| block.contains(&i) && block.contains(&j);
        TangentTransform::from_fn(
            |i, j| {
                if used(i, j) { covariance.entry(i, j) * scale(i) * scale(j) } else { 0.0 }
            },
        )
    }

    fn block<const D: usize>(&self) -> Range<usize> {
        match self.target {
            Target::Position => rotation_angles(D)..tangent_dimension(D),
            Target::Orientation => 0..rotation_angles(D),
            Target::Pose => 0..tangent_dimension(D),
        }
    }

    fn scale<const D: usize>(&self, i: usize) -> f64 {
        if self.target == Target::Pose && i < rotation_angles(D) { self.body_size } else { 1.0 }
    }
}

/// `sqrt(tr P)` and its slope `I/(2 f)`.
fn root_of_trace(p: &TangentTransform, block: &Range<usize>) -> (f64, TangentTransform) {
    let value = sqrt(p.trace());
    let diagonal = |i, j| if i == j && block.contains(&i) { 0.5 / value } else { 0.0 };
    (value, TangentTransform::from_fn(diagonal))
}

/// `det(P)^(1/(2k))` and its slope `f P^-1/(2k)`; infinite where `P` is singular within double precision, since then a
/// variance is known to no digit.
fn geometric_mean(p: &TangentTransform, block: &Range<usize>) -> (f64, TangentTransform) {
    let outside = |i, j| if i == j && !block.contains(&i) { 1.0 } else { 0.0 };
    let padded = p + TangentTransform::from_fn(outside);
    let Ok(inverse) = spd_inverse(&padded) else { return (f64::INFINITY, TangentTransform::zeros()) };
    let order = 0.5 / block.len() as f64;
    let value = pivots(&padded).iter().map(|&pivot| pow(pivot, order)).product();
    let slope = |i, j| {
        let inside = block.contains(&i) && block.contains(&j);
        if inside { order * value * inverse[(i, j)] } else { 0.0 }
    };
    (value, TangentTransform::from_fn(slope))
}

/// The pivots of elimination, whose product is the determinant.
fn pivots(matrix: &TangentTransform) -> [f64; MAX_TANGENT] {
    let mut a = *matrix;
    for k in 0..MAX_TANGENT {
        for i in k + 1..MAX_TANGENT {
            let factor = a[(i, k)] / a[(k, k)];
            for j in k..MAX_TANGENT {
                a[(i, j)] -= factor * a[(k, j)];
            }
        }
    }
    core::array::from_fn(|k| a[(k, k)])
}

/// `sqrt(lambda_max(P))` and its slope `v v^T/(2 f)`; where eigenvalues meet, that of one of them.
fn root_of_largest(p: &TangentTransform) -> (f64, TangentTransform) {
    let s = singular(p);
    let value = sqrt(s.values[0]);
    let v = s.right.column(0);
    (value, v * v.transpose() * (0.5 / value))
}

/// `tr(P^q)^(1/(2q))`, `q = 2^doublings` the order, and its slope `f P^(q-1)/(2 tr P^q)`; powers are of `X = P/tr P`.
fn root_of_norm(p: &TangentTransform, doublings: u32, order: f64) -> (f64, TangentTransform) {
    let trace = p.trace();
    let x = p / trace;
    // X^(q-1) = X X^2 X^4 ... X^(q/2)
    let (mut power, mut product) = (x, x);
    for _ in 1..doublings {
        power *= power;
        product *= power;
    }
    let norm = (product * x).trace();
    let value = sqrt(trace) * pow(norm, 0.5 / order);
    (value, product * (0.5 * value / (norm * trace)))
}
