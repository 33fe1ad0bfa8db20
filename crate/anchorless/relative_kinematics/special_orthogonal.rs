//! The second stage as least squares over O(D): `min ||Y_1p + Omega Y_0 - H (W_p + Omega_2 Yh_2)||_F`.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::SecondStage;
use super::lifted::{self, Stage, least_squares, not_seen, stacked};
use super::lyapunov::{Sides, skew, skew_entries};
use crate::error::Result;
use crate::math::float::{cos, sin};
use crate::math::orthogonal::nearest_orthogonal;

/// Angles at which the cost is looked at in the plane; it has few valleys, so half a degree finds the deepest.
const ANGLES: usize = 720;
const MAX_ITERATIONS: usize = 50;
/// Step (rad) after which the rotation is settled.
const SETTLED: f64 = 1e-12;
/// Rank of the linear system of a step.
const RANK: f64 = 1e-12;

/// The best of all starts, each followed to its valley.
pub fn solve(sides: &Sides) -> Result<SecondStage> {
    let stage = Stage::new(sides);
    let starts = match (stage.dimension(), lifted::rotation(&stage)) {
        (2, _) => plane_starts(&stage),
        (_, Some(rotation)) => Vec::from([rotation]),
        _ => cube_starts(),
    };
    let mut best: Option<SecondStage> = None;
    for start in starts {
        let found = descend(&stage, start)?;
        if best.as_ref().is_none_or(|best| found.cost < best.cost) {
            best = Some(found);
        }
    }
    best.ok_or_else(not_seen)
}

/// Gauss-Newton on `(Omega, Omega_2, H exp(delta))`, the two linear unknowns solved for anew in each step.
fn descend(stage: &Stage, mut rotation: DMatrix<f64>) -> Result<SecondStage> {
    let mut best = stage.with_rotation(&rotation, 0)?;
    for iteration in 1..=MAX_ITERATIONS {
        let Some(delta) = step(stage, &rotation) else { break };
        let size = delta.amax();
        let mut share = 1.0;
        let next = loop {
            let tried = nearest_orthogonal(&(&rotation + &rotation * &delta * share))?;
            let found = stage.with_rotation(&tried, iteration)?;
            if found.cost < best.cost {
                break Some(found);
            }
            share *= 0.5;
            if share < 1e-3 || size < SETTLED {
                break None;
            }
        };
        let Some(next) = next else { break };
        best = next;
        rotation.clone_from(&best.rotation);
        if size < SETTLED {
            break;
        }
    }
    Ok(best)
}

/// The skew `delta` of one step; `None` where it is not determined.
fn step(stage: &Stage, rotation: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let entries = skew_entries(stage.dimension());
    let mut columns = stage.omega_columns();
    columns.extend(stage.second_columns(rotation));
    let linear = DMatrix::from_columns(&columns);
    let target = stacked(&(rotation * &stage.second - &stage.first));
    let solution = least_squares(&linear, &target, RANK)?;
    let omega_2 = stage.omega(&solution.as_slice()[entries..]);
    let inner = &stage.second + omega_2 * &stage.accelerations;
    columns.extend((0..entries).map(|index| stacked(&-(rotation * skew(stage.dimension(), index) * &inner))));
    let full = least_squares(&DMatrix::from_columns(&columns), &target, RANK)?;
    Some(stage.omega(&full.as_slice()[2 * entries..]))
}

/// The best angle of a rotation and that of a reflection.
fn plane_starts(stage: &Stage) -> Vec<DMatrix<f64>> {
    let mirror = DMatrix::from_row_slice(2, 2, &[-1.0, 0.0, 0.0, 1.0]);
    let [proper, mirrored] = [DMatrix::identity(2, 2), mirror].map(|turn| best_angle(stage, &turn));
    Vec::from([proper, mirrored])
}

/// The best `R turn`, R in SO(2), on the grid, with `omega` and `omega_2` eliminated: all that depends on the angle are
/// inner products that turn with it.
fn best_angle(stage: &Stage, turn: &DMatrix<f64>) -> DMatrix<f64> {
    let j = skew(2, 0);
    let (a, b) = (&stage.first, turn * &stage.second);
    let (c, d) = (&j * &stage.positions, &j * turn * &stage.accelerations);
    let (turned_b, turned_d) = (&j * &b, &j * &d);
    let (ac, bd, cc, dd) = (a.dot(&c), b.dot(&d), c.norm_squared(), d.norm_squared());
    let products = [(a, &b, &turned_b), (&c, &b, &turned_b), (a, &d, &turned_d), (&c, &d, &turned_d)]
        .map(|(left, right, turned)| (left.dot(right), left.dot(turned)));
    // The cost without what is the same at all angles.
    let cost = |cosine: f64, sine: f64| {
        let [ab, cb, ad, cd] = products.map(|(along, across)| cosine * along + sine * across);
        let (g, h) = (cb - ac, ad - bd);
        let gain = (dd * g * g + 2.0 * cd * g * h + cc * h * h) / (cc * dd - cd * cd);
        -2.0 * ab - gain
    };
    let mut best = (f64::INFINITY, [1.0, 0.0]);
    for index in 0..ANGLES {
        let angle = 2.0 * core::f64::consts::PI * index as f64 / ANGLES as f64;
        let (cosine, sine) = (cos(angle), sin(angle));
        let cost = cost(cosine, sine);
        if cost < best.0 {
            best = (cost, [cosine, sine]);
        }
    }
    let [cosine, sine] = best.1;
    DMatrix::from_row_slice(2, 2, &[cosine, -sine, sine, cosine]) * turn
}

/// The 48 symmetries of a cube: axes exchanged and turned about.
fn cube_starts() -> Vec<DMatrix<f64>> {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let symmetry = |order: [usize; 3], signs: usize| {
        DMatrix::from_fn(3, 3, |i, j| match (order[i] == j, signs >> i & 1) {
            (false, _) => 0.0,
            (true, 0) => 1.0,
            _ => -1.0,
        })
    };
    ORDERS.iter().flat_map(|&order| (0..8).map(move |signs| symmetry(order, signs))).collect()
}
