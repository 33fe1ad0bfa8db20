//! Without noise every estimator finds the motion, of any degree, in the plane and in space.

use rangelab::anchorless::estimate;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::{exact, paper, random, relative_error};
use crate::support::{at_most, caught};

const DISTANCES: [KinematicsName; 3] =
    [KinematicsName::SnapshotSync, KinematicsName::MaximumLikelihood, KinematicsName::MaximumLikelihoodFull];
const ACCELERATIONS: [KinematicsName; 2] =
    [KinematicsName::MaximumLikelihoodAccelerometers, KinematicsName::MaximumLikelihoodAccelerometersFull];
const LIMIT: f64 = 1e-8;

#[track_caller]
fn recovered(scenario: &KinematicsScenario, names: &[KinematicsName]) {
    let trial = simulate_kinematics(scenario, 0).unwrap();
    for &name in names {
        let found = estimate(name, &scenario.estimators, &trial.record)
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        at_most(name.name(), relative_error(&found.kinematics.unwrap(), &trial.truth), LIMIT);
    }
}

#[test]
fn the_papers_network() {
    recovered(&exact(paper(100)), &DISTANCES);
    recovered(&exact(paper(100)), &ACCELERATIONS);
    recovered(&exact(paper(10)), &DISTANCES);
}

#[test]
fn any_degree_in_plane_and_space() {
    for dimension in [2, 3] {
        for degree in [1, 2, 3] {
            let scenario = exact(random(3, dimension, 9, degree));
            recovered(&scenario, &DISTANCES);
            if degree >= 2 {
                recovered(&scenario, &ACCELERATIONS);
            }
        }
    }
}

#[test]
fn uneven_stamps_away_from_zero_and_gaps() {
    let mut scenario = exact(random(4, 3, 9, 2));
    let times = (0..60).map(|k| 2.0 + 8.0 * f64::from(k * k) / (59.0 * 59.0)).collect();
    scenario.stamps = Stamps::Listed { times };
    scenario.noise.missing_probability = 0.3;
    recovered(&scenario, &DISTANCES);
    recovered(&scenario, &ACCELERATIONS);
}

#[test]
fn exact_distances_with_noisy_accelerations_and_the_other_way_round() {
    let mut scenario = exact(paper(50));
    scenario.noise.sigma_acceleration = 0.001;
    let trial = simulate_kinematics(&scenario, 0).unwrap();
    let error = |scenario: &KinematicsScenario, record| {
        let found = estimate(ACCELERATIONS[0], &scenario.estimators, record).unwrap();
        relative_error(&found.kinematics.unwrap(), &trial.truth)
    };
    at_most("exact distances", error(&scenario, &trial.record), 1e-6);
    scenario = exact(paper(50));
    scenario.noise.sigma_distance = 0.01;
    let trial = simulate_kinematics(&scenario, 0).unwrap();
    at_most("exact accelerations", error(&scenario, &trial.record), 1e-2);
}

#[test]
fn too_low_a_degree_is_seen() {
    let mut scenario = exact(paper(100));
    let trial = simulate_kinematics(&scenario, 0).unwrap();
    scenario.estimators.degree = 1;
    let found = estimate(KinematicsName::SnapshotSync, &scenario.estimators, &trial.record).unwrap();
    let found = found.kinematics.unwrap().with_degree(2);
    caught("a degree too low", relative_error(&found, &trial.truth), 1e-2);
}
