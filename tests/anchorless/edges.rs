//! What cannot be found is refused with the numbers in it.

use rangelab::Error;
use rangelab::anchorless::estimate;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::distance_record::{DistanceRecord, pairs};
use rangelab::model::kinematics::presets::KINEMATICS_PRESETS;
use rangelab::model::kinematics::settings::KinematicsName::{self, *};
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::degenerate_networks::is_finite;
use crate::networks::{exact, paper, random};
use crate::scenes::error_of;

fn refusal(name: KinematicsName, scenario: &KinematicsScenario) -> Error {
    let trial = simulate_kinematics(scenario, 0).unwrap();
    match estimate(name, &scenario.estimators, &trial.record) {
        Err(error) => error,
        Ok(_) => panic!("{name} gave an answer"),
    }
}

#[track_caller]
fn too_few(name: KinematicsName, scenario: &KinematicsScenario, of: &str, found: usize, needed: usize) {
    match refusal(name, scenario) {
        Error::TooFew { counted, found: f, needed: n, reason, .. } => {
            assert_eq!((counted, f, n), (of, found, needed), "{name}");
            assert!(reason.ends_with('.'), "{name}: {reason}");
        }
        other => panic!("{name}: {other}"),
    }
}

#[test]
fn a_node_too_few_is_refused() {
    let fewest = [
        (Algorithm1Literal, 2, 5),
        (Algorithm1Rank1, 2, 5),
        (Algorithm2Literal, 2, 5),
        (Algorithm2Rank1, 2, 5),
        (Algorithm1So, 2, 3),
        (Algorithm2So, 2, 3),
        (Algorithm1Lifted, 2, 6),
        (Algorithm1So, 3, 5),
        (Algorithm2So, 3, 5),
        (Algorithm1Lifted, 3, 9),
        (Algorithm2Lifted, 3, 9),
        (MultidimensionalScaling, 2, 3),
        (MultidimensionalScaling, 3, 4),
    ];
    for (name, dimension, needed) in fewest {
        too_few(name, &random(0, dimension, needed - 1, 2), "nodes", needed - 1, needed);
        let enough = random(0, dimension, needed, 2);
        let trial = simulate_kinematics(&enough, 0).unwrap();
        assert!(estimate(name, &enough.estimators, &trial.record).is_ok(), "{name} with {needed} nodes");
    }
}

#[test]
fn too_few_stamps_are_refused_and_repeated_ones_count_once() {
    let listed = |times: &[f64]| {
        let mut scenario = paper(1);
        scenario.stamps = Stamps::Listed { times: times.to_vec() };
        scenario
    };
    too_few(Algorithm1Rank1, &listed(&[0.0, 1.0, 2.0, 3.0]), "different stamps", 4, 5);
    too_few(Algorithm1So, &listed(&[0.0, 1.0, 2.0, 3.0, 3.0, 3.0]), "different stamps", 4, 5);
    too_few(Algorithm2So, &listed(&[0.0, 1.0, 2.0]), "different stamps", 3, 4);
    too_few(RangePolynomial, &listed(&[0.0, 1.0, 2.0]), "different stamps", 3, 5);
    too_few(Algorithm1So, &listed(&[2.0; 9]), "different stamps", 1, 5);
    let repeated = exact(listed(&[0.0, 1.0, 2.0, 3.0, 3.0, 4.0, 4.0]));
    assert!(error_of(Algorithm1So, &repeated).unwrap() < 1e-7);
    assert!(error_of(Algorithm2So, &exact(listed(&[0.0, 1.0, 2.0, 3.0]))).unwrap() < 1e-7);
}

#[test]
fn stamps_that_nearly_coincide_are_degenerate() {
    let mut scenario = paper(1);
    scenario.stamps = Stamps::Listed { times: vec![0.0, 1e-14, 1.0, 2.0, 3.0] };
    assert!(matches!(refusal(Algorithm1So, &scenario), Error::Degenerate { .. }));
}

#[test]
fn a_pair_that_is_never_measured_is_refused() {
    let mut scenario = paper(20);
    scenario.noise.missing_probability = 1.0;
    assert!(matches!(refusal(Algorithm1So, &scenario), Error::PairTooFew { pair: (0, 1), found: 0, .. }));
    too_few(MultidimensionalScaling, &scenario, "complete epochs", 0, 1);
}

/// The record without the distance between two nodes at all stamps but the first few.
fn without_pair(scenario: &KinematicsScenario, pair: (usize, usize), kept: usize) -> DistanceRecord {
    let record = simulate_kinematics(scenario, 0).unwrap().record;
    let number = pairs(record.nodes()).position(|each| each == pair).unwrap();
    let of_stamp = |k: usize| {
        let mut distances = record.distances(k).to_vec();
        distances[number] = distances[number].filter(|_| k < kept);
        distances
    };
    let (stamps, sigma) = (record.stamps().to_vec(), record.sigma());
    let distances = (0..stamps.len()).flat_map(of_stamp).collect();
    let left = DistanceRecord::new(record.dimension(), record.nodes(), stamps, distances, sigma).unwrap();
    left.with_accelerometers(record.accelerometers().unwrap().clone()).unwrap()
}

#[test]
fn one_pair_that_measures_too_rarely_is_named() {
    let scenario = paper(20);
    let refused = |name, kept| {
        let record = without_pair(&scenario, (2, 6), kept);
        estimate(name, &scenario.estimators, &record).unwrap_err()
    };
    let needs = [
        (Algorithm1So, 5),
        (Algorithm2So, 4),
        (SnapshotSync, 5),
        (MaximumLikelihood, 5),
        (RangePolynomial, 5),
    ];
    for (name, needed) in needs {
        for kept in [0, 1, needed - 1] {
            let error = refused(name, kept);
            let expected = (kept, needed);
            assert!(
                matches!(error, Error::PairTooFew { pair: (2, 6), found, needed, .. } if (found, needed) == expected),
                "{name}: {error}"
            );
        }
        let record = without_pair(&scenario, (2, 6), needed);
        assert!(estimate(name, &scenario.estimators, &record).is_ok(), "{name}");
    }
    let sentence = refused(SnapshotSync, 0).to_string();
    assert!(
        sentence.contains("between nodes 3 and 7") && sentence.ends_with("never measured it"),
        "{sentence}"
    );
    assert!(refused(SnapshotSync, 1).to_string().ends_with("measured it at one only"));
}

#[test]
fn motions_without_accelerations_are_refused() {
    let names = [Algorithm1Literal, Algorithm1Rank1, Algorithm1So, Algorithm1Lifted];
    let with = |acceleration: fn(usize) -> [f64; 2]| {
        let mut scenario = exact(paper(100));
        scenario.coefficients[2] = (0..10).map(|node| acceleration(node).to_vec()).collect();
        scenario
    };
    let none = with(|_| [0.0, 0.0]);
    let common = with(|_| [0.3, -0.7]);
    let on_a_line = with(|node| [node as f64, 2.0 * node as f64]);
    for scenario in [none, common, on_a_line] {
        for name in
            names.into_iter().chain([Algorithm2Literal, Algorithm2Rank1, Algorithm2So, Algorithm2Lifted])
        {
            let error = refusal(name, &scenario);
            assert!(matches!(error, Error::Degenerate { .. }), "{name}: {error}");
            assert!(error.to_string().contains("accelerations"), "{error}");
        }
    }
}

/// With noise, the accelerations found are those of the noise; the margin says so.
#[test]
fn the_margin_tells_accelerations_from_noise() {
    let mean_margin = |scenario: &KinematicsScenario| {
        let margin = |trial| {
            let drawn = simulate_kinematics(scenario, trial).unwrap();
            let found = estimate(Algorithm1So, &scenario.estimators, &drawn.record).unwrap();
            found.acceleration_margin.unwrap()
        };
        (0..40).map(margin).sum::<f64>() / 40.0
    };
    let moving = paper(100);
    let mut constant = paper(100);
    constant.coefficients[2].iter_mut().flatten().for_each(|value| *value = 0.0);
    assert!(mean_margin(&moving) > 2.0, "{}", mean_margin(&moving));
    assert!(mean_margin(&constant) < 1.0, "{}", mean_margin(&constant));
}

#[test]
fn nodes_in_one_point_are_refused_and_two_at_one_point_are_not() {
    let mut together = exact(paper(100));
    together.coefficients[0].iter_mut().for_each(|point| *point = vec![3.0, 4.0]);
    together.coefficients[1].iter_mut().for_each(|point| *point = vec![1.0, 1.0]);
    let error = refusal(Algorithm2So, &together);
    assert!(matches!(error, Error::Degenerate { .. }), "{error}");
    let mut twins = exact(paper(100));
    for points in &mut twins.coefficients {
        points[1] = points[0].clone();
    }
    for name in [Algorithm1Rank1, Algorithm1So, Algorithm2So, Algorithm2Lifted] {
        assert!(error_of(name, &twins).unwrap() < 1e-8, "{name}");
    }
}

#[test]
fn records_without_accelerations_are_refused_alike_by_all_that_read_them() {
    let scenario = paper(20);
    let record = simulate_kinematics(&scenario, 0).unwrap().record.without_accelerometers();
    for name in KinematicsName::ALL {
        let found = estimate(name, &scenario.estimators, &record);
        if !name.reads_accelerations() {
            assert!(found.is_ok(), "{name}");
            continue;
        }
        let error = found.unwrap_err();
        assert!(
            matches!(error, Error::TooFew { counted: "accelerometers", found: 0, needed: 10, .. }),
            "{name}: {error}"
        );
    }
}

#[test]
fn degrees_and_dimensions_that_an_algorithm_does_not_know_are_refused() {
    let mut cubic = random(0, 2, 10, 3);
    assert!(refusal(Algorithm1So, &cubic).to_string().contains("degree"));
    cubic.estimators.degree = 1;
    assert!(refusal(Algorithm2So, &cubic).to_string().contains("degree"));
    for name in [Algorithm1Literal, Algorithm1Rank1, Algorithm2Literal, Algorithm2Rank1] {
        let error = refusal(name, &random(0, 3, 12, 2)).to_string();
        assert!(error.contains("in space"), "{name}: {error}");
    }
}

#[test]
fn records_are_checked() {
    let record = |dimension, nodes, stamps: &[f64], distances: &[f64], sigma| {
        let distances = distances.iter().copied().map(Some).collect();
        DistanceRecord::new(dimension, nodes, stamps.to_vec(), distances, sigma)
    };
    assert!(record(2, 2, &[0.0], &[1.0], 0.1).is_ok());
    assert!(matches!(record(4, 2, &[0.0], &[1.0], 0.1), Err(Error::Number { .. })));
    assert!(matches!(record(2, 3, &[0.0], &[1.0], 0.1), Err(Error::Size { found: 1, expected: 3, .. })));
    assert!(matches!(record(2, 2, &[f64::NAN], &[1.0], 0.1), Err(Error::Number { .. })));
    assert!(matches!(record(2, 2, &[0.0], &[f64::INFINITY], 0.1), Err(Error::Number { .. })));
    assert!(matches!(record(2, 2, &[0.0], &[1.0], -0.1), Err(Error::Number { .. })));
    // No stamp at all, and no node at all.
    for record in [record(2, 5, &[], &[], 0.1).unwrap(), record(2, 0, &[0.0], &[], 0.1).unwrap()] {
        for name in KinematicsName::ALL {
            assert!(estimate(name, &paper(5).estimators, &record).is_err(), "{name}");
        }
    }
}

/// Every estimator on every preset gives an answer or a sentence, and an answer is finite.
#[test]
fn no_preset_ends_in_nan() {
    for preset in &KINEMATICS_PRESETS {
        let scenario = preset.scenario();
        let trial = simulate_kinematics(&scenario, 0).unwrap();
        for name in KinematicsName::ALL {
            let Ok(found) = estimate(name, &scenario.estimators, &trial.record) else { continue };
            assert!(is_finite(&found), "{name}, {}", preset.name);
        }
    }
}
