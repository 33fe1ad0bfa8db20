//! The bounds from one epoch against the papers' stacked matrices, and against each other.

use nalgebra::{DMatrix, SMatrix};
use rangelab::bounds::constrained::image;
use rangelab::bounds::{Bound, crb, observability, unitary_crb};
use rangelab::math::rotation::{Manifold, Rotation};
use rangelab::model::ranging::{RangeForm, Weighting};

use crate::dense::{
    difference, extended, of_blocks, of_tangent, order, stacked, tangent_basis, whitened_anchors,
};
use crate::scenes::{Scene, random};

fn information_is_that_of_the_stacked_matrices<const D: usize>() {
    for trial in 0..100 {
        let common = random::<D>(trial, Weighting::Common);
        let ours = of_blocks(&common.information(RangeForm::Projected).matrix);
        let h = stacked(&common.model, &common.pose, |_| 0);
        assert!(difference(&ours, &(h.transpose() * &h)) < 1e-12, "trial {trial}: common weights");

        // [L] eq. 41 as it should read: F = (C_e C_e^T) (x) Abar^T Abar.
        let (c, a) = (extended(&common.model), whitened_anchors(&common.model, &common.pose, 0));
        let product = (&c * c.transpose()).kronecker(&(a.transpose() * &a));
        assert!(difference(&ours, &product) < 1e-12, "trial {trial}: Kronecker product");
        let printed = as_printed(&c, &a);
        assert!(difference(&ours, &printed) > 1e-2, "trial {trial}: [L] eq. 41 as printed passes");

        let pairs = random::<D>(trial, Weighting::PerPair);
        let h = stacked(&pairs.model, &pairs.pose, |n| n);
        let ours = of_blocks(&pairs.information(RangeForm::Projected).matrix);
        assert!(difference(&ours, &(h.transpose() * &h)) < 1e-12, "trial {trial}: weights per pair");
    }
}

/// \[L\] eq. 41 with `J_t = Abar` in the block of `t`: as if one sensor were all.
fn as_printed(c: &DMatrix<f64>, a: &DMatrix<f64>) -> DMatrix<f64> {
    let mut moments = c * c.transpose();
    let last = moments.nrows() - 1;
    moments[(last, last)] = 1.0;
    moments.kronecker(&(a.transpose() * a))
}

fn crb_is_the_inverse_of_the_factors<const D: usize>() {
    for trial in 0..100 {
        let scene = random::<D>(trial, Weighting::Common);
        let ours = of_blocks(&crb(&scene.information(RangeForm::Projected)).unwrap());
        let (c, a) = (extended(&scene.model), whitened_anchors(&scene.model, &scene.pose, 0));
        let inverse = |x: DMatrix<f64>| x.try_inverse().unwrap();
        let factors = inverse(&c * c.transpose()).kronecker(&inverse(a.transpose() * &a));
        // An inverse loses the digits that the condition takes.
        let matrix = of_blocks(&scene.information(RangeForm::Projected).matrix);
        let inflation = matrix.diagonal().component_mul(&ours.diagonal()).max();
        let (error, allowed) = (difference(&ours, &factors), 1e-14 * inflation);
        assert!(error < allowed && allowed < 1e-3, "trial {trial}: {error:e}, allowed {allowed:e}");
    }
}

/// \[L\] eq. 42 (with its last transpose) and 47: `U^T U = I`, so `phi = sqrt 2` times its coordinates.
fn unitary_bound_is_that_of_the_paper<const D: usize>() {
    for trial in 0..100 {
        let scene = random::<D>(trial, Weighting::PerPair);
        let u = tangent_basis(&scene.pose);
        assert!((u.transpose() * &u - DMatrix::identity(u.ncols(), u.ncols())).amax() < 1e-14);
        for form in [RangeForm::Projected, RangeForm::Raw] {
            let information = scene.information(form);
            let inner = u.transpose() * of_blocks(&information.matrix) * &u;
            let paper = &u * inner.try_inverse().unwrap() * u.transpose();
            let bound = unitary_crb(&information).unwrap();
            let ours = of_blocks(&image(&bound, &scene.pose.rotation));
            let error = difference(&ours, &paper);
            assert!(error < 1e-9, "trial {trial}, {form:?}: {error:e}");
            let orientation = (0..D * D).map(|i| paper[(i, i)]).sum::<f64>();
            assert!((2.0 * bound.angle_trace() / orientation - 1.0).abs() < 1e-9, "trial {trial}: trace");
        }
    }
}

fn knowledge_never_hurts<const D: usize>() {
    let mut gains = (0, 0);
    for trial in 0..100 {
        let scene: Scene<D> = random(trial, Weighting::PerPair);
        let projected = scene.information(RangeForm::Projected);
        let free = of_blocks(&crb(&projected).unwrap());
        let constrained = unitary_crb(&projected).unwrap();
        let raw = unitary_crb(&scene.information(RangeForm::Raw)).unwrap();

        let rotation = order(&of_blocks(&image(&constrained, &scene.pose.rotation)), &free);
        assert!(rotation.max() < 1.0 + 1e-7, "trial {trial}: UC-CRB above CRB by {:e}", rotation.max() - 1.0);
        let unprojected = order(&of_tangent(&raw), &of_tangent(&constrained));
        assert!(
            unprojected.max() < 1.0 + 1e-7,
            "trial {trial}: raw above projected by {:e}",
            unprojected.max() - 1.0
        );
        let free_trace = crb(&projected).unwrap().orientation_trace();
        gains.0 += usize::from(2.0 * constrained.angle_trace() < 0.9 * free_trace);
        gains.1 += usize::from(raw.shift_block().trace() < 0.9 * constrained.shift_block().trace());
    }
    assert!(gains.0 > 90 && gains.1 > 50, "gains of more than 10 % in {gains:?} of 100 scenes");
}

/// The angle variance of a linear bound against the projection itself: `P = sum l l^T`, each `l` a small error of `Q`.
fn angle_variance_is_that_of_the_nearest_rotation<const D: usize>() {
    for trial in 0..20 {
        let scene = random::<D>(trial, Weighting::PerPair);
        let rotation = scene.pose.rotation;
        let matrix = crb(&scene.information(RangeForm::Projected)).unwrap();
        let factor = of_blocks(&matrix).cholesky().unwrap().l();
        let step = 1e-6 / factor.amax();
        let angles = (0..D * (D + 1)).map(|k| {
            let error = SMatrix::<f64, D, D>::from_fn(|i, j| step * factor[(j * D + i, k)]);
            let nearest = Rotation::project(&(rotation.matrix() + error), Manifold::So);
            rotation.inverse().compose(&nearest).angle() / step
        });
        let expected = angles.map(|x| x * x).sum::<f64>();
        let found = Bound::linear(matrix, Some(&rotation)).angle_variance.unwrap();
        assert!((found / expected - 1.0).abs() < 1e-4, "trial {trial}: {found:e} against {expected:e}");
    }
}

/// The weakest motion has the largest variance of all, angles counted as metres at the sensors.
fn weakest_motion_has_the_largest_variance<const D: usize>() {
    for trial in 0..50 {
        let scene = random::<D>(trial, Weighting::PerPair);
        let information = scene.information(RangeForm::Raw);
        let topology = scene.model.topology();
        let size = (topology.gram().trace() / topology.len() as f64).sqrt();
        let mut covariance = of_tangent(&unitary_crb(&information).unwrap());
        for i in 0..D * (D - 1) / 2 {
            covariance.row_mut(i).scale_mut(size);
            covariance.column_mut(i).scale_mut(size);
        }
        let largest = covariance.symmetric_eigenvalues().max().sqrt();
        let found = observability(&information).motions[0];
        let deviation = found.standard_deviation.unwrap();
        assert!((deviation / largest - 1.0).abs() < 1e-9, "trial {trial}: {deviation:e} against {largest:e}");
        let turned = size * nalgebra::Vector3::from(found.rotation).norm();
        assert!((turned * turned - found.turning).abs() < 1e-12, "trial {trial}: {turned}");
        assert!(
            (found.turning + found.shift.norm_squared() - 1.0).abs() < 1e-12,
            "trial {trial}: 1 m in all"
        );
    }
}

#[test]
fn the_angle_of_a_linear_bound_is_that_of_the_nearest_rotation() {
    angle_variance_is_that_of_the_nearest_rotation::<2>();
    angle_variance_is_that_of_the_nearest_rotation::<3>();
}

#[test]
fn the_weakest_motion_has_the_largest_variance() {
    weakest_motion_has_the_largest_variance::<2>();
    weakest_motion_has_the_largest_variance::<3>();
}

#[test]
fn the_information_is_that_of_the_stacked_matrices() {
    information_is_that_of_the_stacked_matrices::<2>();
    information_is_that_of_the_stacked_matrices::<3>();
}

#[test]
fn the_unconstrained_bound_is_the_product_of_the_inverted_factors() {
    crb_is_the_inverse_of_the_factors::<2>();
    crb_is_the_inverse_of_the_factors::<3>();
}

#[test]
fn the_unitary_bound_is_that_of_the_paper() {
    unitary_bound_is_that_of_the_paper::<2>();
    unitary_bound_is_that_of_the_paper::<3>();
}

#[test]
fn to_know_that_q_is_a_rotation_or_to_keep_the_squared_ranges_never_hurts() {
    knowledge_never_hurts::<2>();
    knowledge_never_hurts::<3>();
}
