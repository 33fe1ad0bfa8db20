//! Figures of the papers' set-ups: the posterior bounds of the fixed tracking draw over noisy trajectories, and what it
//! costs to project the unknown `||s||^2` out.

use nalgebra::SVector;
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;
use rangelab::bounds::{BoundKind, bounds_along, unitary_crb};
use rangelab::math::float::radians;
use rangelab::math::rotation::Rotation;
use rangelab::model::epoch::Recording;
use rangelab::model::ranging::{RangeForm, Weighting};

use crate::reference::reference;
use crate::scenes::{localization, points, tracking};

/// The recording with its truth drawn anew: noise on the angular velocity of the body (\[T\] eq. 11) and on the position.
fn noisy_trajectory(recording: &Recording<3>, trial: u64) -> Recording<3> {
    let mut random = Pcg64Mcg::seed_from_u64(trial);
    let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
    let mut drawn = recording.clone();
    let mut pose = rangelab::math::pose::Pose::identity();
    for (epoch, truth) in drawn.epochs.iter().zip(&mut drawn.truth) {
        let velocity = epoch.motion.angular_velocity;
        let turn = Rotation::exp(&velocity.map(|x| epoch.motion.interval * (x + radians(0.1) * normal())));
        pose = epoch.motion.predict_pose(&pose, &turn);
        pose.position += SVector::from_fn(|_, _| normal());
        *truth = Some(pose);
    }
    drawn
}

/// Root of the mean trace on `vec(Q)` over the trials, at each step, and its standard error at the last one.
fn root_mean_trace(kind: BoundKind, trials: u64) -> (Vec<f64>, f64) {
    let recording = tracking(Weighting::Common);
    let (mut sums, mut squares) = (vec![0.0; 20], 0.0);
    for trial in 0..trials {
        let bounds = bounds_along(&noisy_trajectory(&recording, trial)).unwrap();
        for (sum, step) in sums.iter_mut().zip(&bounds) {
            *sum += step.get(kind).unwrap().as_ref().unwrap().orientation_trace;
        }
        let last = bounds[19].get(kind).unwrap().as_ref().unwrap().orientation_trace;
        squares += last * last;
    }
    let count = trials as f64;
    let mean = sums[19] / count;
    let error = ((squares / count - mean * mean) / count).sqrt() / (2.0 * mean.sqrt());
    (sums.iter().map(|sum| (sum / count).sqrt()).collect(), error)
}

#[test]
fn the_posterior_bounds_of_the_fixed_tracking_draw() {
    for (kind, at_first, at_last) in
        [(BoundKind::LinearPosteriorCrb, 0.116, 0.0259), (BoundKind::PosteriorCrb, 0.0320, 0.0114)]
    {
        let (bound, error) = root_mean_trace(kind, 200);
        println!("{}: {:.5} -> {:.5} +- {error:.1e}", kind.name(), bound[0], bound[19]);
        // Half a unit of the last digit that the reference states.
        assert!(
            (bound[0] - at_first).abs() < 0.5e-3 * if at_first > 0.1 { 1.0 } else { 0.1 },
            "{}",
            bound[0]
        );
        assert!((bound[19] - at_last).abs() < 0.5e-4, "{}", bound[19]);
    }
}

/// Median and its standard error, from the order statistics one binomial deviation away.
fn median(mut values: Vec<f64>) -> (f64, f64) {
    values.sort_by(f64::total_cmp);
    let (middle, half_width) = (values.len() / 2, values.len().isqrt() / 2);
    (values[middle], (values[middle + half_width] - values[middle - half_width]) / 2.0)
}

#[test]
fn what_the_projection_costs_in_the_localization_set_up() {
    const DRAWS: usize = 4000;
    for expected in reference()["projection_cost"].as_array().expect("a list") {
        let number = |key: &str| expected[key].as_f64().expect("a number");
        let anchors =
            expected["anchors"].as_u64().and_then(|count| usize::try_from(count).ok()).expect("a count");
        let mut random = Pcg64Mcg::seed_from_u64(anchors as u64);
        let ratios: Vec<(f64, f64)> = (0..DRAWS)
            .map(|_| {
                let scene = localization(&points(&mut random, anchors, 500.0), Weighting::PerPair);
                let bound = |form| unitary_crb(&scene.information(form)).unwrap();
                let (projected, raw) = (bound(RangeForm::Projected), bound(RangeForm::Raw));
                let root = |a: f64, b: f64| (a / b).sqrt();
                (
                    root(projected.angle_trace(), raw.angle_trace()),
                    root(projected.shift_block().trace(), raw.shift_block().trace()),
                )
            })
            .collect();
        let (of_q, of_t) =
            (median(ratios.iter().map(|r| r.0).collect()), median(ratios.iter().map(|r| r.1).collect()));
        println!("{anchors} anchors: Q {:.3} +- {:.3}, t {:.3} +- {:.3}", of_q.0, of_q.1, of_t.0, of_t.1);
        for (what, (found, error)) in [("orientation", of_q), ("position", of_t)] {
            let (median, other) = (number(what), number(&format!("{what}_error")));
            let allowed = 3.0 * (error * error + other * other).sqrt();
            assert!((found - median).abs() < allowed, "{anchors} anchors, {what}: {found} against {median}");
            assert!(
                allowed < 0.2 * (median - 1.0),
                "{anchors} anchors, {what}: too few draws to see the cost"
            );
        }
    }
}
