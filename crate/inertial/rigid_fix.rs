//! All three transmitters at once, on the manifold of triangles congruent to the one on the body.
//!
//! A congruent triangle is a pose of the body, so the manifold is walked on as R^3 x SO(3): the isosceles triangle of the
//! paper's reference is one case, any other triangle the same.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use super::trilateration::line_of_sight;
use crate::error::{Error, Result};
use crate::math::cholesky::Cholesky;
use crate::math::float::sqrt;
use crate::math::rotation::{Manifold, Rotation, hat};
use crate::model::indoor::TRANSMITTERS;
use crate::model::indoor::epoch::BeaconRanges;

const MAX_ITERATIONS: usize = 50;
/// A step shorter than this is the last (m, and rad times the size of the triangle).
const LAST: f64 = 1e-11;

/// The corners of the triangle congruent to `transmitters` that fits the ranges best, by Gauss-Newton with damping from the
/// triangle that fits `corners`, the positions found one by one (Kabsch).
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
    // Levenberg's damping, relative to the diagonal.
    let mut damping = 0.0;
    let mut length = f64::INFINITY;
    for _ in 0..MAX_ITERATIONS {
        let mut damped = best.normal;
        for i in 0..6 {
            damped[(i, i)] *= 1.0 + damping;
        }
        let factor = Cholesky::new(&damped).map_err(|_| unseen(ranges))?;
        let step = factor.solve(&best.gradient);
        length = sqrt(step.norm_squared());
        let moved = best.pose.moved(&step);
        if length <= LAST {
            return Ok(transmitters.map(|c| moved.act(&c)));
        }
        let candidate = problem.evaluate(moved)?;
        if candidate.cost <= best.cost {
            (best, damping) = (candidate, if damping > 1e-6 { 0.1 * damping } else { 0.0 });
        } else if length < 1e-9 {
            return Ok(transmitters.map(|c| best.pose.act(&c)));
        } else {
            damping = if damping > 0.0 { 10.0 * damping } else { 1e-3 };
        }
    }
    Err(Error::NoConvergence { what: "the fit of the triangle", iterations: MAX_ITERATIONS, last_step: length })
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
    let mean = |points: &[Vector3<f64>; TRANSMITTERS]| points.iter().sum::<Vector3<f64>>() / TRANSMITTERS as f64;
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

struct Evaluation {
    pose: Placement,
    cost: f64,
    normal: SMatrix<f64, 6, 6>,
    gradient: SVector<f64, 6>,
}

impl Problem<'_> {
    fn evaluate(&self, pose: Placement) -> Result<Evaluation> {
        let (mut cost, mut normal, mut gradient) = (0.0, SMatrix::zeros(), SVector::zeros());
        for (i, c) in self.transmitters.iter().enumerate() {
            let position = pose.act(c);
            let by_turning = (pose.rotation.matrix() * hat::<3>(&(*c).into())).transpose();
            for (beacon, ranges) in self.beacons.iter().zip(self.ranges) {
                let Some(range) = ranges[i] else { continue };
                let (distance, direction) = line_of_sight(beacon, &position)?;
                let turned = by_turning * direction;
                let row = SVector::<f64, 6>::from_fn(|k, _| if k < 3 { -turned[k] } else { direction[k - 3] });
                cost += (range - distance) * (range - distance);
                gradient += row * (range - distance);
                crate::math::linalg::add_outer(&mut normal, 1.0, &row, &row);
            }
        }
        Ok(Evaluation { pose, cost, normal, gradient })
    }
}
