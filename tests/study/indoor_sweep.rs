//! Sweeps of indoor scenarios: at each point what a study of that scenario alone finds; rows of numbers that are no block.

use rangelab::model::indoor::filter_settings::FilterName::{Ekf, Mekf};
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::indoor::sweep::{IndoorSweep, SweepBlock, Swept};

const TRIALS: usize = 9;

fn sweep(swept: Swept, points: &[f64]) -> IndoorSweep {
    let mut scenario = indoor_preset("indoor-bridge").unwrap();
    scenario.filters.enabled = vec![Ekf, Mekf];
    IndoorSweep::new(scenario, swept, points.to_vec())
}

#[test]
fn each_point_is_the_study_of_its_scenario() {
    for sweep in [sweep(Swept::Accuracy, &[0.0, 20.0, 40.0]), sweep(Swept::ImuRate, &[5.0, 20.0])] {
        let report = sweep.run(TRIALS).unwrap();
        let mut found = Vec::new();
        for (index, point) in report.points.iter().enumerate() {
            let alone = IndoorMonteCarlo::new(&sweep.at(*point), TRIALS).unwrap().run().unwrap();
            for (filter, alone) in report.filters.iter().zip(&alone.filters) {
                let (mine, theirs) = (&filter.points[index], &alone.summary);
                assert_eq!((mine.position, mine.angle), (theirs.position, theirs.angle), "{point}");
                assert_eq!(mine.position_distribution, theirs.position_distribution);
                assert!((mine.nees.value / theirs.nees.value - 1.0).abs() < 1e-12);
                assert_eq!((mine.trials, mine.failures, mine.steps.len()), (TRIALS, 0, 0));
                found.push(mine.position.value);
            }
        }
        found.sort_by(f64::total_cmp);
        assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "points and filters differ: {found:?}");
    }
}

#[test]
fn what_is_no_block_is_refused() {
    let sweep = sweep(Swept::Accuracy, &[0.0, 20.0]);
    let (first, second) = (sweep.block(TRIALS, 0).unwrap(), sweep.block(TRIALS, 1).unwrap());
    let row = first.to_numbers();
    assert_eq!(SweepBlock::from_numbers(&sweep, &row).unwrap(), first);
    assert!(first.clone().merge(&first).is_err() && first.clone().merge(&second).is_ok());
    for end in [0, 1, row.len() - 1] {
        assert!(SweepBlock::from_numbers(&sweep, &row[..end]).is_err(), "{end} numbers");
    }
    let longer = [&row[..], &[0.0]].concat();
    assert!(SweepBlock::from_numbers(&sweep, &longer).is_err());
    assert!(sweep.blocks(0).is_err() && sweep.blocks(1_000_001).is_err());
    let (fast, backwards) = (self::sweep(Swept::ImuRate, &[1e9]), self::sweep(Swept::ImuRate, &[-1.0]));
    assert!(fast.blocks(1).is_err() && backwards.blocks(1).is_err());
}
