//! The nearest orthogonal matrix, and the nearest rotation: no other one is nearer.

use nalgebra::{SMatrix, SVector};
use rangelab::math::rotation::{Manifold, Rotation, defect, determinant, rotation_angles};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};

crate::in_plane_and_space!(
    no_random_rotation_is_nearer,
    no_step_along_the_manifold_is_nearer,
    singular_and_mirrored_input_still_gives_the_nearest,
    rotations_stay_where_they_are,
    scale_of_the_input_does_not_matter,
    the_group_commutes_with_projection,
);

/// Random matrices of both determinants, graded, of rank 1 and 0, almost rotations, almost reflections.
fn inputs<const D: usize>() -> Vec<SMatrix<f64, D, D>> {
    let mut sampler = Sampler::new(20);
    let mut inputs = vec![SMatrix::zeros(), SMatrix::identity(), -SMatrix::<f64, D, D>::identity()];
    for _ in 0..60 {
        let a = sampler.matrix::<D>(1.0);
        let grades = SVector::<f64, D>::from_fn(|i, _| if i == 0 { 1e-8 } else { 1.0 });
        let r = *sampler.rotation::<D>().matrix();
        inputs.extend([
            a,
            a * 1e6,
            a * 1e-6,
            a * SMatrix::from_diagonal(&grades),
            sampler.vector::<D>(1.0) * sampler.vector::<D>(1.0).transpose(),
            r + sampler.matrix::<D>(1e-3),
            -r + sampler.matrix::<D>(1e-3),
        ]);
    }
    inputs
}

fn closest<const D: usize>(a: &SMatrix<f64, D, D>, manifold: Manifold) -> (SMatrix<f64, D, D>, f64) {
    let q = *Rotation::project(a, manifold).matrix();
    (q, (a - q).norm())
}

fn no_random_rotation_is_nearer<const D: usize>() {
    let mut sampler = Sampler::new(21);
    for a in inputs::<D>() {
        let (_, on_so) = closest(&a, Manifold::So);
        let (_, on_o) = closest(&a, Manifold::O);
        at_most("O(D) has more choice than SO(D)", on_o, on_so * (1.0 + 1e-14));
        for _ in 0..100 {
            let r = *sampler.rotation::<D>().matrix();
            let mut mirrored = r;
            mirrored.column_mut(0).neg_mut();
            at_most("a rotation is nearer", on_so, (a - r).norm() * (1.0 + 1e-14));
            at_most("a reflection is nearer", on_o, (a - mirrored).norm() * (1.0 + 1e-14));
        }
    }
}

fn no_step_along_the_manifold_is_nearer<const D: usize>() {
    for a in inputs::<D>() {
        for manifold in [Manifold::So, Manifold::O] {
            let (q, _) = closest(&a, manifold);
            // Stationary: Q^T A is symmetric.
            let skew = q.transpose() * a - a.transpose() * q;
            at_most("gradient along the manifold", skew.norm(), 1e-14 * a.norm());
            for i in 0..rotation_angles(D) {
                for angle in [1e-3, 0.1, 1.0, 3.0, -1e-3, -0.1, -1.0, -3.0] {
                    let mut phi = [0.0; 3];
                    phi[i] = angle;
                    let moved = q * Rotation::<D>::exp(&phi).matrix();
                    // tr(A^T Q) decides: the norms of A and Q are the same for both.
                    at_most("a step is nearer", a.dot(&moved) - a.dot(&q), 1e-14 * a.norm());
                }
            }
        }
    }
    let mut sampler = Sampler::new(22);
    let a = sampler.rotation::<D>().matrix() + sampler.matrix::<D>(0.1);
    let (q, _) = closest(&a, Manifold::So);
    let spoiled = q * Rotation::<D>::exp(&[1e-8, 0.0, 0.0]).matrix();
    caught("a turn by 1e-8", (spoiled.transpose() * a - a.transpose() * spoiled).norm(), 1e-14 * a.norm());
}

fn singular_and_mirrored_input_still_gives_the_nearest<const D: usize>() {
    for a in inputs::<D>() {
        let (rotation, _) = closest(&a, Manifold::So);
        at_most("defect", defect(&rotation), 3e-15);
        at_most("determinant on SO(D)", (determinant(&rotation) - 1.0).abs(), 3e-15);
        let (orthogonal, _) = closest(&a, Manifold::O);
        at_most("defect", defect(&orthogonal), 3e-15);
        let sign = determinant(&a);
        if sign.abs() > 1e-12 * rangelab::math::float::pow(a.norm(), D as f64) {
            assert!(determinant(&orthogonal) * sign > 0.0, "O(D) keeps the component of {a}");
            assert_eq!(determinant(Rotation::project(&a, Manifold::O).matrix()) < 0.0, sign < 0.0);
        }
    }
}

fn rotations_stay_where_they_are<const D: usize>() {
    for a in inputs::<D>() {
        for manifold in [Manifold::So, Manifold::O] {
            let (once, _) = closest(&a, manifold);
            let (twice, _) = closest(&once, manifold);
            at_most("projected twice", (twice - once).norm(), 2e-15);
        }
    }
}

fn scale_of_the_input_does_not_matter<const D: usize>() {
    let mut sampler = Sampler::new(23);
    for _ in 0..50 {
        let a = sampler.matrix::<D>(1.0);
        let (plain, _) = closest(&a, Manifold::So);
        for scale in [1e-300, 1e-170, 1e-20, 1e20, 1e170, 1e300] {
            let (scaled, _) = closest(&(a * scale), Manifold::So);
            at_most("scaled", (scaled - plain).norm(), 1e-11);
        }
    }
}

fn the_group_commutes_with_projection<const D: usize>() {
    let mut sampler = Sampler::new(24);
    for _ in 0..100 {
        let r = sampler.rotation::<D>();
        let a = sampler.rotation::<D>().matrix() + sampler.matrix::<D>(0.1);
        let (left, _) = closest(&(r.matrix() * a), Manifold::So);
        let (right, _) = closest(&(a * r.matrix()), Manifold::So);
        let (plain, _) = closest(&a, Manifold::So);
        at_most("turned from the left", (left - r.matrix() * plain).norm(), 1e-14);
        at_most("turned from the right", (right - plain * r.matrix()).norm(), 1e-14);
    }
}
