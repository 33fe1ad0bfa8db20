//! How many nodes and stamps each needs, and what is said of fewer.

use rangelab::Error;
use rangelab::anchorless::estimate;
use rangelab::anchorless::maximum_likelihood::{Detail, refined};
use rangelab::bounds::kinematics::{KinematicsBound, KinematicsDesign};
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::{exact, motion, random, relative_error};
use crate::support::at_most;

const FROM_SNAPSHOTS: [KinematicsName; 3] = [
    KinematicsName::SnapshotSync,
    KinematicsName::MaximumLikelihood,
    KinematicsName::MaximumLikelihoodAccelerometers,
];

#[test]
fn snapshots_need_two_nodes_more_than_dimensions() {
    for dimension in [2, 3] {
        for name in FROM_SNAPSHOTS {
            let scenario = exact(random(11, dimension, dimension + 2, 2));
            let trial = simulate_kinematics(&scenario, 0).unwrap();
            let found = estimate(name, &scenario.estimators, &trial.record).unwrap();
            // With as few nodes as can be, the frames of the snapshots are poorly determined.
            let limit = if name == KinematicsName::SnapshotSync { 1e-4 } else { 1e-8 };
            at_most(name.name(), relative_error(&found.kinematics.unwrap(), &trial.truth), limit);
            let fewer = random(11, dimension, dimension + 1, 2);
            let record = simulate_kinematics(&fewer, 0).unwrap().record;
            let Err(Error::TooFew { found, needed, .. }) = estimate(name, &fewer.estimators, &record) else {
                panic!("{name} takes {} nodes", dimension + 1);
            };
            assert_eq!((found, needed), (dimension + 1, dimension + 2));
        }
    }
}

#[test]
fn five_different_stamps() {
    for name in FROM_SNAPSHOTS {
        let mut scenario = random(12, 2, 6, 2);
        scenario.stamps = Stamps::Listed { times: vec![0.0, 1.0, 2.0, 3.0, 3.0] };
        let record = simulate_kinematics(&scenario, 0).unwrap().record;
        let Err(Error::TooFew { found, needed, .. }) = estimate(name, &scenario.estimators, &record) else {
            panic!("{name} takes four stamps");
        };
        assert_eq!((found, needed), (4, 5));
        scenario.stamps = Stamps::Listed { times: vec![0.0, 1.0, 2.0, 3.0, 4.0] };
        let record = simulate_kinematics(&scenario, 0).unwrap().record;
        estimate(name, &scenario.estimators, &record).unwrap();
    }
}

/// As many nodes as dimensions show the motion locally, which is what a bound and a descent from nearby ask for.
#[test]
fn as_many_nodes_as_dimensions_determine_the_motion_locally() {
    for dimension in [2, 3] {
        for seed in 0..5 {
            let scenario = exact(random(20 + seed, dimension, dimension, 2));
            let mut noise = scenario.noise;
            noise.sigma_distance = 0.01;
            let design = KinematicsDesign::distances(&scenario.setup().unwrap().stamps, &noise);
            KinematicsBound::new(&motion(&scenario), &design).unwrap();
            let trial = simulate_kinematics(&scenario, 0).unwrap();
            let nudged = trial.truth.coefficients().iter().map(|y| y.map(|value| value * 1.0001)).collect();
            let start = rangelab::model::kinematics::coefficients::RelativeKinematics::new(nudged).unwrap();
            let found = refined(&trial.record.without_accelerometers(), &start, Detail::Every).unwrap();
            at_most("from nearby", relative_error(&found.kinematics.unwrap(), &trial.truth), 1e-6);
        }
    }
}

#[test]
fn fewer_nodes_do_not() {
    let scenario = random(30, 3, 2, 2);
    let design = KinematicsDesign::distances(&scenario.setup().unwrap().stamps, &scenario.noise);
    let bound = KinematicsBound::new(&motion(&scenario), &design);
    assert!(matches!(bound, Err(Error::Degenerate { .. })), "{bound:?}");
}

#[test]
fn accelerations_are_asked_for_and_have_to_be_there() {
    let scenario = random(13, 2, 6, 1);
    let name = KinematicsName::MaximumLikelihoodAccelerometers;
    let record = simulate_kinematics(&scenario, 0).unwrap().record;
    assert!(matches!(estimate(name, &scenario.estimators, &record), Err(Error::Number { value: 1.0, .. })));
    let bare = record.without_accelerometers();
    assert!(matches!(estimate(name, &scenario.estimators, &bare), Err(Error::TooFew { found: 0, .. })));
}
