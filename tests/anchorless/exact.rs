//! Without noise the motion comes back.

use rangelab::anchorless::estimate;
use rangelab::model::kinematics::settings::KinematicsName::{self, *};
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::{exact, paper, random};
use crate::scenes::error_of;

const PLANE: [KinematicsName; 8] = [
    Algorithm1Literal,
    Algorithm1Rank1,
    Algorithm1So,
    Algorithm1Lifted,
    Algorithm2Literal,
    Algorithm2Rank1,
    Algorithm2So,
    Algorithm2Lifted,
];
const SPACE: [KinematicsName; 4] = [Algorithm1So, Algorithm1Lifted, Algorithm2So, Algorithm2Lifted];

#[test]
fn the_paper_s_network_comes_back() {
    for count in [5, 10, 100] {
        for name in PLANE {
            let error = error_of(name, &exact(paper(count))).unwrap();
            assert!(error < 1e-8, "{name} at {count} stamps: {error:e}");
        }
    }
}

#[test]
fn random_networks_come_back_in_the_plane_and_in_space() {
    for seed in 0..6 {
        for name in PLANE {
            let error = error_of(name, &exact(random(seed, 2, 10, 2))).unwrap();
            assert!(error < 1e-8, "{name}, plane, {seed}: {error:e}");
        }
        for name in SPACE {
            let error = error_of(name, &exact(random(seed, 3, 12, 2))).unwrap();
            assert!(error < 1e-8, "{name}, space, {seed}: {error:e}");
        }
    }
}

/// Algorithm 2 is defined for higher degrees by its top coefficient, Algorithm 1 is not.
#[test]
fn algorithm_2_finds_motions_of_degree_three_and_four() {
    for degree in [3, 4] {
        for name in [Algorithm2Rank1, Algorithm2So, Algorithm2Lifted] {
            let error = error_of(name, &exact(random(3, 2, 10, degree))).unwrap();
            assert!(error < 1e-7, "{name}, degree {degree}: {error:e}");
        }
    }
}

/// In any order, unevenly, and with the middle away from time 0.
#[test]
fn stamps_need_not_be_regular() {
    let mut scenario = exact(paper(100));
    let times = vec![3.0, 0.1, 0.2, 9.7, 7.5, 4.4, 6.1, 0.2, 5.0, 2.0];
    scenario.stamps = Stamps::Listed { times };
    for name in PLANE {
        let error = error_of(name, &scenario).unwrap();
        assert!(error < 1e-8, "{name}: {error:e}");
    }
}

/// Five nodes are the fewest of the printed system; there the wrong branch fits its linear residual as well.
#[test]
fn the_fewest_nodes_are_enough() {
    let fewest =
        [(Algorithm1Rank1, 2, 5), (Algorithm2Literal, 2, 5), (Algorithm1So, 2, 3), (Algorithm1Lifted, 2, 6)];
    let in_space = [(Algorithm1So, 3, 5), (Algorithm1Lifted, 3, 9), (Algorithm2Lifted, 3, 9)];
    for (name, dimension, nodes) in fewest.into_iter().chain(in_space) {
        for seed in 0..5 {
            let error = error_of(name, &exact(random(seed, dimension, nodes, 2))).unwrap();
            assert!(error < 1e-6, "{name} in {dimension} dimensions with {nodes} nodes, {seed}: {error:e}");
        }
    }
}

#[test]
fn missing_distances_do_not_bias() {
    let mut scenario = exact(paper(100));
    scenario.noise.missing_probability = 0.3;
    for name in PLANE {
        let error = error_of(name, &scenario).unwrap();
        assert!(error < 1e-8, "{name}: {error:e}");
    }
}

/// `Q` is found as well, up to the reflection that positions are free to have.
#[test]
fn the_frame_of_the_accelerometers_is_found() {
    let scenario = exact(paper(100));
    for trial in 0..5 {
        let drawn = simulate_kinematics(&scenario, trial).unwrap();
        let found = estimate(Algorithm2So, &scenario.estimators, &drawn.record).unwrap();
        let motion = found.kinematics.unwrap();
        let turned = found.rotation.unwrap() * motion.coefficient(2);
        let sensed = &drawn.sensor_from_world * drawn.truth.coefficient(2);
        assert!((turned - sensed).amax() < 1e-9, "trial {trial}");
    }
}

/// The fitted `B_l` are those of eq. 7, and the one of degree 2L that is not there is zero.
#[test]
fn gram_coefficients_are_those_of_the_motion() {
    let scenario = exact(random(1, 2, 8, 2));
    let drawn = simulate_kinematics(&scenario, 0).unwrap();
    let truth = drawn.truth.gram();
    let found = estimate(Algorithm1So, &scenario.estimators, &drawn.record).unwrap().gram;
    assert_eq!((found.len(), truth.len()), (5, 5));
    // Rounding of 1e6 m^2 over 5 s.
    let mut rounding = 1e-4;
    for (l, (found, truth)) in found.iter().zip(&truth).enumerate() {
        assert!((found - truth).norm() < 1e-10 * truth.norm() + rounding, "B_{l}");
        rounding /= 5.0;
    }
}

/// What eq. 25 takes away is put back, wherever the stamps lie: without it `B_0` would miss kilometres where they are not
/// symmetric.
#[test]
fn gram_coefficients_with_accelerometers_are_those_of_the_motion() {
    for (first, last) in [(-5.0, 5.0), (0.0, 10.0)] {
        let mut scenario = exact(random(1, 2, 8, 2));
        scenario.stamps = Stamps::Regular { first, last, count: 100 };
        let drawn = simulate_kinematics(&scenario, 0).unwrap();
        let truth = drawn.truth.gram();
        let found = estimate(Algorithm2So, &scenario.estimators, &drawn.record).unwrap().gram;
        assert_eq!((found.len(), truth.len()), (5, 5));
        for (l, (found, truth)) in found.iter().zip(&truth).enumerate() {
            let error = (found - truth).norm() / truth.norm();
            assert!(error < 1e-7, "B_{l} of {first} to {last} s: {error:e}");
        }
    }
}

/// A straight range is a polynomial; only then has the older way no bias.
#[test]
fn range_polynomials_are_exact_only_where_ranges_are_polynomials() {
    let on_a_line = |scale: f64| {
        let mut scenario = exact(paper(20));
        let line = |values: &[f64]| values.iter().map(|x| vec![*x, scale * x * x]).collect::<Vec<_>>();
        scenario.coefficients =
            vec![line(&[0.0, 100.0, 250.0]), line(&[0.0, 1.0, -2.0]), line(&[0.0, 0.1, 0.3])];
        scenario.estimators.range_degree = 2;
        scenario
    };
    let error = |scale: f64| {
        let scenario = on_a_line(scale);
        let drawn = simulate_kinematics(&scenario, 0).unwrap();
        let found = estimate(RangePolynomial, &scenario.estimators, &drawn.record).unwrap();
        assert!(found.kinematics.is_none() && found.snapshots.is_empty());
        let truth = drawn.truth.gram();
        (0..3).map(|l| (&found.gram[l] - &truth[l]).norm() / truth[l].norm()).fold(0.0, f64::max)
    };
    assert!(error(0.0) < 1e-10, "{:e}", error(0.0));
    assert!(error(0.01) > 1e-6, "{:e}", error(0.01));
}

#[test]
fn scaling_of_an_epoch_gives_its_positions() {
    let mut scenario = exact(random(2, 3, 6, 2));
    scenario.noise.missing_probability = 0.01;
    let drawn = simulate_kinematics(&scenario, 0).unwrap();
    let found = estimate(MultidimensionalScaling, &scenario.estimators, &drawn.record).unwrap();
    let mut absent = 0;
    for (k, snapshot) in found.snapshots.iter().enumerate() {
        let complete = drawn.record.distances(k).iter().all(Option::is_some);
        assert_eq!(snapshot.is_some(), complete, "stamp {k}");
        let Some(snapshot) = snapshot else {
            absent += 1;
            continue;
        };
        let truth = drawn.truth.positions(drawn.record.stamps()[k]);
        assert!(
            (snapshot.transpose() * snapshot - truth.transpose() * &truth).norm()
                < 1e-12 * truth.norm_squared()
        );
    }
    assert!((1..50).contains(&absent));
}
