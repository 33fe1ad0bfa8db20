//! Matrices and gradients on the tangent space against finite differences of `theta(phi, t)`.

use nalgebra::{DMatrix, DVector};
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::{Manifold, Rotation, rotation_angles};
use rangelab::math::tangent::{
    MAX_TANGENT, TangentMatrix, TangentVector, join, restrict_gradient, split, tangent_dimension,
};

use super::positive_definite::blocks;
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense};

crate::in_plane_and_space!(
    restriction_is_the_information_along_the_manifold,
    gradients_restrict_alike,
    rotation_blocks_go_to_the_world_frame,
    the_nearest_pose_varies_as_its_derivative_says,
    split_undoes_join,
    matrix_algebra,
);

/// `d vec(theta) / d(phi, t)` by central differences.
fn slopes<const D: usize>(pose: &Pose<D>) -> DMatrix<f64> {
    let step = 1e-5;
    let mut slopes = DMatrix::zeros(D * (D + 1), tangent_dimension(D));
    for i in 0..tangent_dimension(D) {
        let moved = |sign: f64| {
            let mut x = TangentVector::zeros();
            x[i] = sign * step;
            let (phi, shift) = split::<D>(&x);
            dense::vector(&Theta::from(pose.retract(&phi, &shift)))
        };
        slopes.set_column(i, &((moved(1.0) - moved(-1.0)) / (2.0 * step)));
    }
    slopes
}

fn restriction_is_the_information_along_the_manifold<const D: usize>() {
    let mut sampler = Sampler::new(60);
    for _ in 0..100 {
        let (pose, information) = (sampler.pose::<D>(1.0), blocks::<D>(&mut sampler, |_| 1.0));
        let restricted = TangentMatrix::restrict(&information, &pose.rotation);
        let t = slopes(&pose);
        let expected = t.transpose() * dense::matrix(&information) * &t;
        at_most("T^T Lambda T", dense::difference(&dense::tangent(&restricted), &expected), 1e-9);
        let turned = pose.rotation.compose(&Rotation::exp(&[1e-6, 0.0, 0.0]));
        let spoiled = dense::tangent(&TangentMatrix::restrict(&information, &turned));
        caught("a rotation off by 1e-6", dense::difference(&spoiled, &expected), 1e-8);
        for i in 0..MAX_TANGENT {
            for j in 0..MAX_TANGENT {
                assert_eq!(restricted.entry(i, j), restricted.entry(j, i));
                if i.max(j) >= tangent_dimension(D) {
                    assert_eq!(restricted.entry(i, j), f64::from(u8::from(i == j)));
                }
            }
        }
    }
}

fn rotation_blocks_go_to_the_world_frame<const D: usize>() {
    let (mut sampler, step) = (Sampler::new(64), 1e-6);
    for _ in 0..100 {
        let (rotation, angles) = (sampler.rotation::<D>(), rotation_angles(D));
        let covariance = TangentMatrix::restrict(&blocks(&mut sampler, |_| 1.0), &rotation);
        let seen_in_world = |i: usize| {
            let mut phi = [0.0; 3];
            phi[i] = step;
            rotation.compose(&Rotation::exp(&phi)).compose(&rotation.inverse()).log().map(|x| x / step)
        };
        let slopes = DMatrix::from_fn(angles, angles, |i, j| seen_in_world(j)[i]);
        let in_body = dense::tangent(&covariance).view((0, 0), (angles, angles)).into_owned();
        let expected = &slopes * &in_body * slopes.transpose();
        let block = covariance.rotation_block_in_world(&rotation);
        let found = DMatrix::from_fn(angles, angles, |i, j| block[(i, j)]);
        at_most("R C R^T", dense::difference(&found, &expected), 1e-8);
        assert!((0..9).all(|k| (k / 3).max(k % 3) < angles || block[(k / 3, k % 3)] == 0.0));
        if D == 3 {
            caught("the covariance in the body frame", dense::difference(&in_body, &expected), 1e-7);
        }
    }
}

fn the_nearest_pose_varies_as_its_derivative_says<const D: usize>() {
    let (mut sampler, step) = (Sampler::new(65), 1e-6);
    for _ in 0..50 {
        let (pose, covariance) = (sampler.pose::<D>(1.0), blocks::<D>(&mut sampler, |_| 1.0));
        let mut slopes = DMatrix::zeros(tangent_dimension(D), D * (D + 1));
        for k in 0..D * (D + 1) {
            let moved = |sign: f64| {
                let mut theta = dense::vector(&Theta::from(pose));
                theta[k] += sign * step;
                let Theta { orientation, position } = dense::theta::<D>(&theta);
                let nearest = Pose { rotation: Rotation::project(&orientation, Manifold::So), position };
                let (phi, shift) = pose.local(&nearest);
                DVector::from_fn(tangent_dimension(D), |i, _| join(&phi, &shift)[i])
            };
            slopes.set_column(k, &((moved(1.0) - moved(-1.0)) / (2.0 * step)));
        }
        let expected = &slopes * dense::matrix(&covariance) * slopes.transpose();
        let found = dense::tangent(&TangentMatrix::of_nearest_pose(&covariance, &pose.rotation));
        at_most("covariance of the nearest pose", dense::difference(&found, &expected), 1e-8);
        let restricted = dense::tangent(&TangentMatrix::restrict(&covariance, &pose.rotation));
        caught("without the halves", dense::difference(&restricted, &expected), 1e-2);
    }
}

fn gradients_restrict_alike<const D: usize>() {
    let mut sampler = Sampler::new(61);
    for _ in 0..100 {
        let (pose, gradient) = (sampler.pose::<D>(1.0), sampler.theta::<D>(1.0));
        let found = restrict_gradient(&gradient, &pose.rotation);
        let expected = slopes(&pose).transpose() * dense::vector(&gradient);
        let found = DVector::from_fn(tangent_dimension(D), |i, _| found[i]);
        at_most("T^T g", (found - expected).norm(), 1e-9);
    }
}

fn split_undoes_join<const D: usize>() {
    let mut sampler = Sampler::new(62);
    let phi = sampler.axis::<D>();
    let shift = sampler.vector::<D>(1.0);
    assert_eq!(split::<D>(&join(&phi, &shift)), (phi, shift));
    assert!((tangent_dimension(D)..MAX_TANGENT).all(|i| join(&phi, &shift)[i] == 0.0));
}

fn matrix_algebra<const D: usize>() {
    let mut sampler = Sampler::new(63);
    let rotation = sampler.rotation::<D>();
    let mut a = TangentMatrix::restrict(&blocks::<D>(&mut sampler, |_| 1.0), &rotation);
    let b = TangentMatrix::restrict(&blocks::<D>(&mut sampler, |_| 1.0), &rotation);
    let before = dense::tangent(&a);
    a.add(&b);
    a.add_isotropic(2.0, 3.0);
    let angles = rotation_angles(D);
    let size = tangent_dimension(D);
    let shift = DMatrix::from_fn(size, size, |i, j| {
        if i != j {
            0.0
        } else if i < angles {
            2.0
        } else {
            3.0
        }
    });
    at_most("sum", (dense::tangent(&a) - (before + dense::tangent(&b) + shift)).norm(), 1e-13);
    let x = join(&sampler.axis::<D>(), &sampler.vector::<D>(1.0));
    let dense_x = DVector::from_fn(size, |i, _| x[i]);
    let product = dense::tangent(&a) * &dense_x;
    at_most("A x", (0..size).map(|i| (a.times(&x)[i] - product[i]).abs()).sum(), 1e-12);
    at_most("x^T A x", (a.quadratic_form(&x) - dense_x.dot(&product)).abs(), 1e-11);
    let inverse = dense::tangent(&a.inverse().unwrap()) * dense::tangent(&a);
    at_most("A^-1 A", (inverse - DMatrix::identity(size, size)).norm(), 1e-11);
    at_most(
        "angle trace",
        (a.angle_trace() - dense::tangent(&a).view((0, 0), (angles, angles)).trace()).abs(),
        1e-13,
    );
    at_most(
        "shift block",
        (a.shift_block().trace() + a.angle_trace() - dense::tangent(&a).trace()).abs(),
        1e-12,
    );
    assert!(TangentMatrix::<D>::zeros().inverse().is_err());
}
