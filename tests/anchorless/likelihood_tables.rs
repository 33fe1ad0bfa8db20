//! The tables of an independent program at 1000 trials, and the bound.
//!
//! `cargo test --release --no-default-features --test anchorless -- --ignored --nocapture likelihood_tables`

#![allow(clippy::disallowed_methods, reason = "the time of a trial is printed too")]

use std::time::Instant;

use rangelab::anchorless::estimate;
use rangelab::bounds::kinematics::{KinematicsBound, KinematicsDesign};
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::likelihood::ratios;
use crate::networks::{Rmse, paper, random, squared_errors};
use crate::support::at_most;

const TRIALS: u64 = 1000;

/// K, estimator, RMSE of `Y_0` (mm), `Y_1` (mm/s), `Y_2` (mm/s^2).
const TABLE: [(usize, KinematicsName, [f64; 3]); 9] = [
    (10, KinematicsName::SnapshotSync, [4.15, 81.3, 11.8]),
    (100, KinematicsName::SnapshotSync, [1.35, 32.3, 4.65]),
    (1000, KinematicsName::SnapshotSync, [0.431, 10.4, 1.48]),
    (10, KinematicsName::MaximumLikelihood, [2.40, 37.4, 3.00]),
    (100, KinematicsName::MaximumLikelihood, [0.768, 14.8, 1.17]),
    (1000, KinematicsName::MaximumLikelihood, [0.239, 4.91, 0.383]),
    (10, KinematicsName::MaximumLikelihoodAccelerometers, [1.95, 6.22, 0.236]),
    (100, KinematicsName::MaximumLikelihoodAccelerometers, [0.606, 2.02, 0.080]),
    (1000, KinematicsName::MaximumLikelihoodAccelerometers, [0.189, 0.661, 0.0254]),
];

#[test]
#[ignore = "minutes"]
fn the_papers_network() {
    for (k, name, expected) in TABLE {
        let scenario = paper(k);
        let setup = scenario.setup().unwrap();
        let design = if name.reads_accelerations() {
            KinematicsDesign::with_accelerometers(&setup.stamps, &scenario.noise)
        } else {
            KinematicsDesign::distances(&setup.stamps, &scenario.noise)
        };
        let bound = KinematicsBound::new(&setup.motion, &design).unwrap();
        let squares = measured(&scenario, name);
        for l in 0..3 {
            let found = Rmse::of(&squares[l]).over(1e-3);
            let ratio = Rmse::of(&squares[l]).over(bound.coefficient_rmse(l).unwrap());
            println!(
                "  Y{l}: {:.4} +- {:.4} (table {}), over the bound {:.3} +- {:.3}",
                found.value, found.standard_error, expected[l], ratio.value, ratio.standard_error
            );
            // The table has the same spread as this run.
            let spread = 2.0 * core::f64::consts::SQRT_2 * found.standard_error;
            at_most("off the table", (found.value - expected[l]).abs(), 0.05 * expected[l] + spread);
            if name != KinematicsName::SnapshotSync {
                at_most("over the bound", (ratio.value - 1.005).abs(), 0.045 + 3.0 * ratio.standard_error);
            }
        }
    }
}

/// Squared errors of each coefficient in all trials.
fn measured(scenario: &KinematicsScenario, name: KinematicsName) -> [Vec<f64>; 3] {
    let mut squares = [const { Vec::new() }; 3];
    let mut seconds = 0.0;
    for trial in 0..TRIALS {
        let drawn = simulate_kinematics(scenario, trial).unwrap();
        let start = Instant::now();
        let found = estimate(name, &scenario.estimators, &drawn.record).unwrap();
        seconds += start.elapsed().as_secs_f64();
        for (l, square) in squared_errors(&found.kinematics.unwrap(), &drawn.truth).into_iter().enumerate() {
            squares[l].push(square);
        }
    }
    println!("K = {}, {name}: {:.2e} s a trial", scenario.stamps.count(), seconds / TRIALS as f64);
    squares
}

/// N; RMSE of `Y_1` in space, mm/s: snapshots, ML, its bound, ML with accelerometers, its bound. Of other random networks than
/// these, so that only the bound is met, and the order.
#[test]
#[ignore = "minutes"]
fn networks_in_space() {
    for (nodes, table) in [
        (8, [693.0, 26.2, 27.6, 4.72, 4.61]),
        (12, [37.4, 15.3, 15.4, 2.36, 2.32]),
        (20, [21.1, 10.2, 9.9, 1.81, 1.79]),
    ] {
        let mut sums = [0.0; 5];
        let (networks, trials) = (10, 20);
        for seed in 0..networks {
            let scenario = random(100 + seed, 3, nodes, 2);
            let setup = scenario.setup().unwrap();
            let designs = [
                KinematicsDesign::distances(&setup.stamps, &scenario.noise),
                KinematicsDesign::with_accelerometers(&setup.stamps, &scenario.noise),
            ];
            let bounds = designs.map(|design| {
                KinematicsBound::new(&setup.motion, &design).unwrap().coefficient_rmse(1).unwrap()
            });
            let names = [
                KinematicsName::SnapshotSync,
                KinematicsName::MaximumLikelihood,
                KinematicsName::MaximumLikelihoodAccelerometers,
            ];
            for (name, slot) in names.into_iter().zip([0, 1, 3]) {
                let of_bound = ratios(&scenario, name, trials)[1].value;
                let bound = bounds[usize::from(name.reads_accelerations())];
                sums[slot] += of_bound * of_bound * bound * bound;
            }
            sums[2] += bounds[0] * bounds[0];
            sums[4] += bounds[1] * bounds[1];
        }
        let found = sums.map(|sum| 1e3 * (sum / networks as f64).sqrt());
        println!("D = 3, N = {nodes}: {found:.2?} (another program, other networks: {table:?})");
        // 200 trials: a standard error of 5 % at most, for errors along one direction.
        at_most("ML", (found[1] / found[2] - 1.0).abs(), 0.2);
        at_most("ML with accelerometers", (found[3] / found[4] - 1.0).abs(), 0.2);
        assert!(found[0] > found[2], "snapshots below the bound");
    }
}
