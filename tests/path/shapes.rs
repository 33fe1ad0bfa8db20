//! Turn, figure eight and helix against what defines them: distance from a centre, height, time of a round.

use std::f64::consts::{PI, TAU};

use nalgebra::SVector;
use rangelab::math::float::{atan2, cos, sin};
use rangelab::math::pose::Pose;
use rangelab::model::path::{PathSettings, Side};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};
use crate::{heading, level, poses, rounds, start, undisturbed, wrapped};

crate::in_plane_and_space!(
    a_turn_stays_on_its_circle_and_looks_along_it,
    an_eight_goes_round_two_circles_that_touch_at_the_start,
    closed_paths_return,
    the_angle_between_heading_and_displacement_shrinks_with_the_interval,
);

/// The point `radius` to the left of a pose.
fn left_of<const D: usize>(pose: &Pose<D>, radius: f64) -> SVector<f64, D> {
    let mut centre = pose.position;
    centre[0] -= radius * sin(heading(pose));
    centre[1] += radius * cos(heading(pose));
    centre
}

/// How far a pose is off a circle, and its heading off the direction along it; `radius` is negative to the right.
fn off_circle<const D: usize>(pose: &Pose<D>, centre: &SVector<f64, D>, radius: f64) -> (f64, f64) {
    let arm = pose.position - centre;
    let along = atan2(arm[1], arm[0]) + radius.signum() * PI / 2.0;
    ((arm.norm() - radius.abs()).abs(), wrapped(heading(pose) - along).abs())
}

fn a_turn_stays_on_its_circle_and_looks_along_it<const D: usize>() {
    let mut sampler = Sampler::new(900);
    for (side, sign) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
        let (start, radius) = (start::<D>(&mut sampler), sampler.uniform(0.5, 3.0));
        let scenario = undisturbed(start, PathSettings::Turn { radius, period: 7.3, side }, 0.31, 200);
        let centre = left_of(&start, sign * radius);
        for (k, pose) in poses::<D>(&scenario).iter().enumerate() {
            let (distance, angle) = off_circle(pose, &centre, sign * radius);
            at_most("distance from the circle", distance, 1e-12);
            at_most("heading off the tangent", angle, 1e-12);
            let turned = sign * TAU * 0.31 * (k + 1) as f64 / 7.3;
            at_most("turned by", wrapped(heading(pose) - heading(&start) - turned).abs(), 1e-12);
            caught("the other circle", off_circle(pose, &left_of(&start, -sign * radius), radius).0, 1e-3);
        }
    }
}

fn an_eight_goes_round_two_circles_that_touch_at_the_start<const D: usize>() {
    let mut sampler = Sampler::new(901);
    let (start, radius) = (start::<D>(&mut sampler), 1.7);
    let scenario = undisturbed(start, PathSettings::FigureEight { radius, period: 12.0 }, 0.37, 300);
    let mut seen = [0, 0];
    for (k, pose) in poses::<D>(&scenario).iter().enumerate() {
        let second = 0.37 * (k + 1) as f64 % 12.0 >= 6.0;
        seen[usize::from(second)] += 1;
        let side = if second { -radius } else { radius };
        let (distance, angle) = off_circle(pose, &left_of(&start, side), side);
        at_most("distance from the circle", distance, 1e-12);
        at_most("heading off the tangent", angle, 1e-12);
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
}

#[test]
fn a_helix_climbs_steadily_over_its_circle() {
    let mut sampler = Sampler::new(902);
    for (side, sign, climb) in [(Side::Left, 1.0, 0.8), (Side::Right, -1.0, -0.3)] {
        let (start, radius) = (start::<3>(&mut sampler), 2.2);
        let path = PathSettings::Helix { radius, period: 5.0, climb, side };
        let mut centre = left_of(&start, sign * radius);
        for (k, pose) in poses::<3>(&undisturbed(start, path, 0.13, 200)).iter().enumerate() {
            centre[2] = start.position[2] + climb * 0.13 * (k + 1) as f64 / 5.0;
            let (distance, angle) = off_circle(pose, &centre, sign * radius);
            at_most("distance from the helix", distance, 1e-12);
            at_most("height", (pose.position[2] - centre[2]).abs(), 1e-12);
            at_most("heading off the tangent", angle, 1e-12);
        }
    }
}

fn closed_paths_return<const D: usize>() {
    let mut sampler = Sampler::new(903);
    for path in rounds::<D>(&mut sampler) {
        let scenario = undisturbed(start::<D>(&mut sampler), path, 0.25, 80);
        let begin = scenario.setup::<D>().unwrap().start;
        let poses = poses::<D>(&scenario);
        for lap in [39, 79] {
            let (angle, shift) = begin.local(&poses[lap]);
            at_most("position after a lap", shift.norm(), 1e-12);
            at_most("orientation after a lap", angle.iter().map(|x| x.abs()).sum(), 1e-12);
        }
        caught("half a quarter lap on", (poses[4].position - begin.position).norm(), 0.01);
    }
}

/// The largest angle between a heading and the displacement of the interval that it ends.
fn lag<const D: usize>(poses: &[Pose<D>]) -> f64 {
    let angle = |two: &[Pose<D>]| {
        let [east, north] = level(&(two[1].position - two[0].position));
        wrapped(heading(&two[1]) - atan2(north, east)).abs()
    };
    poses.windows(2).map(angle).fold(0.0, f64::max)
}

fn the_angle_between_heading_and_displacement_shrinks_with_the_interval<const D: usize>() {
    let mut sampler = Sampler::new(904);
    let period = 10.0;
    let kinds = [
        PathSettings::Turn { radius: 2.0, period, side: Side::Right },
        PathSettings::FigureEight { radius: 1.0, period },
        PathSettings::Drawn { points: bent::<D>(), closed: false, period: 30.0 },
    ];
    for path in kinds {
        let start = start::<D>(&mut sampler);
        let start = Pose { position: SVector::zeros(), ..start };
        let lags = [(0.02, 450), (0.01, 900)]
            .map(|(interval, steps)| lag(&poses::<D>(&undisturbed(start, path.clone(), interval, steps))));
        assert!((lags[0] / lags[1] - 2.0).abs() < 0.1, "{path:?}: {lags:?} should halve with the interval");
        at_most("lag", lags[0], 0.03);
    }
}

/// A gentle bend from the origin.
fn bent<const D: usize>() -> Vec<Vec<f64>> {
    [[3.0, 1.0, 0.5], [5.0, 4.0, 1.0], [4.0, 7.0, 1.0]].map(|point| point[..D].to_vec()).to_vec()
}
