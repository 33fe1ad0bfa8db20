//! Studies in blocks.

use rangelab::Error;
use rangelab::model::kinematics::settings::KinematicsName::*;
use rangelab::study::kinematics::block::KinematicsBlock;
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::kinematics::run::run_kinematics;

use crate::networks::paper;

#[test]
fn blocks_join_in_their_order_and_travel_as_numbers() {
    let mut scenario = paper(10);
    scenario.steps = 3;
    scenario.estimators.enabled = vec![Algorithm1So, MultidimensionalScaling, RangePolynomial];
    let study = KinematicsMonteCarlo::new(&scenario, 45).unwrap();
    let whole = study.run().unwrap();
    assert_eq!((study.blocks(), whole.trials), (3, 45));
    let mut sum = study.start();
    let blocks: Vec<KinematicsBlock> = [2, 0, 1].map(|index| study.block(index).unwrap()).into();
    assert!(matches!(sum.merge(&blocks[0]), Err(Error::Size { .. })));
    for index in [1, 2, 0] {
        let numbers = blocks[index].to_numbers();
        sum.merge(&KinematicsBlock::from_numbers(&scenario, &numbers).unwrap()).unwrap();
        assert!(KinematicsBlock::from_numbers(&scenario, &numbers[1..]).is_err());
    }
    assert_eq!(study.report(&sum), whole);
    let [motion, epochs, ranges] = [0, 1, 2].map(|index| &whole.estimators[index].summary);
    assert_eq!((motion.coefficients.len(), motion.gram.len(), motion.positions.len()), (3, 3, 3));
    assert_eq!((epochs.coefficients.len(), epochs.gram.len(), epochs.aligned_positions.len()), (0, 0, 3));
    assert_eq!((ranges.coefficients.len(), ranges.gram.len(), ranges.positions.len()), (0, 3, 0));
    assert_eq!(motion.velocity_distribution.len(), 45);
    assert!(motion.velocity_distribution.is_sorted());
    let [distances, accelerations] = [0, 1].map(|index| &whole.bounds[index]);
    assert!(!distances.accelerations && accelerations.accelerations);
    assert_eq!((distances.coefficients.len(), distances.gram.len(), distances.positions.len()), (3, 3, 3));
    for l in 0..3 {
        assert!(accelerations.coefficients[l] < distances.coefficients[l]);
        assert!(distances.coefficients[l] < motion.coefficients[l].value);
    }
}

/// One trial's study is its run.
#[test]
fn a_study_of_one_trial_is_the_run() {
    let mut scenario = paper(20);
    scenario.estimators.enabled = vec![Algorithm2Rank1];
    let run = run_kinematics(&scenario, 0).unwrap();
    let report = KinematicsMonteCarlo::new(&scenario, 1).unwrap().run().unwrap();
    let values = |estimates: &[rangelab::study::moments::Estimate]| {
        estimates.iter().map(|each| each.value).collect::<Vec<f64>>()
    };
    let (run, summary) = (&run.estimators[0], &report.estimators[0].summary);
    assert_eq!(values(&summary.coefficients), run.coefficient_errors);
    assert_eq!(values(&summary.gram), run.gram_errors);
    assert_eq!(values(&summary.positions), run.position_errors);
    assert_eq!(values(&summary.aligned_positions), run.aligned_position_errors);
}

/// A fit of degree 0 has no `B_1`: no error is said, least of all none.
#[test]
fn what_is_not_measured_has_no_error() {
    let mut scenario = paper(10);
    scenario.steps = 3;
    scenario.estimators.degree = 0;
    scenario.estimators.enabled = vec![SnapshotSync, MultidimensionalScaling];
    let report = KinematicsMonteCarlo::new(&scenario, 2).unwrap().run().unwrap();
    let [motion, epochs] = [0, 1].map(|index| &report.estimators[index].summary);
    assert_eq!((motion.failures, motion.gram.len(), epochs.gram.len()), (0, 1, 0));
    let all = [&motion.coefficients, &motion.gram, &motion.positions, &motion.aligned_positions];
    assert!(all.into_iter().flatten().all(|error| error.value > 0.0), "{motion:?}");
}

#[test]
fn estimators_that_refuse_are_counted() {
    let mut scenario = paper(4);
    scenario.estimators.enabled = vec![Algorithm1So, Algorithm2So];
    let report = KinematicsMonteCarlo::new(&scenario, 5).unwrap().run().unwrap();
    let [first, second] = [0, 1].map(|index| &report.estimators[index].summary);
    assert_eq!((first.trials, first.failures, first.coefficients.len()), (0, 5, 0));
    assert_eq!((second.trials, second.failures, second.coefficients.len()), (5, 0, 3));
    assert!(KinematicsMonteCarlo::new(&scenario, 0).is_err());
    // Exact distances have no bound, and it says so.
    scenario.noise.sigma_distance = 0.0;
    let bounds = KinematicsMonteCarlo::new(&scenario, 1).unwrap().run().unwrap().bounds;
    assert!(bounds.iter().all(|bound| bound.failure.is_some() && bound.coefficients.is_empty()));
}
