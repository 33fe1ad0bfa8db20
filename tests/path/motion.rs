//! What estimators are told of a path, what is added to it, and what happens at the limits of its numbers.

use std::f64::consts::PI;

use rangelab::math::float::pow;
use rangelab::math::rotation::defect;
use rangelab::model::path::{PathSettings, Side};
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;
use serde_json::{from_str, to_string};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};
use crate::{heading, poses, rounds, start, undisturbed, wrapped};

crate::in_plane_and_space!(
    estimators_are_told_the_undisturbed_motion,
    velocities_are_added_to_the_path,
    disturbances_are_the_same_on_every_path,
    a_path_costs_no_rotation_its_digits,
    any_valid_path_gives_finite_poses,
    paths_survive_json,
);

fn estimators_are_told_the_undisturbed_motion<const D: usize>() {
    let mut sampler = Sampler::new(920);
    for path in rounds::<D>(&mut sampler) {
        let scenario = undisturbed(start::<D>(&mut sampler), path, 0.4, 40);
        let recording = simulate::<D>(&scenario, 0).unwrap();
        let mut pose = scenario.setup::<D>().unwrap().start;
        let mut rest = 0.0;
        for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
            let predicted = epoch.motion.predict_pose(&pose, &epoch.motion.rotation());
            let (turn, shift) = predicted.local(&truth.unwrap());
            at_most("prediction", turn.iter().map(|x| x.abs()).sum::<f64>() + shift.norm(), 1e-12);
            rest += epoch.motion.velocity.norm();
            pose = truth.unwrap();
        }
        caught("a body at rest", rest, 1.0);
    }
}

fn velocities_are_added_to_the_path<const D: usize>() {
    let mut sampler = Sampler::new(921);
    for path in rounds::<D>(&mut sampler) {
        let plain = undisturbed(start::<D>(&mut sampler), path, 0.25, 60);
        let mut moved = plain.clone();
        moved.motion.velocity[0] = 0.3;
        *moved.motion.angular_velocity.last_mut().unwrap() = -0.2;
        for (k, (a, b)) in poses::<D>(&plain).iter().zip(poses::<D>(&moved)).enumerate() {
            let time = 0.25 * (k + 1) as f64;
            let mut expected = a.position;
            expected[0] += 0.3 * time;
            at_most("drift", (b.position - expected).norm(), 1e-12);
            at_most("spin", wrapped(heading(&b) - heading(a) + 0.2 * time).abs(), 1e-12);
        }
    }
}

fn disturbances_are_the_same_on_every_path<const D: usize>() {
    let mut sampler = Sampler::new(922);
    let begin = start::<D>(&mut sampler);
    let shaken = |scenario: &Scenario| {
        let mut shaken = scenario.clone();
        (shaken.motion.sigma_omega, shaken.motion.sigma_t) = (0.1, 0.05);
        poses::<D>(&shaken).iter().zip(poses::<D>(scenario)).map(|(a, b)| a.position - b.position).collect()
    };
    let mut lists: Vec<Vec<_>> = Vec::new();
    for path in rounds::<D>(&mut sampler) {
        lists.push(shaken(&undisturbed(begin, path, 0.5, 30)));
    }
    for list in &lists {
        let most = list.iter().zip(&lists[0]).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        at_most("another disturbance", most, 1e-12);
        caught("no disturbance", list[29].norm(), 1e-3);
    }
}

fn a_path_costs_no_rotation_its_digits<const D: usize>() {
    let mut sampler = Sampler::new(923);
    for path in rounds::<D>(&mut sampler) {
        let mut scenario = undisturbed(start::<D>(&mut sampler), path, 0.25, 10_000);
        scenario.anchors.truncate(1);
        scenario.sensors.truncate(1);
        let (begin, last) = (scenario.setup::<D>().unwrap().start, poses::<D>(&scenario)[9_999]);
        at_most("defect", defect(last.rotation.matrix()), 3e-15);
        let (turn, shift) = begin.local(&last);
        at_most("250 laps", turn.iter().map(|x| x.abs()).sum::<f64>() + shift.norm(), 1e-10);
    }
}

/// Sizes over twenty decades, intervals beyond a round, points almost on each other.
fn any_valid_path_gives_finite_poses<const D: usize>() {
    let mut sampler = Sampler::new(924);
    let mut simulated = 0;
    for _ in 0..300 {
        let mut decade = |low: f64, high: f64| pow(10.0, sampler.uniform(low, high));
        let (radius, period, interval) = (decade(-12.0, 9.0), decade(-6.0, 9.0), decade(-6.0, 6.0));
        let (size, climb) = (decade(-5.0, 8.0), decade(-9.0, 9.0));
        let (count, closed) = (1 + sampler.below(12), sampler.below(2) == 0);
        let points = (0..count).map(|_| sampler.vector::<D>(size).as_slice().to_vec()).collect();
        let side = Side::Right;
        let path = match sampler.below(4) {
            0 => PathSettings::Turn { radius, period, side },
            1 => PathSettings::FigureEight { radius, period },
            2 if D == 3 => PathSettings::Helix { radius, period, climb, side },
            _ => PathSettings::Drawn { points, closed, period },
        };
        let scenario = undisturbed(start::<D>(&mut sampler), path, interval, 50);
        assert_eq!(scenario.validate(), [], "{scenario:?}");
        let setup = scenario.setup::<D>().unwrap();
        assert!(setup.motions.iter().all(|motion| motion.velocity.iter().all(|x| x.is_finite())
            && motion.angular_velocity.iter().all(|x| (x * interval).abs() <= PI * 1.000_001)));
        // A range beyond double precision is refused with its number.
        if let Ok(recording) = simulate::<D>(&scenario, 0) {
            simulated += 1;
            for pose in recording.truth.iter().flatten() {
                assert!(pose.position.iter().all(|x| x.is_finite()), "{scenario:?}");
                at_most("defect", defect(pose.rotation.matrix()), 1e-14);
            }
        }
    }
    assert!(simulated > 290, "{simulated}");
}

fn paths_survive_json<const D: usize>() {
    let mut sampler = Sampler::new(925);
    let helix = PathSettings::Helix { radius: 0.1, period: 1.0 / 3.0, climb: -0.7, side: Side::Right };
    for path in rounds::<D>(&mut sampler).into_iter().chain([helix]) {
        assert_eq!(from_str::<PathSettings>(&to_string(&path).unwrap()).unwrap(), path);
        if D == 3 || !matches!(path, PathSettings::Helix { .. }) {
            let scenario = undisturbed(start::<D>(&mut sampler), path, 0.25, 5);
            assert_eq!(Scenario::from_json(&scenario.to_json()), Ok(scenario));
        }
    }
}
