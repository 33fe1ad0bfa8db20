//! What anchors and sensors can and cannot show.

use rangelab::math::rotation::{Manifold, Rotation, determinant};
use rangelab::model::estimator_settings::EstimatorName::{self, Eskf, EskfRaw, Kf, UcKf};
use rangelab::model::run::{Run, StepRecord};

use crate::{angle, changed, mean, of, position, run, teaches};

/// Mean distance from the truth along one axis of the world over some steps, m.
fn along(run: &Run, name: EstimatorName, steps: std::ops::Range<usize>, axis: usize) -> f64 {
    let off = |k: usize| {
        let truth = run.truth[k].as_ref().unwrap();
        (of(run, name).steps[k].posterior.position[axis] - truth.position[axis]).abs()
    };
    steps.clone().map(off).sum::<f64>() / steps.len() as f64
}

#[test]
fn figure_eight() {
    teaches("figure-eight", |_, run| {
        let [near, far] = [5..35, 45..75].map(|steps| mean(run, UcKf, steps, position));
        let bound = |k: usize| run.bounds.last().unwrap().steps[k].as_ref().unwrap().position_trace;
        far > 1.4 * near && bound(60) > 4.0 * bound(20)
    });
}

#[test]
fn towers() {
    teaches("towers", |_, run| {
        let height = |name, steps| along(run, name, steps, 2);
        let across = along(run, Eskf, 60..120, 0) + along(run, Eskf, 60..120, 1);
        height(Eskf, 60..120) > across
            && height(EskfRaw, 60..120) < 0.5 * height(EskfRaw, 0..20)
            && height(EskfRaw, 60..120) < 0.5 * height(Eskf, 60..120)
    });
}

#[test]
fn corridor() {
    teaches("corridor", |_, run| {
        let [forward, across] = [0, 1].map(|axis| along(run, UcKf, 0..40, axis));
        forward < 0.03 && across > 8.0 * forward && along(run, EskfRaw, 0..40, 1) < 0.3 * across
    });
}

#[test]
fn coplanar_ceiling() {
    teaches("coplanar-ceiling", |_, run| {
        along(run, UcKf, 0..60, 2) > 4.0 * along(run, EskfRaw, 0..60, 2)
            && along(run, UcKf, 0..60, 2) > 4.0 * along(run, UcKf, 0..60, 0)
    });
}

#[test]
fn three_anchors() {
    teaches("three-anchors", |_, run| {
        let late = |name| mean(run, name, 30..60, position);
        // What it claims stays what it was at the first step: nothing is learned in one direction.
        let claimed = |k: usize| of(run, UcKf).steps[k].covariance_trace.position;
        late(UcKf) > 3.0 * late(EskfRaw) && claimed(59) > 0.9 * claimed(0)
    });
}

#[test]
fn mirrored() {
    let rotations = changed("mirrored", |scenario| scenario.estimators.manifold = Manifold::So);
    let mirrors = |run: &Run| {
        let theta = of(run, UcKf).steps.last().unwrap().posterior.orientation.concat();
        determinant(&nalgebra::Matrix3::from_row_slice(&theta)) < 0.0
    };
    teaches("mirrored", |trial, seen| {
        let right = run(&rotations, trial);
        mirrors(seen) && !mirrors(&right) && mean(&right, UcKf, 30..60, angle) < 0.1
    });
}

#[test]
fn small_body() {
    teaches("small-body", |trial, seen| {
        let room = run(&changed("room", |_| ()), trial);
        let ratio =
            |figure: fn(&StepRecord) -> f64| mean(seen, UcKf, 0..1, figure) / mean(&room, UcKf, 0..1, figure);
        (5.0..20.0).contains(&ratio(angle)) && (0.9..1.1).contains(&ratio(position))
    });
}

#[test]
fn rod() {
    teaches("rod", |_, run| {
        let rotation = |rows: &[Vec<f64>]| {
            Rotation::<3>::from_matrix(&nalgebra::Matrix3::from_row_slice(&rows.concat())).unwrap()
        };
        let off = |name, k: usize| {
            let truth = rotation(&run.truth[k].as_ref().unwrap().orientation);
            truth.inverse().compose(&rotation(&of(run, name).steps[k].posterior.orientation)).log()
        };
        [UcKf, Eskf, EskfRaw].into_iter().all(|name| {
            let [roll, pitch, yaw] = off(name, 59).map(f64::to_degrees);
            // The error-state filters let it wander.
            (name != UcKf || roll.abs() > 40.0) && pitch.abs() < 3.0 && yaw.abs() < 3.0
        })
    });
}

#[test]
fn planar() {
    teaches("planar", |_, run| 1.2 * mean(run, UcKf, 0..40, angle) < mean(run, Kf, 0..40, angle));
}
