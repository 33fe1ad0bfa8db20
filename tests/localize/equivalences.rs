//! What must be equal: without noise to the truth, with noise to the papers' own formulas written out.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};
use rangelab::localize::Snapshot;
use rangelab::localize::optimal::algorithm_1;
use rangelab::math::newton::newton;
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::projection::project_in_metric;
use rangelab::math::quadratic::distance;
use rangelab::math::rotation::{Manifold, Rotation};
use rangelab::model::anchors::Anchors;
use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName as Name};
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::model::topology::Topology;

use crate::scenes::{Scene, difference, posed, shell};
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense, gain_form};

crate::in_plane_and_space!(
    exact_ranges_give_the_pose,
    least_squares_is_that_of_the_stacked_equations,
    simplified_is_the_procrustes_fit_of_the_sensors,
    costs_are_those_of_the_stacked_equations,
    mounting_errors_weigh_as_in_the_paper,
    total_least_squares_lies_between_optimal_and_simplified,
    the_frame_of_the_body_does_not_matter,
    the_frame_of_the_world_does_not_matter,
    a_body_of_equal_moments_needs_no_iterations,
);

fn exact_ranges_give_the_pose<const D: usize>() {
    let mut sampler = Sampler::new(500);
    for index in 0..150 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.0);
        let truth = Theta::from(scene.pose);
        for name in posed() {
            let mut settings = LocalizeSettings::default();
            for manifold in [Manifold::So, Manifold::O] {
                settings.manifold = manifold;
                let found = scene.estimate(name, &settings, 0.1);
                assert!(!found.reflected, "{name}");
                at_most(name.label(), difference(&found.theta.unwrap(), &truth), 1e-9);
            }
        }
        let snapshot = scene.snapshot();
        for (n, c) in scene.model.topology().sensors().iter().enumerate() {
            if let Some(place) = snapshot.sensor_position(n) {
                at_most("a sensor", (place - scene.pose.act(c)).norm(), 1e-9);
            }
        }
        let noisy = Scene::<D>::random(&mut sampler, index, 0.01);
        for name in posed() {
            caught(name.label(), difference(&noisy.theta(name), &noisy.pose.into()), 1e-9);
        }
    }
}

/// The papers' white linear model, row by row.
fn stacked<const D: usize>(scene: &Scene<D>) -> gain_form::Measurements {
    gain_form::measurements(&scene.model, &scene.ranges, &scene.ranges)
}

fn least_squares_is_that_of_the_stacked_equations<const D: usize>() {
    let mut sampler = Sampler::new(501);
    for index in 0..60 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.05);
        let gain_form::Measurements { matrix, values } = stacked(&scene);
        let expected = matrix.svd(true, true).solve(&values, 1e-14).unwrap();
        let found = dense::vector(&scene.theta(Name::Ls));
        at_most("LS", (found - &expected).norm(), 1e-6);
        caught("OUC-LS", (dense::vector(&scene.theta(Name::OucLs)) - expected).norm(), 1e-6);
    }
}

fn simplified_is_the_procrustes_fit_of_the_sensors<const D: usize>() {
    let mut sampler = Sampler::new(502);
    for index in 0..60 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.05);
        let snapshot = scene.snapshot();
        let sensors = scene.model.topology().sensors();
        let count = sensors.len();
        let places: Vec<SVector<f64, D>> = (0..count).map(|n| snapshot.sensor_position(n).unwrap()).collect();
        let mean = |points: &[SVector<f64, D>]| points.iter().sum::<SVector<f64, D>>() / count as f64;
        let (s0, c0) = (mean(&places), mean(sensors));
        let moment = DMatrix::from_fn(D, D, |i, j| {
            (0..count).map(|n| (places[n] - s0)[i] * (sensors[n] - c0)[j]).sum::<f64>()
        });
        let svd = moment.svd(true, true);
        let polar = svd.u.unwrap() * svd.v_t.unwrap();
        let orientation = SMatrix::<f64, D, D>::from_fn(|i, j| polar[(i, j)]);
        let expected = Theta { orientation, position: s0 - orientation * c0 };
        let settings = LocalizeSettings { manifold: Manifold::O, ..LocalizeSettings::default() };
        let found = scene.estimate(Name::SucLs, &settings, 0.1).theta.unwrap();
        at_most("SUC-LS", difference(&found, &expected), 1e-9);
        assert_eq!(scene.estimate(Name::SucTls, &settings, 0.3).theta, Some(found), "[L] Theorem 2");
    }
}

/// `||z - H theta||^2` with the best position.
fn stacked_cost<const D: usize>(measured: &gain_form::Measurements, q: &SMatrix<f64, D, D>) -> f64 {
    let columns = D * D;
    let of_q = measured.matrix.columns(0, columns) * DVector::from_column_slice(q.as_slice());
    let rest = &measured.values - of_q;
    let of_t = measured.matrix.columns(columns, D).into_owned();
    let t = of_t.clone().svd(true, true).solve(&rest, 1e-14).unwrap();
    (rest - of_t * t).norm_squared()
}

fn costs_are_those_of_the_stacked_equations<const D: usize>() {
    let mut sampler = Sampler::new(503);
    for index in 0..60 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.05);
        let reduced = scene.snapshot().reduced("test", 0.0).unwrap();
        let measured = stacked(&scene);
        for _ in 0..5 {
            let rotation = sampler.rotation::<D>();
            let found = reduced.residual + distance(&rotation, &reduced.target, &reduced.metric);
            let expected = stacked_cost(&measured, rotation.matrix());
            at_most("cost", (found - expected).abs(), 1e-9 * expected);
        }
        at_most("least cost", (reduced.residual - stacked_cost(&measured, &reduced.target)).abs(), 1e-7);
    }
}

/// [L] eq. 34 with `Lambda = sigma_e^2 Abar Abar^T + I`, sensor by sensor, in the space of the ranges.
fn perturbed<const D: usize>(scene: &Scene<D>, sigma: f64) -> gain_form::Measurements {
    let single = |n: usize| {
        let sensors = vec![scene.model.topology().sensors()[n]];
        let model = RangeModel::new(
            scene.model.anchors().clone(),
            Topology::new(sensors).unwrap(),
            *scene.model.noise(),
            Weighting::PerPair,
        );
        let ranges = Ranges::from_fn(scene.ranges.anchors(), 1, |m, _| scene.ranges.get(m, n));
        let weights = Ranges::from_fn(scene.ranges.anchors(), 1, |m, _| {
            let common = scene.model.weighting() == Weighting::Common;
            let first = (0..scene.ranges.sensors()).find_map(|k| scene.ranges.get(m, k));
            if common { first } else { scene.ranges.get(m, n) }
        });
        gain_form::measurements(&model.unwrap(), &ranges.unwrap(), &weights.unwrap())
    };
    let parts: Vec<_> = (0..scene.ranges.sensors())
        .map(|n| {
            let gain_form::Measurements { matrix, values } = single(n);
            let abar = matrix.columns(D * D, D).into_owned();
            let lambda =
                &abar * abar.transpose() * (sigma * sigma) + DMatrix::identity(abar.nrows(), abar.nrows());
            let whiten = lambda.cholesky().unwrap().l().try_inverse().unwrap();
            (&whiten * matrix, whiten * values)
        })
        .collect();
    let rows: usize = parts.iter().map(|(_, values)| values.len()).sum();
    let mut result =
        gain_form::Measurements { matrix: DMatrix::zeros(rows, D * (D + 1)), values: DVector::zeros(rows) };
    let mut first = 0;
    for (matrix, values) in parts {
        result.matrix.rows_mut(first, values.len()).copy_from(&matrix);
        result.values.rows_mut(first, values.len()).copy_from(&values);
        first += values.len();
    }
    result
}

fn mounting_errors_weigh_as_in_the_paper<const D: usize>() {
    let mut sampler = Sampler::new(504);
    for index in 0..40 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.05);
        let reduced = scene.snapshot().reduced("test", 0.2).unwrap();
        let rotation = sampler.rotation::<D>();
        let found = reduced.residual + distance(&rotation, &reduced.target, &reduced.metric);
        let expected = stacked_cost(&perturbed(&scene, 0.2), rotation.matrix());
        at_most("cost", (found - expected).abs(), 1e-9 * expected);
        let printed = stacked_cost(&perturbed(&scene, 1.0), rotation.matrix());
        caught("the printed weighting", (found - printed).abs(), 1e-3 * expected);
    }
}

fn total_least_squares_lies_between_optimal_and_simplified<const D: usize>() {
    let mut sampler = Sampler::new(505);
    let settings = LocalizeSettings::default();
    for index in (0..60).step_by(3) {
        let scene = Scene::<D>::random(&mut sampler, index, 0.02);
        let tls = |sigma| scene.estimate(Name::OucTls, &settings, sigma).theta.unwrap();
        at_most("no mounting errors", difference(&tls(0.0), &scene.theta(Name::OucLs)), 1e-15);
        at_most("great ones", difference(&tls(1e4), &scene.theta(Name::SucLs)), 1e-8);
        at_most("1 m", difference(&tls(1.0), &scene.theta(Name::OucTlsPrinted)), 1e-15);
        caught("10 cm", difference(&tls(0.1), &scene.theta(Name::SucLs)), 1e-8);
        caught("10 cm", difference(&tls(0.1), &scene.theta(Name::OucLs)), 1e-8);
    }
}

fn with_body_moved<const D: usize>(scene: &Scene<D>, shift: &SVector<f64, D>) -> Scene<D> {
    let sensors = scene.model.topology().sensors().iter().map(|c| c + shift).collect();
    let model = RangeModel::new(
        scene.model.anchors().clone(),
        Topology::new(sensors).unwrap(),
        *scene.model.noise(),
        scene.model.weighting(),
    );
    Scene { model: model.unwrap(), pose: scene.pose, ranges: scene.ranges.clone() }
}

fn the_frame_of_the_body_does_not_matter<const D: usize>() {
    let mut sampler = Sampler::new(506);
    for index in 0..60 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.02);
        let shift = sampler.vector::<D>(2.0);
        let moved = with_body_moved(&scene, &shift);
        for name in posed() {
            let (before, after) = (scene.theta(name), moved.theta(name));
            let expected = Theta { position: before.position - before.orientation * shift, ..before };
            at_most(name.label(), difference(&after, &expected), 1e-6);
            caught(name.label(), difference(&after, &before), 1e-6);
        }
    }
}

fn the_frame_of_the_world_does_not_matter<const D: usize>() {
    let mut sampler = Sampler::new(507);
    for index in 0..60 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.02);
        let motion = sampler.pose::<D>(20.0);
        let anchors = scene.model.anchors().positions().iter().map(|a| motion.act(a)).collect();
        let model = RangeModel::new(
            Anchors::new(anchors).unwrap(),
            scene.model.topology().clone(),
            *scene.model.noise(),
            scene.model.weighting(),
        );
        let moved =
            Scene { model: model.unwrap(), pose: motion.compose(&scene.pose), ranges: scene.ranges.clone() };
        for name in posed() {
            let (before, after) = (scene.theta(name), moved.theta(name));
            let rotation = motion.rotation.matrix();
            let expected = Theta {
                orientation: rotation * before.orientation,
                position: rotation * before.position + motion.position,
            };
            at_most(name.label(), difference(&after, &expected), 1e-6);
        }
    }
}

/// Where `C C^T ~ I` the weighted SUC-LS is the OUC-LS.
fn a_body_of_equal_moments_needs_no_iterations<const D: usize>() {
    let mut sampler = Sampler::new(508);
    let axes = || -> Vec<SVector<f64, D>> {
        (0..2 * D)
            .map(|k| SVector::from_fn(|i, _| if i == k / 2 { [0.5, -0.5][k % 2] } else { 0.0 }))
            .collect()
    };
    for _ in 0..20 {
        let cross = Topology::new(axes()).unwrap();
        let anchors = shell(&mut sampler, D + 2);
        let scene = Scene::<D>::of(&mut sampler, anchors, cross.clone(), Weighting::Common, 0.05);
        at_most("weighted", difference(&scene.theta(Name::SucLsWeighted), &scene.theta(Name::OucLs)), 1e-9);
        caught("simplified", difference(&scene.theta(Name::SucLs), &scene.theta(Name::OucLs)), 1e-6);
    }
}

/// In the plane three roads lead to the global minimum: the quartic, the secular equation, Newton from many starts.
#[test]
fn the_quartic_is_the_secular_equation_and_newton_in_the_plane() {
    let mut sampler = Sampler::new(509);
    for index in 0..300 {
        let scene = Scene::<2>::random(&mut sampler, index, [0.01, 0.3, 3.0][index / 100]);
        let snapshot: Snapshot<2> = scene.snapshot();
        let reduced = snapshot.reduced("test", 0.0).unwrap();
        let quartic = scene.theta(Name::OucLs).orientation;
        let secular = project_in_metric(&reduced.target, &reduced.metric.to_blocks(), Manifold::So).unwrap();
        at_most("secular", (secular.matrix() - quartic).norm(), 1e-7);
        let cost = |rotation: &Rotation<2>| distance(rotation, &reduced.target, &reduced.metric);
        let best = (0..8)
            .map(|k| {
                let start = Rotation::<2>::exp(&[f64::from(k) * 0.8, 0.0, 0.0]);
                let (near, _) = algorithm_1(&start, &reduced);
                newton(near, &reduced.target, &reduced.metric).unwrap()
            })
            .min_by(|a, b| cost(a).total_cmp(&cost(b)))
            .unwrap();
        at_most("Newton", (best.matrix() - quartic).norm(), 1e-7);
    }
}

/// The pose that carries the estimate is the pose: sensors of the estimate are those of the body.
#[test]
fn sensors_follow_the_body() {
    let mut sampler = Sampler::new(510);
    let scene = Scene::<3>::random(&mut sampler, 0, 0.02);
    let estimate = scene.estimate(Name::OucLs, &LocalizeSettings::default(), 0.0);
    let theta = estimate.theta.unwrap();
    let pose =
        Pose { rotation: Rotation::from_matrix(&theta.orientation).unwrap(), position: theta.position };
    let found = estimate.sensor_positions(scene.model.topology()).unwrap();
    for (s, c) in found.iter().zip(scene.model.topology().sensors()) {
        at_most("[L] eq. 26", (s - pose.act(c)).norm(), 1e-14);
    }
}
