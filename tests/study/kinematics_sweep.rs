//! Sweeps of kinematics scenarios: at each K what a study of that scenario alone finds; rows of numbers that are no block.

use rangelab::Error;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::presets::kinematics_preset;
use rangelab::model::kinematics::settings::KinematicsName::{Algorithm2Rank1, RangePolynomial};
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::kinematics::report::KinematicsReport;
use rangelab::study::kinematics::sweep::{KinematicsSweep, KinematicsSweepBlock};

const TRIALS: usize = 19;

fn scenario() -> KinematicsScenario {
    let mut scenario = kinematics_preset("kinematics-paper").unwrap();
    scenario.estimators.enabled = vec![Algorithm2Rank1, RangePolynomial];
    scenario.steps = 3;
    scenario
}

#[test]
fn each_point_is_the_study_of_its_scenario() {
    // Listed stamps give the sweep their first and last.
    for stamps in [Stamps::default(), Stamps::Listed { times: vec![2.0, -5.0, 5.0] }] {
        let report =
            KinematicsSweep::new(KinematicsScenario { stamps, ..scenario() }, &[10, 30]).unwrap().run(TRIALS);
        let report = report.unwrap();
        assert_eq!((report.trials, report.points.len()), (TRIALS, 2));
        for (point, count) in report.points.iter().zip([10, 30]) {
            let stamps = Stamps::Regular { first: -5.0, last: 5.0, count };
            let scenario = KinematicsScenario { stamps, ..scenario() };
            let alone = KinematicsMonteCarlo::new(&scenario, TRIALS).unwrap().run().unwrap();
            assert_eq!((point.stamps, &point.bounds), (count, &alone.bounds));
            let values = |report: &KinematicsReport| -> Vec<f64> {
                let each = report.estimators.iter().map(|each| &each.summary);
                each.flat_map(|it| [&it.coefficients, &it.gram, &it.positions].map(Clone::clone))
                    .flatten()
                    .map(|figure| figure.value)
                    .collect()
            };
            // Other blocks are other sums, of the same numbers.
            let near = |(a, b): (&f64, &f64)| (a / b - 1.0).abs() < 1e-12;
            let (mine, theirs) = (values(point), values(&alone));
            assert!(mine.len() == theirs.len() && mine.iter().zip(&theirs).all(near), "{mine:?} {theirs:?}");
        }
        let [few, many] = [0, 1].map(|k| report.points[k].estimators[0].summary.coefficients[0].value);
        assert!(many < few, "{many} {few}");
    }
}

#[test]
fn what_is_no_block_is_refused() {
    let sweep = KinematicsSweep::new(scenario(), &[10, 20]).unwrap();
    let (first, second) = (sweep.block(TRIALS, 0).unwrap(), sweep.block(TRIALS, 1).unwrap());
    let row = first.to_numbers();
    assert_eq!(KinematicsSweepBlock::from_numbers(&sweep, &row).unwrap(), first);
    assert!(first.clone().merge(&first).is_err() && first.clone().merge(&second).is_ok());
    assert_eq!((first.trials(), second.trials()), (10, 9));
    for end in [0, 1, row.len() - 1] {
        assert!(KinematicsSweepBlock::from_numbers(&sweep, &row[..end]).is_err(), "{end} numbers");
    }
    let longer = [&row[..], &[0.0]].concat();
    assert!(KinematicsSweepBlock::from_numbers(&sweep, &longer).is_err());
    assert!(sweep.blocks(0).is_err() && sweep.blocks(1_000_001).is_err());
    assert!(KinematicsSweep::new(scenario(), &[10, 0]).is_err());
    // More stamps than there is memory for are refused before they are made.
    let stamps = Stamps::Regular { first: -5.0, last: 5.0, count: usize::MAX };
    let endless = KinematicsScenario { stamps: stamps.clone(), ..scenario() };
    assert!(matches!(KinematicsSweep::new(endless, &[10]), Err(Error::Invalid { .. })));
    assert_eq!(stamps.evenly(3).times(), [-5.0, 0.0, 5.0]);
}
