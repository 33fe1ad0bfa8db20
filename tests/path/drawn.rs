//! Drawn paths against the pyramid of P. J. Barry and R. N. Goldman (1988), which makes no use of cubics.

use std::f64::consts::TAU;

use nalgebra::SVector;
use rangelab::math::float::{atan2, cos, sin};
use rangelab::math::pose::Pose;
use rangelab::model::document::entries::coordinates;
use rangelab::model::path::{Curve, PathSettings};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};
use crate::{heading, level, poses, start, undisturbed, wrapped};

crate::in_plane_and_space!(
    the_body_stays_on_the_curve,
    the_curve_goes_through_its_points_at_even_speed,
    the_body_looks_along_the_curve_from_the_start,
    an_open_path_ends_at_rest,
    a_path_may_turn_back_on_itself_or_go_straight_up,
);

/// The point between `points[1]` and `points[2]` at knot parameter `u` in 0..=1, by repeated linear interpolation.
fn pyramid<const D: usize>(points: &[SVector<f64, D>; 4], u: f64) -> SVector<f64, D> {
    let mut knots = [0.0; 4];
    for i in 1..4 {
        knots[i] = knots[i - 1] + (points[i] - points[i - 1]).norm().sqrt();
    }
    let t = knots[1] + u * (knots[2] - knots[1]);
    let mut level = points.to_vec();
    for width in [1, 2] {
        level = (0..level.len() - 1)
            .map(|i| {
                let (from, to) = (knots[i], knots[i + width]);
                level[i] * ((to - t) / (to - from)) + level[i + 1] * ((t - from) / (to - from))
            })
            .collect();
    }
    level[0] * (1.0 - u) + level[1] * u
}

/// The four points of each piece of an open curve.
fn pieces<const D: usize>(points: &[SVector<f64, D>]) -> Vec<[SVector<f64, D>; 4]> {
    let last = points.len() - 1;
    let mut all = vec![points[0] * 2.0 - points[1]];
    all.extend(points);
    all.push(points[last] * 2.0 - points[last - 1]);
    all.windows(4).map(|four| four.try_into().unwrap()).collect()
}

/// Distance of a point from the curve: the best of a grid, then a search around it.
fn distance<const D: usize>(pieces: &[[SVector<f64, D>; 4]], point: &SVector<f64, D>) -> f64 {
    let off = |x: f64| {
        let piece = (0..pieces.len()).rfind(|&i| i as f64 <= x).unwrap();
        (pyramid(&pieces[piece], x - piece as f64) - point).norm()
    };
    let end = pieces.len() as f64;
    let grid = (0..=50 * pieces.len()).map(|i| i as f64 / 50.0);
    let near = grid.min_by(|&a, &b| off(a).total_cmp(&off(b))).unwrap();
    let (mut low, mut high) = ((near - 0.02).max(0.0), (near + 0.02).min(end));
    for _ in 0..120 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if off(a) < off(b) { high = b } else { low = a }
    }
    off(0.5 * (low + high))
}

/// A walk that never turns back.
fn walk<const D: usize>(sampler: &mut Sampler, count: usize) -> Vec<SVector<f64, D>> {
    let mut at = sampler.vector::<D>(1.0);
    let mut step = || {
        at += sampler.vector::<D>(0.4);
        at[0] += 1.0;
        at
    };
    (0..count).map(|_| step()).collect()
}

/// Eight points around a ring.
fn ring<const D: usize>(sampler: &mut Sampler) -> Vec<SVector<f64, D>> {
    let at = |i: i32| {
        let angle = f64::from(i) * TAU / 8.0;
        sampler.vector::<D>(0.3) + SVector::from_fn(|axis, _| [3.0 * cos(angle), 3.0 * sin(angle), 0.0][axis])
    };
    (0..8).map(at).collect()
}

fn along<const D: usize>(points: &[SVector<f64, D>], closed: bool, period: f64) -> PathSettings {
    PathSettings::Drawn { points: coordinates(&points[1..]), closed, period }
}

fn the_body_stays_on_the_curve<const D: usize>() {
    let mut sampler = Sampler::new(910);
    let points = walk::<D>(&mut sampler, 9);
    let start = Pose { position: points[0], ..start(&mut sampler) };
    let pieces = pieces(&points);
    for pose in poses::<D>(&undisturbed(start, along(&points, false, 20.0), 0.17, 117)) {
        at_most("distance from the curve", distance(&pieces, &pose.position), 1e-12);
        let mut off = pose.position;
        off[1] += 1e-3;
        caught("a millimetre to the side", distance(&pieces, &off), 1e-5);
    }
}

fn the_curve_goes_through_its_points_at_even_speed<const D: usize>() {
    let mut sampler = Sampler::new(911);
    for closed in [false, true] {
        let points = if closed { ring(&mut sampler) } else { walk::<D>(&mut sampler, 8) };
        let curve = Curve::through(&points, closed);
        let fine: Vec<_> =
            (0..=20_000).map(|i| curve.position_and_tangent(f64::from(i) / 20_000.0).0).collect();
        let steps: Vec<f64> = fine.windows(2).map(|two| (two[1] - two[0]).norm()).collect();
        let mean = curve.length() / 20_000.0;
        let uneven = steps.iter().map(|step| (step / mean - 1.0).abs()).fold(0.0, f64::max);
        at_most("speed off its mean", uneven, 0.01);
        for point in &points {
            let nearest = fine.iter().map(|p| (p - point).norm()).fold(f64::INFINITY, f64::min);
            at_most("a point off the curve", nearest, mean);
        }
        let end = if closed { points[0] } else { points[7] };
        at_most("the end", (curve.position_and_tangent(1.0).0 - end).norm(), 1e-12);
    }
}

fn the_body_looks_along_the_curve_from_the_start<const D: usize>() {
    let mut sampler = Sampler::new(912);
    let points = walk::<D>(&mut sampler, 5);
    let start = Pose { position: points[0], ..start(&mut sampler) };
    let scenario = undisturbed(start, along(&points, false, 10.0), 0.1, 100);
    let begin = scenario.setup::<D>().unwrap().start;
    let [east, north] = level(&(points[1] - points[0]));
    at_most("heading at the start", wrapped(heading(&begin) - atan2(north, east)).abs(), 1e-12);
    let vertical = |pose: &Pose<D>| pose.rotation.matrix().row(D - 1).into_owned();
    if D == 3 {
        at_most("tilt", (vertical(&begin) - vertical(&start)).norm(), 1e-12);
    }
    let curve = Curve::through(&points, false);
    for (k, pose) in poses::<D>(&scenario).iter().enumerate() {
        let [east, north] = level(&curve.position_and_tangent((k + 1) as f64 / 100.0).1);
        at_most("heading", wrapped(heading(pose) - atan2(north, east)).abs(), 1e-10);
    }
}

fn an_open_path_ends_at_rest<const D: usize>() {
    let mut sampler = Sampler::new(913);
    let points = walk::<D>(&mut sampler, 4);
    let start = Pose { position: points[0], ..start(&mut sampler) };
    let poses = poses::<D>(&undisturbed(start, along(&points, false, 5.0), 0.3, 30));
    let last = poses[29];
    at_most("the end", (last.position - points[3]).norm(), 1e-12);
    for pose in &poses[16..] {
        assert_eq!(pose.position, last.position);
        at_most("turn at rest", wrapped(heading(pose) - heading(&last)).abs(), 1e-12);
    }
    caught("before the end", (poses[15].position - last.position).norm(), 1e-3);
}

/// There and back through the same points, and a jump of the direction by half a turn where it turns.
fn a_path_may_turn_back_on_itself_or_go_straight_up<const D: usize>() {
    let mut sampler = Sampler::new(914);
    let start = start::<D>(&mut sampler);
    let mut away = start.position;
    away[D - 1] += 2.0;
    for closed in [false, true] {
        let points =
            if closed { vec![start.position, away] } else { vec![start.position, away, start.position] };
        let poses = poses::<D>(&undisturbed(start, along(&points, closed, 8.0), 0.5, 16));
        at_most("half way", (poses[7].position - away).norm(), 1e-12);
        at_most("back", (poses[15].position - start.position).norm(), 1e-12);
        for pose in &poses {
            if D == 3 {
                at_most("heading on the way up", wrapped(heading(pose) - heading(&start)).abs(), 1e-12);
            } else {
                at_most("heading up or down", cos(heading(pose)).abs(), 1e-12);
            }
        }
    }
}
