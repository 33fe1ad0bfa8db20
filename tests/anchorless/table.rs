//! The whole table of the paper's network at 1000 trials: RMSE of a coordinate of `Y_0` (mm), `Y_1` (mm/s), `Y_2` (mm/s^2).

use rangelab::model::kinematics::settings::KinematicsName::{self, *};
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;

use crate::networks::paper;

/// K, estimator, reference.
type Row = (usize, KinematicsName, [f64; 3]);

#[rustfmt::skip]
const ROWS: [Row; 8] = [
    (100, Algorithm1Rank1, [1.61, 72.3, 64.4]),
    (100, Algorithm1So, [1.61, 48.5, 64.3]),
    (100, Algorithm2Rank1, [1.29, 31.6, 1.83]),
    (100, Algorithm2So, [1.29, 23.6, 1.77]),
    (1000, Algorithm1Rank1, [0.511, 20.9, 20.6]),
    (1000, Algorithm1So, [0.511, 14.3, 20.6]),
    (1000, Algorithm2Rank1, [0.407, 10.2, 0.586]),
    (1000, Algorithm2So, [0.407, 7.84, 0.568]),
];

/// Both the reference and these figures are of 1000 trials, each good to 2 or 3 %.
const WITHIN: f64 = 0.05;

#[test]
#[ignore = "1000 trials of all estimators take minutes"]
fn the_table_comes_back() {
    let mut wrong = Vec::new();
    for stamps in [100, 1000] {
        let rows: Vec<&Row> = ROWS.iter().filter(|row| row.0 == stamps).collect();
        let mut scenario = paper(stamps);
        scenario.steps = 3;
        scenario.estimators.enabled = rows.iter().map(|row| row.1).collect();
        let report = KinematicsMonteCarlo::new(&scenario, 1000).unwrap().run().unwrap();
        for (row, found) in rows.iter().zip(&report.estimators) {
            let found = &found.summary.coefficients;
            let (values, errors) =
                ([0, 1, 2].map(|l| 1e3 * found[l].value), [0, 1, 2].map(|l| 1e3 * found[l].standard_error));
            println!("K = {stamps} {}: {values:.4?} +- {errors:.4?}, expected {:?}", row.1, row.2);
            let off = |l: usize| (values[l] / row.2[l] - 1.0).abs() > WITHIN;
            wrong.extend((0..3).filter(|&l| off(l)).map(|l| format!("K = {stamps} {} Y_{l}", row.1)));
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}
