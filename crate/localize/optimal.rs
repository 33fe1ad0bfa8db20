//! Optimal unitarily constrained (total) least squares: Newton's method on the Stiefel manifold (\[L\] Appendix B).

use nalgebra::SMatrix;

use super::certificate::certified;
use super::reduced::Reduced;
use super::snapshot::Snapshot;
use super::start::{cube_rotations, start};
use super::{Estimate, Optimum};
use crate::error::Result;
use crate::math::float::sqrt;
use crate::math::linalg::spd_inverse;
use crate::math::newton::{Expansion, Hessian, along_turn, newton};
use crate::math::quadratic::distance;
use crate::math::rotation::{MAX_ANGLES, Manifold, Rotation, determinant, rotation_angles};
use crate::model::lack::Parameters;
use crate::model::ranging::RangeForm;

/// The paper's stopping rule: the slope as a part of what it is made of (Algorithm 1).
const STOP: f64 = 1e-6;

/// A slope below this part of its terms is rounding; noise-free data reach it where the rule divides 0 by 0.
const ROUNDING: f64 = 1e-13;

const MAX_ITERATIONS: usize = 100;

/// No step turns farther than a quarter turn.
const QUARTER: f64 = core::f64::consts::FRAC_PI_2;

/// OUC-LS (`mounting_sigma` 0) and OUC-TLS: the orthogonal matrix of least cost of the linear model.
///
/// In space Algorithm 1 of \[L\] from its start (eq. 55-56), with its step length (eq. 66) and its stopping rule, whose
/// iterations are counted; then full Newton steps until they stop shrinking, for the rule leaves errors up to 2e-5 in `Q`. Like
/// the paper's it stays in the component of O(D) in which it starts. In the plane the cost along the one turn is a
/// trigonometric polynomial, whose least value is the global minimum, by a quartic and without iterations.
///
/// `multi_start` searches from 24 more starts (over O(D) from as many reflections) where the optimum cannot be certified.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause, [`crate::Error::NoConvergence`].
pub fn optimal<const D: usize>(
    snapshot: &Snapshot<D>,
    mounting_sigma: f64,
    manifold: Manifold,
    multi_start: bool,
) -> Result<Estimate<D>> {
    let what = if mounting_sigma > 0.0 { "OUC-TLS" } else { "OUC-LS" };
    let reduced = snapshot.reduced(what, mounting_sigma)?;
    let unseen = || snapshot.unobservable(what, RangeForm::Projected, Parameters::Pose);
    if snapshot.sensor_rank() + 1 < D {
        return Err(unseen());
    }
    let found = if D == 2 {
        in_the_plane(&reduced, manifold)
    } else {
        let first = start(snapshot, &reduced, manifold);
        in_space(&first, &reduced, manifold, multi_start)?
    };
    let expansion = Expansion::at(&found.rotation, &reduced.target, &reduced.metric);
    if spd_inverse(&used(&expansion.gauss, rotation_angles(D))).is_err() {
        return Err(unseen());
    }
    let orientation = *found.rotation.matrix();
    let theta = snapshot.in_body_frame(orientation, reduced.centroid(&orientation));
    Ok(Estimate::new(theta, found.iterations, found.optimum))
}

/// An optimum and how it was reached.
#[derive(Clone, Copy, Debug)]
pub struct Found<const D: usize> {
    /// The orthogonal matrix.
    pub rotation: Rotation<D>,
    /// Iterations until the stopping rule held.
    pub iterations: usize,
    /// What is known of it.
    pub optimum: Optimum,
}

/// The global minimum over SO(2), over O(2) the better of that and the one over the reflections.
fn in_the_plane<const D: usize>(reduced: &Reduced<D>, manifold: Manifold) -> Found<D> {
    let best = |from: Rotation<D>| {
        let cost = along_turn(&from, &[1.0, 0.0, 0.0], &reduced.target, &reduced.metric);
        let angle = cost.least();
        (cost.at(angle), from.compose(&Rotation::exp(&[angle, 0.0, 0.0])))
    };
    let (cost, mut rotation) = best(Rotation::identity());
    if manifold == Manifold::O {
        let (mirrored, reflection) = best(mirror());
        if mirrored < cost {
            rotation = reflection;
        }
    }
    Found { rotation: rotation.renormalized(), iterations: 0, optimum: Optimum::Formula }
}

/// The reflection of the body's last axis.
fn mirror<const D: usize>() -> Rotation<D> {
    let mut matrix = SMatrix::identity();
    matrix[(D - 1, D - 1)] = -1.0;
    Rotation::from_matrix_unchecked(matrix)
}

fn in_space<const D: usize>(
    first: &Rotation<D>,
    reduced: &Reduced<D>,
    manifold: Manifold,
    multi_start: bool,
) -> Result<Found<D>> {
    let (near, iterations) = algorithm_1(first, reduced);
    let rotation = newton(near, &reduced.target, &reduced.metric)?;
    if certified(&rotation, reduced) {
        return Ok(Found { rotation, iterations, optimum: Optimum::Certified });
    }
    if !multi_start {
        return Ok(Found { rotation, iterations, optimum: Optimum::Local });
    }
    let rotation = search(rotation, reduced, manifold);
    let optimum = if certified(&rotation, reduced) { Optimum::Certified } else { Optimum::Searched };
    Ok(Found { rotation, iterations, optimum })
}

/// The best optimum from many starts, the one at hand unless another is better beyond rounding.
fn search<const D: usize>(at_hand: Rotation<D>, reduced: &Reduced<D>, manifold: Manifold) -> Rotation<D> {
    let cost = |rotation: &Rotation<D>| distance(rotation, &reduced.target, &reduced.metric);
    let mut best = (cost(&at_hand), at_hand);
    let components = if manifold == Manifold::O { 2 } else { 1 };
    let proper = if determinant(at_hand.matrix()) < 0.0 { mirror() } else { Rotation::identity() };
    for component in 0..components {
        let into = if component == 0 { Rotation::identity() } else { mirror() };
        for turn in cube_rotations::<D>() {
            let from = at_hand.compose(&turn).compose(&proper).compose(&into);
            if let Ok(found) = newton(from, &reduced.target, &reduced.metric)
                && cost(&found) < best.0 - ROUNDING * (best.0 + reduced.residual)
            {
                best = (cost(&found), found);
            }
        }
    }
    best.1
}

/// Algorithm 1 of \[L\] from a start; the matrix where its rule stops, and how many iterations it took.
pub fn algorithm_1<const D: usize>(first: &Rotation<D>, reduced: &Reduced<D>) -> (Rotation<D>, usize) {
    let (q, metric) = (&reduced.target, &reduced.metric);
    let mut rotation = *first;
    let mut expansion = Expansion::at(&rotation, q, metric);
    for iteration in 1..=MAX_ITERATIONS {
        let step = descent(&expansion);
        let angle = sqrt(step.iter().map(|x| x * x).sum());
        if !(angle > 0.0) {
            return (rotation, iteration);
        }
        let axis = step.map(|x| x / angle);
        let turn = along_turn(&rotation, &axis, q, metric).least_up_to(angle.min(QUARTER));
        rotation = rotation.compose(&Rotation::exp(&axis.map(|x| turn * x))).renormalized();
        expansion = Expansion::at(&rotation, q, metric);
        if turn == 0.0 || settled(&rotation, &expansion, reduced) {
            return (rotation, iteration);
        }
    }
    (rotation, MAX_ITERATIONS)
}

/// Newton's step where the Hessian is positive definite, else Gauss and Newton's.
fn descent<const D: usize>(expansion: &Expansion<D>) -> [f64; MAX_ANGLES] {
    let inverse = spd_inverse(&expansion.hessian)
        .or_else(|_| spd_inverse(&used(&expansion.gauss, rotation_angles(D))))
        .unwrap_or_else(|_| SMatrix::zeros());
    (-(inverse * expansion.gradient)).into()
}

/// `||J^T w|| <= 1e-6 ||J||_F ||w||`, `w` the residual of all ranges; or what is left is rounding.
fn settled<const D: usize>(rotation: &Rotation<D>, expansion: &Expansion<D>, reduced: &Reduced<D>) -> bool {
    let slope = sqrt(expansion.gradient.norm_squared());
    let jacobian = sqrt(expansion.gauss.trace());
    let residual = sqrt(reduced.residual + distance(rotation, &reduced.target, &reduced.metric).max(0.0));
    slope <= STOP * jacobian * residual || slope <= ROUNDING * jacobian * jacobian
}

/// A matrix on angles with the identity on unused ones.
fn used(matrix: &Hessian, angles: usize) -> Hessian {
    let mut result = *matrix;
    for i in angles..MAX_ANGLES {
        result[(i, i)] = 1.0;
    }
    result
}
