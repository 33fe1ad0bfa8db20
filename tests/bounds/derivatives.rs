//! The Fisher information against finite differences of the measurement function and of the log-likelihood.

use nalgebra::{DMatrix, SVector};
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::tangent::{TangentVector, split, tangent_dimension};
use rangelab::model::ranging::{RangeForm, Weighting};

use crate::dense::{difference, moved, of_blocks, of_tangent, variance};
use crate::scenes::{FORMS, Scene, random};

/// The squared ranges at any `[Q | t]`, sensor by sensor.
fn squared_ranges<const D: usize>(scene: &Scene<D>, theta: &Theta<D>) -> Vec<Vec<f64>> {
    let of_sensor = |c: &SVector<f64, D>| {
        let sensor_in_world = theta.orientation * c + theta.position;
        scene.model.anchors().positions().iter().map(|a| (a - sensor_in_world).norm_squared()).collect()
    };
    scene.model.topology().sensors().iter().map(of_sensor).collect()
}

/// The log-likelihood of the noise-free data; the projected form profiles one unknown offset a sensor out.
fn log_likelihood<const D: usize>(scene: &Scene<D>, theta: &Theta<D>, form: RangeForm) -> f64 {
    let (data, model) = (squared_ranges(scene, &Theta::from(scene.pose)), squared_ranges(scene, theta));
    let of_sensor = |n: usize| -> f64 {
        let weights: Vec<f64> =
            (0..data[n].len()).map(|m| 1.0 / variance(&scene.model, &scene.pose, m, n)).collect();
        let residuals: Vec<f64> = data[n].iter().zip(&model[n]).map(|(d, h)| d - h).collect();
        let mean =
            weights.iter().zip(&residuals).map(|(w, e)| w * e).sum::<f64>() / weights.iter().sum::<f64>();
        let offset = if form == RangeForm::Projected { mean } else { 0.0 };
        weights.iter().zip(&residuals).map(|(w, e)| w * (e - offset) * (e - offset)).sum()
    };
    -0.5 * (0..data.len()).map(of_sensor).sum::<f64>()
}

/// `J^T Sigma^-1 J` with the central difference of the squared ranges, which is exact: they are quadratic in `theta`.
fn by_jacobian<const D: usize>(scene: &Scene<D>, spoil: f64) -> DMatrix<f64> {
    let (step, size) = (0.25, D * (D + 1));
    let columns: Vec<Vec<f64>> = (0..size)
        .map(|entry| {
            let ahead = squared_ranges(scene, &moved(&scene.pose, entry, step)).concat();
            let behind = squared_ranges(scene, &moved(&scene.pose, entry, -step)).concat();
            ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * step)).collect()
        })
        .collect();
    let anchors = scene.model.anchors().len();
    let mut j = DMatrix::from_fn(columns[0].len(), size, |row, column| {
        columns[column][row] / variance(&scene.model, &scene.pose, row % anchors, row / anchors).sqrt()
    });
    j.column_mut(0).scale_mut(1.0 + spoil);
    j.transpose() * j
}

fn jacobian_gives_the_raw_information<const D: usize>() {
    for trial in 0..60 {
        let scene = random::<D>(trial, Weighting::PerPair);
        let ours = of_blocks(&scene.information(RangeForm::Raw).matrix);
        let error = difference(&ours, &by_jacobian(&scene, 0.0));
        assert!(error < 1e-11, "trial {trial}: {error:e}");
        let spoiled = difference(&ours.columns(0, 1).into(), &by_jacobian(&scene, 1e-6).columns(0, 1).into());
        assert!(spoiled > 1e-10, "trial {trial}: a spoiled Jacobian passes with {spoiled:e}");
    }
}

/// Minus the matrix of second differences along the geodesics through the true pose, perturbed by `step`.
fn by_log_likelihood<const D: usize>(
    scene: &Scene<D>,
    form: RangeForm,
    perturb: impl Fn(&Pose<D>, &TangentVector) -> Pose<D>,
) -> DMatrix<f64> {
    let step = 1e-4;
    let at = |i: usize, a: f64, j: usize, b: f64| {
        let mut x = TangentVector::zeros();
        x[i] += a * step;
        x[j] += b * step;
        log_likelihood(scene, &Theta::from(perturb(&scene.pose, &x)), form)
    };
    DMatrix::from_fn(tangent_dimension(D), tangent_dimension(D), |i, j| {
        let mixed = at(i, 1.0, j, 1.0) - at(i, 1.0, j, -1.0) - at(i, -1.0, j, 1.0) + at(i, -1.0, j, -1.0);
        -mixed / (4.0 * step * step)
    })
}

fn on_the_right<const D: usize>(pose: &Pose<D>, x: &TangentVector) -> Pose<D> {
    let (phi, shift) = split(x);
    pose.retract(&phi, &shift)
}

/// The mistake of reading the angles in the world frame; in the plane there is no such mistake, so the turn is reversed.
fn spoiled<const D: usize>(pose: &Pose<D>, x: &TangentVector) -> Pose<D> {
    let (phi, shift) = split(x);
    let turn = Pose { rotation: rangelab::math::rotation::Rotation::exp(&phi), position: SVector::zeros() };
    if D == 2 {
        return pose.retract(&phi.map(|angle| -angle), &shift);
    }
    Pose { rotation: turn.rotation.compose(&pose.rotation), position: pose.position + shift }
}

fn curvature_gives_the_pose_information<const D: usize>() {
    for trial in 0..30 {
        let scene = random::<D>(trial, Weighting::PerPair);
        for form in FORMS {
            let ours = of_tangent(&scene.information(form).on_tangent_space());
            let error = difference(&ours, &by_log_likelihood(&scene, form, on_the_right));
            assert!(error < 1e-6, "trial {trial}, {form:?}: {error:e}");
            let rejected = difference(&ours, &by_log_likelihood(&scene, form, spoiled));
            assert!(rejected > 1e-4, "trial {trial}, {form:?}: the wrong frame passes with {rejected:e}");
        }
    }
}

#[test]
fn the_jacobian_of_the_squared_ranges_gives_the_raw_information() {
    jacobian_gives_the_raw_information::<2>();
    jacobian_gives_the_raw_information::<3>();
}

#[test]
fn the_curvature_of_the_log_likelihood_gives_the_pose_information() {
    curvature_gives_the_pose_information::<2>();
    curvature_gives_the_pose_information::<3>();
}
