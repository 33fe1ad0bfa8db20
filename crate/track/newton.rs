//! Newton's method on SO(D) for the projection in a metric, safeguarded and polished.

use nalgebra::{SMatrix, SVector};

use super::projection::{cost, difference};
use crate::error::{Error, Result};
use crate::math::block::BlockMatrix;
use crate::math::linalg::spd_inverse;
use crate::math::pose::Theta;
use crate::math::rotation::{MAX_ANGLES, Rotation};

const MAX_ITERATIONS: usize = 100;

/// Steps below this (rad) lie where the cost no longer tells better from worse in double precision.
const LOCAL_STEP: f64 = 1e-5;

type Angles3 = SVector<f64, MAX_ANGLES>;
type Hessian = SMatrix<f64, MAX_ANGLES, MAX_ANGLES>;

/// Minimizes `(q - q_hat)^T W (q - q_hat)` from `start`.
///
/// The paper stops when the gradient is 1e-6 of its terms, which leaves errors up to 2e-5 in `Q`; here full Newton steps
/// go on until they stop shrinking.
pub(super) fn newton<const D: usize>(
    start: Rotation<D>,
    q: &SMatrix<f64, D, D>,
    metric: &BlockMatrix<D>,
) -> Result<Rotation<D>> {
    let mut rotation = start;
    let mut last = f64::INFINITY;
    for _ in 0..MAX_ITERATIONS {
        let (step, damped) = newton_step(&rotation, q, metric);
        let size = step.norm();
        let local = size < LOCAL_STEP && !damped;
        if size <= f64::EPSILON || (local && size >= 0.5 * last) {
            return Ok(Rotation::project(rotation.matrix(), crate::math::rotation::Manifold::So));
        }
        rotation = if local { moved(&rotation, &step) } else { descend(&rotation, &step, q, metric) };
        last = size;
    }
    Err(Error::NoConvergence {
        what: "Newton's method on SO(3)",
        iterations: MAX_ITERATIONS,
        last_step: last,
    })
}

/// The Newton step at `rotation`, and whether the Hessian had to be made positive definite for it.
fn newton_step<const D: usize>(
    rotation: &Rotation<D>,
    q: &SMatrix<f64, D, D>,
    metric: &BlockMatrix<D>,
) -> (Angles3, bool) {
    let residual = metric.times(&difference(rotation, q));
    let tangents: [Theta<D>; MAX_ANGLES] =
        core::array::from_fn(|i| Theta { orientation: rotation.tangent(i), position: SVector::zeros() });
    let gradient = Angles3::from_fn(|i, _| tangents[i].orientation.dot(&residual.orientation));
    let mut hessian = Hessian::zeros();
    for i in 0..MAX_ANGLES {
        let image = metric.times(&tangents[i]);
        for j in 0..MAX_ANGLES {
            hessian[(j, i)] = tangents[j].orientation.dot(&image.orientation);
        }
    }
    // <R (E_i E_j + E_j E_i)/2, W (R - Q_hat)>: with E_i = hat(e_i), E_i E_j = e_j e_i^T - delta_ij I.
    let curvature = rotation.matrix().transpose() * residual.orientation;
    let trace = curvature.trace();
    for i in 0..MAX_ANGLES {
        for j in 0..MAX_ANGLES {
            hessian[(i, j)] += 0.5 * (curvature[(i, j)] + curvature[(j, i)]);
        }
        hessian[(i, i)] -= trace;
    }
    damped_solve(&hessian, &gradient)
}

/// `-(H + shift)^-1 g` with the least shift tried that makes the matrix positive definite.
fn damped_solve(hessian: &Hessian, gradient: &Angles3) -> (Angles3, bool) {
    let scale = hessian.norm();
    let mut shift = 0.0;
    loop {
        if let Ok(inverse) = spd_inverse(&(hessian + Hessian::identity() * shift)) {
            return (-(inverse * gradient), shift > 0.0);
        }
        shift = if shift == 0.0 { 1e-3 * scale } else { 4.0 * shift };
        if !(shift < 1e6 * scale) {
            return (Angles3::zeros(), true);
        }
    }
}

fn moved<const D: usize>(rotation: &Rotation<D>, step: &Angles3) -> Rotation<D> {
    rotation.compose(&Rotation::exp(&[step[0], step[1], step[2]]))
}

/// Halves the step until the cost falls; where it never does, stays.
fn descend<const D: usize>(
    rotation: &Rotation<D>,
    step: &Angles3,
    q: &SMatrix<f64, D, D>,
    metric: &BlockMatrix<D>,
) -> Rotation<D> {
    let before = cost(rotation, q, metric);
    let mut step = *step;
    for _ in 0..40 {
        let candidate = moved(rotation, &step);
        if cost(&candidate, q, metric) <= before {
            return candidate;
        }
        step *= 0.5;
    }
    *rotation
}
