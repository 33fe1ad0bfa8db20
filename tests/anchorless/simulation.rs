//! What the nodes measure.

use rangelab::math::orthogonal::nearest_rotation;
use rangelab::model::kinematics::distance_record::pairs;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::{exact, paper, random};

#[test]
fn exact_records_are_the_geometry() {
    for dimension in [2, 3] {
        let scenario = exact(random(4, dimension, 6, 3));
        let motion = scenario.setup().unwrap().motion;
        let drawn = simulate_kinematics(&scenario, 3).unwrap();
        assert!(
            (nearest_rotation(&drawn.sensor_from_world).unwrap() - &drawn.sensor_from_world).amax() < 1e-14
        );
        for (k, &time) in drawn.record.stamps().iter().enumerate() {
            let positions = motion.positions(time);
            for (pair, (i, j)) in pairs(6).enumerate() {
                let distance = (positions.column(i) - positions.column(j)).norm();
                assert!((drawn.record.distances(k)[pair].unwrap() - distance).abs() < 1e-12 * distance);
            }
            let sensed = &drawn.sensor_from_world * motion.derivative(2, time);
            let reading = &drawn.record.accelerometers().unwrap().readings[k];
            assert!((reading - sensed).amax() < 1e-14);
        }
        assert_eq!(drawn.truth, motion.centred());
    }
}

#[test]
fn noise_has_the_spread_it_says() {
    let (noisy, clean) = (paper(100), exact(paper(100)));
    let (mut squares, mut count, mut sum) = (0.0, 0.0, 0.0);
    let mut acceleration_squares = 0.0;
    for trial in 0..5 {
        let noisy = simulate_kinematics(&noisy, trial).unwrap().record;
        let clean = simulate_kinematics(&clean, trial).unwrap().record;
        for k in 0..100 {
            for (with, without) in noisy.distances(k).iter().zip(clean.distances(k)) {
                let error = with.unwrap() - without.unwrap();
                sum += error;
                squares += error * error;
                count += 1.0;
            }
            let readings = |record: &rangelab::model::kinematics::distance_record::DistanceRecord| {
                record.accelerometers().unwrap().readings[k].clone()
            };
            acceleration_squares += (readings(&noisy) - readings(&clean)).norm_squared();
        }
    }
    // 22 500 distances and 10 000 accelerations: the variance is good to 1 % and 1.4 %, the mean to 0.7 % of sigma.
    assert!((squares / count / 1e-4 - 1.0).abs() < 0.04, "{}", squares / count);
    assert!((sum / count).abs() < 4.0 * 0.01 / f64::sqrt(count));
    assert!((acceleration_squares / 10_000.0 / 1e-6 - 1.0).abs() < 0.06, "{acceleration_squares}");
}

#[test]
fn trials_are_drawn_apart_and_always_the_same() {
    let scenario = paper(10);
    let (a, b) = (simulate_kinematics(&scenario, 4).unwrap(), simulate_kinematics(&scenario, 5).unwrap());
    assert_eq!(a, simulate_kinematics(&scenario, 4).unwrap());
    assert_ne!(a.record, b.record);
    assert_ne!(a.sensor_from_world, b.sensor_from_world);
}

/// A fifth of the distances goes, and the others keep their noise.
#[test]
fn missing_distances_move_no_other() {
    let mut scenario = paper(100);
    let all = simulate_kinematics(&scenario, 0).unwrap().record;
    scenario.noise.missing_probability = 0.2;
    let some = simulate_kinematics(&scenario, 0).unwrap().record;
    let share = some.missing() as f64 / 4500.0;
    assert!((share - 0.2).abs() < 4.0 * f64::sqrt(0.2 * 0.8 / 4500.0), "{share}");
    for k in 0..100 {
        for (with, without) in some.distances(k).iter().zip(all.distances(k)) {
            assert!(with.is_none() || with == without);
        }
    }
}

/// Random frames fill SO(D): the mean of an entry is 0, that of its square 1/D.
#[test]
fn frames_of_accelerometers_are_uniform() {
    for dimension in [2, 3] {
        let scenario = exact(random(0, dimension, 3, 2));
        let frames: Vec<_> =
            (0..300).map(|trial| simulate_kinematics(&scenario, trial).unwrap().sensor_from_world).collect();
        let mean = |of: fn(f64) -> f64| frames.iter().map(|frame| of(frame[(1, 0)])).sum::<f64>() / 300.0;
        assert!(mean(|x| x).abs() < 4.0 * f64::sqrt(1.0 / dimension as f64 / 300.0));
        assert!((mean(|x| x * x) - 1.0 / dimension as f64).abs() < 0.09);
        assert!(frames.iter().all(|frame| (frame.determinant() - 1.0).abs() < 1e-12));
    }
}
