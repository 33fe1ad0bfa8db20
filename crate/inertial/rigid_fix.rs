//! All three transmitters at once, on the manifold of triangles congruent to the one on the body.
//!
//! A congruent triangle is a pose of the body, so the manifold is walked on as R^3 x SO(3): the isosceles triangle of the
//! paper's reference is one case, any other triangle the same.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use super::trilateration::{LAST, ROUNDING, line_of_sight};
use crate::error::{Error, Result};
use crate::math::cholesky::Cholesky;
use crate::math::float::sqrt;
use crate::math::linalg::add_outer;
use crate::math::rotation::{Manifold, Rotation, hat};
use crate::model::indoor::TRANSMITTERS;
use crate::model::indoor::epoch::BeaconRanges;

const MAX_ITERATIONS: usize = 100;
/// Damping below this is as good as none.
const LEAST_DAMPING: f64 = 1e-6;

/// The corners of the triangle congruent to `transmitters` that fits the ranges best, from the triangle that fits
/// `corners`, the positions found one by one (Kabsch).
///
/// Steps are Newton's where the second derivative is positive definite, else Gauss and Newton's, both damped where the sum
/// of squares would rise: the body is small beside the errors of its corners, so its residuals bend.
///
/// # Errors
/// [`Error::Number`] where a corner comes onto a beacon, [`Error::Unobservable`], [`Error::NoConvergence`].
pub fn rigid_fix(
    beacons: &[Vector3<f64>],
    ranges: &[BeaconRanges],
    transmitters: &[Vector3<f64>; TRANSMITTERS],
    corners: &[Vector3<f64>; TRANSMITTERS],
) -> Result<[Vector3<f64>; TRANSMITTERS]> {
    let problem = Problem { beacons, ranges, transmitters };
    let mut best = problem.evaluate(fit(transmitters, corners))?;
    let (mut damping, mut length) = (0.0, f64::INFINITY);
    for _ in 0..MAX_ITERATIONS {
        let step = best.step(damping).ok_or_else(|| unseen(ranges))?;
        length = sqrt(step.norm_squared());
        let moved = best.pose.moved(&step);
        if length <= LAST {
            return Ok(transmitters.map(|c| moved.act(&c)));
        }
        let candidate = problem.evaluate(moved)?;
        if candidate.cost <= best.cost || length <= ROUNDING {
            (best, damping) = (candidate, if damping > LEAST_DAMPING { 0.1 * damping } else { 0.0 });
        } else {
            damping = if damping > 0.0 { 10.0 * damping } else { 1e-3 };
        }
    }
    Err(Error::NoConvergence {
        what: "the fit of the triangle",
        iterations: MAX_ITERATIONS,
        last_step: length,
    })
}

fn unseen(ranges: &[BeaconRanges]) -> Error {
    let count = ranges.iter().flatten().flatten().count();
    let reason = "Beacons and transmitters lie so that some motion of the triangle changes no range.".into();
    Error::Unobservable { what: "the fit of the triangle", ranges: count, reason }
}

#[derive(Clone, Copy)]
struct Placement {
    rotation: Rotation<3>,
    position: Vector3<f64>,
}

impl Placement {
    fn act(&self, c: &Vector3<f64>) -> Vector3<f64> {
        self.position + self.rotation.matrix() * c
    }

    fn moved(&self, step: &SVector<f64, 6>) -> Self {
        let turn = Rotation::exp(&[step[0], step[1], step[2]]);
        Self {
            rotation: self.rotation.compose(&turn).renormalized(),
            position: self.position + Vector3::new(step[3], step[4], step[5]),
        }
    }
}

/// The pose whose triangle is nearest to the corners.
fn fit(transmitters: &[Vector3<f64>; TRANSMITTERS], corners: &[Vector3<f64>; TRANSMITTERS]) -> Placement {
    let mean =
        |points: &[Vector3<f64>; TRANSMITTERS]| points.iter().sum::<Vector3<f64>>() / TRANSMITTERS as f64;
    let (body, world) = (mean(transmitters), mean(corners));
    let mut overlap = Matrix3::zeros();
    for (c, y) in transmitters.iter().zip(corners) {
        overlap += (y - world) * (c - body).transpose();
    }
    let rotation = Rotation::project(&overlap, Manifold::So);
    Placement { rotation, position: world - rotation.matrix() * body }
}

struct Problem<'a> {
    beacons: &'a [Vector3<f64>],
    ranges: &'a [BeaconRanges],
    transmitters: &'a [Vector3<f64>; TRANSMITTERS],
}

/// The sum of squares at a pose, with its models.
struct Evaluation {
    pose: Placement,
    cost: f64,
    normal: SMatrix<f64, 6, 6>,
    /// What the second derivative has beside `normal`.
    bend: SMatrix<f64, 6, 6>,
    gradient: SVector<f64, 6>,
}

impl Evaluation {
    /// Levenberg's step, damped relative to the diagonal.
    fn step(&self, damping: f64) -> Option<SVector<f64, 6>> {
        let solve = |mut matrix: SMatrix<f64, 6, 6>| {
            for i in 0..6 {
                matrix[(i, i)] += damping * self.normal[(i, i)];
            }
            Cholesky::new(&matrix).ok().map(|factor| factor.solve(&self.gradient))
        };
        solve(self.normal + self.bend).or_else(|| solve(self.normal))
    }
}

impl Problem<'_> {
    fn evaluate(&self, pose: Placement) -> Result<Evaluation> {
        let (mut cost, mut gradient) = (0.0, SVector::zeros());
        let (mut normal, mut bend) = (SMatrix::zeros(), SMatrix::zeros());
        for (i, c) in self.transmitters.iter().enumerate() {
            let position = pose.act(c);
            let by_turning = pose.rotation.matrix() * hat::<3>(&(*c).into()) * -1.0;
            for (beacon, ranges) in self.beacons.iter().zip(self.ranges) {
                let Some(range) = ranges[i] else { continue };
                let (distance, direction) = line_of_sight(beacon, &position)?;
                let residual = range - distance;
                let turned = by_turning.transpose() * direction;
                let row = SVector::<f64, 6>::from_fn(|k, _| if k < 3 { turned[k] } else { direction[k - 3] });
                cost += residual * residual;
                gradient += row * residual;
                add_outer(&mut normal, 1.0, &row, &row);
                let in_body = pose.rotation.matrix().transpose() * direction;
                bend -= second_derivative(&by_turning, &direction, distance, &in_body, c) * residual;
            }
        }
        Ok(Evaluation { pose, cost, normal, bend, gradient })
    }
}

/// That of a distance by `(phi, p)`: of its length across the line of sight, and of the turning point along it,
/// `w . (phi (phi . c) - c |phi|^2)/2` with `w` the direction in the body frame.
fn second_derivative(
    by_turning: &Matrix3<f64>,
    direction: &Vector3<f64>,
    distance: f64,
    in_body: &Vector3<f64>,
    c: &Vector3<f64>,
) -> SMatrix<f64, 6, 6> {
    let across = (Matrix3::identity() - direction * direction.transpose()) / distance;
    let mut y = SMatrix::<f64, 3, 6>::zeros();
    y.fixed_view_mut::<3, 3>(0, 0).copy_from(by_turning);
    y.fixed_view_mut::<3, 3>(0, 3).copy_from(&Matrix3::identity());
    let mut second = y.transpose() * across * y;
    let mut turning = second.fixed_view_mut::<3, 3>(0, 0);
    turning += (in_body * c.transpose() + c * in_body.transpose()) * 0.5;
    turning -= Matrix3::identity() * in_body.dot(c);
    second
}
