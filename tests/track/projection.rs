//! Projection of `Q` in any metric: a stationary point, a minimum, and the lowest one wherever `Q` is near a rotation.

use nalgebra::{DMatrix, SMatrix, SVector};
use rangelab::math::block::BlockMatrix;
use rangelab::math::pose::Theta;
use rangelab::math::projection::project_in_metric;
use rangelab::math::rotation::{Manifold, Rotation, defect, determinant, rotation_angles};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense};

crate::in_plane_and_space!(
    the_gradient_vanishes_and_the_cost_rises,
    the_identity_metric_gives_the_polar_factor,
    no_start_finds_a_lower_cost,
    symmetric_inputs_do_not_stop_on_a_saddle,
    scale_of_the_metric_does_not_matter,
);

/// A random metric with a condition up to `10^(2 spread)`, the block of `t` and what moves it filled with other numbers.
pub fn metric<const D: usize>(sampler: &mut Sampler, spread: f64) -> BlockMatrix<D> {
    let size = D * (D + 1);
    let scales: Vec<f64> =
        (0..size).map(|_| rangelab::math::float::pow(10.0, sampler.uniform(-spread, spread))).collect();
    let root = DMatrix::from_fn(size, size + 3, |i, _| scales[i] * sampler.normal());
    dense::blocks(&(&root * root.transpose()))
}

fn difference<const D: usize>(r: &SMatrix<f64, D, D>, q: &SMatrix<f64, D, D>) -> Theta<D> {
    Theta { orientation: r - q, ..Theta::zeros() }
}

fn cost<const D: usize>(r: &SMatrix<f64, D, D>, q: &SMatrix<f64, D, D>, metric: &BlockMatrix<D>) -> f64 {
    let difference = difference(r, q);
    difference.dot(&metric.times(&difference))
}

/// Half the slope of the cost along each tangent, and what it is measured against: the terms that cancel in it.
fn gradient<const D: usize>(r: &Rotation<D>, q: &SMatrix<f64, D, D>, metric: &BlockMatrix<D>) -> (f64, f64) {
    let residual = metric.times(&difference(r.matrix(), q)).orientation;
    let slopes = (0..rotation_angles(D)).map(|i| r.tangent(i).dot(&residual));
    (slopes.map(f64::abs).fold(0.0, f64::max), dense::matrix(metric).norm() * (r.matrix() - q).norm())
}

fn the_gradient_vanishes_and_the_cost_rises<const D: usize>() {
    let mut sampler = Sampler::new(300);
    for index in 0..400_usize {
        let w = metric::<D>(&mut sampler, [0.0, 1.0, 2.0, 3.0][index % 4]);
        let q = sampler.rotation::<D>().matrix() + sampler.matrix::<D>([1e-9, 0.01, 0.1, 1.0][index / 100]);
        for manifold in [Manifold::So, Manifold::O] {
            let r = project_in_metric(&q, &w, manifold).unwrap();
            at_most("defect", defect(r.matrix()), 3e-15);
            if manifold == Manifold::So {
                at_most("determinant", (determinant(r.matrix()) - 1.0).abs(), 3e-15);
            }
            let (slope, scale) = gradient(&r, &q, &w);
            at_most("gradient", slope, 1e-12 * scale + 1e-14 * dense::matrix(&w).norm());
            let lowest = cost(r.matrix(), &q, &w);
            for _ in 0..10 {
                let phi = sampler.axis::<D>().map(|x| 1e-3 * x);
                let moved = r.compose(&Rotation::exp(&phi));
                at_most("the cost nearby", lowest, cost(moved.matrix(), &q, &w) * (1.0 + 1e-13));
            }
            let spoiled = r.compose(&Rotation::exp(&[1e-4, 0.0, 0.0]));
            let (slope, scale) = gradient(&spoiled, &q, &w);
            caught("a turn by 1e-4", slope, 1e-12 * scale);
        }
    }
}

fn the_identity_metric_gives_the_polar_factor<const D: usize>() {
    let mut sampler = Sampler::new(301);
    for _ in 0..300 {
        let q = sampler.matrix::<D>(1.0);
        for manifold in [Manifold::So, Manifold::O] {
            let found = project_in_metric(&q, &BlockMatrix::isotropic(2.0, 0.0), manifold).unwrap();
            let polar = Rotation::project(&q, manifold);
            let identity = BlockMatrix::isotropic(1.0, 0.0);
            let excess = cost(found.matrix(), &q, &identity) - cost(polar.matrix(), &q, &identity);
            at_most("cost above the polar factor's", excess.abs(), 1e-13);
        }
    }
}

/// Levenberg's descent with Gauss-Newton steps from `start`: slow, plain, and it cannot rise.
fn descend<const D: usize>(
    start: Rotation<D>,
    q: &SMatrix<f64, D, D>,
    metric: &BlockMatrix<D>,
) -> Rotation<D> {
    let angles = rotation_angles(D);
    let (mut r, mut damping) = (start, 1e-3);
    for _ in 0..200 {
        let residual = metric.times(&difference(r.matrix(), q)).orientation;
        let images: Vec<_> = (0..angles)
            .map(|i| metric.times(&Theta { orientation: r.tangent(i), ..Theta::zeros() }).orientation)
            .collect();
        let hessian = DMatrix::from_fn(angles, angles, |i, j| r.tangent(i).dot(&images[j]));
        let slope = DMatrix::from_fn(angles, 1, |i, _| r.tangent(i).dot(&residual));
        let damped = &hessian + DMatrix::identity(angles, angles) * (damping * hessian.trace());
        let step = damped.cholesky().unwrap().solve(&slope);
        if step.norm() < 1e-11 {
            break;
        }
        let mut phi = [0.0; 3];
        for i in 0..angles {
            phi[i] = -step[i];
        }
        let candidate = r.compose(&Rotation::exp(&phi));
        if cost(candidate.matrix(), q, metric) < cost(r.matrix(), q, metric) {
            (r, damping) = (candidate, damping * 0.3);
        } else {
            damping = 1e-9_f64.max(damping * 5.0);
        }
    }
    r
}

/// The lowest cost over SO(D): a dense scan in the plane, many starts in space.
pub fn lowest_cost<const D: usize>(
    sampler: &mut Sampler,
    q: &SMatrix<f64, D, D>,
    metric: &BlockMatrix<D>,
) -> f64 {
    let starts: Vec<Rotation<D>> = if D == 2 {
        (0..64).map(|k| Rotation::exp(&[f64::from(k) * 0.1, 0.0, 0.0])).collect()
    } else {
        (0..40).map(|_| sampler.rotation()).collect()
    };
    starts
        .into_iter()
        .map(|start| cost(descend(start, q, metric).matrix(), q, metric))
        .fold(f64::INFINITY, f64::min)
}

fn no_start_finds_a_lower_cost<const D: usize>() {
    let mut sampler = Sampler::new(302);
    let mut missed = [0, 0];
    for index in 0..100 {
        let wild = index % 2;
        let w = metric::<D>(&mut sampler, [0.3, 1.0][wild]);
        let q = sampler.rotation::<D>().matrix() + sampler.matrix::<D>([0.1, 1.0][wild]);
        let found = cost(project_in_metric(&q, &w, Manifold::So).unwrap().matrix(), &q, &w);
        let lowest = lowest_cost(&mut sampler, &q, &w);
        missed[wild] += u32::from(found > lowest * (1.0 + 1e-9));
        // Over O(D) the other component is the same problem with the last axis of the body mirrored.
        let both = cost(project_in_metric(&q, &w, Manifold::O).unwrap().matrix(), &q, &w);
        at_most("O(D) has more choice", both, found * (1.0 + 1e-12));
    }
    println!("D = {D}: above the lowest cost {missed:?} of 50 near, 50 wild");
    assert_eq!(missed[0], 0, "near a rotation the projection is the global minimum");
    assert!(D == 3 || missed[1] == 0, "in the plane it always is");
}

/// Diagonal `Q` and metric: every diagonal of signs is stationary, whether minimum, saddle or maximum.
fn symmetric_inputs_do_not_stop_on_a_saddle<const D: usize>() {
    let mut sampler = Sampler::new(303);
    for index in 0..60 {
        let scale = [1.0, 0.1, 0.01][index % 3];
        let q = SMatrix::<f64, D, D>::from_fn(|i, j| if i == j { scale * sampler.normal() } else { 0.0 });
        let diagonal: Vec<f64> = (0..D * D)
            .map(|k| {
                let on_diagonal = k % (D + 1) == 0;
                sampler.uniform(0.5, 1.0) * if on_diagonal { 1.0 } else { 0.01 }
            })
            .collect();
        let mut w = BlockMatrix::<D>::zeros();
        for j in 0..D {
            w.set_block(
                j,
                j,
                &SMatrix::from_diagonal(&SVector::from_column_slice(&diagonal[j * D..(j + 1) * D])),
            );
        }
        let r = project_in_metric(&q, &w, Manifold::So).unwrap();
        let found = cost(r.matrix(), &q, &w);
        for _ in 0..20 {
            let moved = r.compose(&Rotation::exp(&sampler.axis::<D>().map(|x| 1e-2 * x)));
            at_most("a saddle", found, cost(moved.matrix(), &q, &w) * (1.0 + 1e-13));
        }
    }
}

fn scale_of_the_metric_does_not_matter<const D: usize>() {
    let mut sampler = Sampler::new(304);
    for _ in 0..50 {
        let w = metric::<D>(&mut sampler, 0.5);
        let q = sampler.rotation::<D>().matrix() + sampler.matrix::<D>(0.1);
        let plain = project_in_metric(&q, &w, Manifold::So).unwrap();
        for scale in [1e-30, 1e-12, 1e12, 1e30] {
            let scaled = dense::blocks(&(dense::matrix(&w) * scale));
            let found = project_in_metric(&q, &scaled, Manifold::So).unwrap();
            at_most("scaled", (found.matrix() - plain.matrix()).norm(), 1e-12);
        }
    }
}
