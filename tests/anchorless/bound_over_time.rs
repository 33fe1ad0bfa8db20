//! The bound at many times is the bound at each.

#![allow(clippy::disallowed_methods, reason = "the time of the largest document is measured")]

use std::time::Instant;

use rangelab::bounds::kinematics::{Alignment, KinematicsBound, KinematicsDesign};
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::study::kinematics::bounds::kinematics_bounds;
use rangelab::study::kinematics::errors::Yardstick;

use crate::networks::{motion, paper, random};
use crate::support::{at_most, caught};

const ALIGNMENTS: [Alignment; 2] = [Alignment::AtZero, Alignment::AtEach];

fn bounds(scenario: &KinematicsScenario) -> Vec<KinematicsBound> {
    let stamps = scenario.setup().unwrap().stamps;
    let mut designs = vec![KinematicsDesign::distances(&stamps, &scenario.noise)];
    if scenario.degree() >= 2 {
        designs.push(KinematicsDesign::with_accelerometers(&stamps, &scenario.noise));
    }
    designs.iter().map(|design| KinematicsBound::new(&motion(scenario), design).unwrap()).collect()
}

/// The largest difference to the bound at times that are later by so much, in parts of it.
fn difference(bound: &KinematicsBound, times: &[f64], later: f64) -> f64 {
    let curves = bound.position_rmses(times).unwrap();
    let mut largest = 0.0_f64;
    for (curve, alignment) in curves.iter().zip(ALIGNMENTS) {
        assert_eq!(curve.len(), times.len());
        for (rmse, time) in curve.iter().zip(times) {
            let direct = bound.position_rmse(time + later, alignment).unwrap();
            largest = largest.max((rmse / direct - 1.0).abs());
        }
    }
    largest
}

#[test]
fn it_is_the_bound_at_each() {
    let times: Vec<f64> = (-14..=14).map(|k| 0.5 * f64::from(k)).collect();
    let mut scenarios = vec![paper(20)];
    for dimension in [2, 3] {
        scenarios.extend((1..=4).map(|degree| random(60, dimension, 7, degree)));
    }
    scenarios[3].stamps =
        Stamps::Listed { times: vec![9.0, 3.0, 4.5, 5.0, 8.0, 7.0, 3.1, 6.0, 4.0, 10.0, 8.5] };
    for scenario in &scenarios {
        for bound in bounds(scenario) {
            at_most("the difference", difference(&bound, &times, 0.0), 1e-9);
            caught("another time", difference(&bound, &times, 0.05), 1e-4);
        }
    }
}

/// Positions that vary by far more than they do once they are aligned: what is left is no difference of large numbers.
#[test]
fn a_common_turn_that_is_hardly_seen_costs_no_digits() {
    let mut scenario = paper(20);
    scenario.coefficients[2].iter_mut().flatten().for_each(|value| *value *= 1e-5);
    for bound in bounds(&scenario) {
        let [once, each] = bound.position_rmses(&[5.0]).unwrap();
        println!("{:e} and {:e} m", once[0], each[0]);
        at_most("the difference", difference(&bound, &[-5.0, 1.0, 5.0], 0.0), 1e-7);
    }
}

/// `cargo test --release --test anchorless -- --ignored --nocapture largest_document`
#[test]
#[ignore = "speed is measured in release alone"]
fn the_largest_document_takes_seconds() {
    let mut scenario = random(61, 3, 100, 2);
    scenario.stamps = Stamps::Regular { first: -5.0, last: 5.0, count: 10 };
    scenario.steps = 10_000;
    let setup = scenario.setup().unwrap();
    let start = Instant::now();
    let reports = kinematics_bounds(&scenario, &setup, &Yardstick::new(&scenario, &setup));
    let seconds = start.elapsed().as_secs_f64();
    assert!(
        reports.iter().all(|report| report.aligned_positions.len() == 10_000),
        "{:?}",
        reports[0].failure
    );
    let bound = &bounds(&scenario)[0];
    let start = Instant::now();
    let direct: f64 = ALIGNMENTS.iter().map(|&alignment| bound.position_rmse(2.0, alignment).unwrap()).sum();
    let each = start.elapsed().as_secs_f64();
    println!("{seconds:.1} s; one instant after another {:.0} s ({direct} m)", 2.0 * 10_000.0 * each);
    at_most("seconds", seconds, 60.0);
}
