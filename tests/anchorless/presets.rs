//! Each summary of a preset says what its figures say.

use rangelab::model::kinematics::presets::KINEMATICS_PRESETS;
use rangelab::model::kinematics::settings::KinematicsName::{self, *};
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::kinematics::report::{KinematicsReport, KinematicsSummary};
use rangelab::study::kinematics::run::run_kinematics;

const TRIALS: usize = 30;

#[track_caller]
fn of(report: &KinematicsReport, name: KinematicsName) -> &KinematicsSummary {
    let found = report.estimators.iter().find(|each| each.name == name);
    &found.unwrap_or_else(|| panic!("{} does not run {name}", report.name)).summary
}

/// Those that give nothing; all others give an answer in each trial. With a fifth of 45 distances missing an epoch is complete
/// in one trial of 200.
fn ended(report: &KinematicsReport) -> Vec<KinematicsName> {
    let failed = report.estimators.iter().filter(|each| each.summary.failures > 0);
    failed.inspect(|each| assert!(each.summary.trials <= 2, "{}", each.name)).map(|each| each.name).collect()
}

#[test]
fn presets_teach_what_they_say() {
    for preset in &KINEMATICS_PRESETS {
        let mut scenario = preset.scenario();
        scenario.steps = 3;
        let report = KinematicsMonteCarlo::new(&scenario, TRIALS).unwrap().run().unwrap();
        // Root mean square error of a velocity, m/s; those of the nodes are about 5 m/s.
        let velocity = |name| of(&report, name).coefficients[1].value;
        let ended = || ended(&report);
        let right = match preset.name {
            "kinematics-paper" => {
                let (ml, closed) = (velocity(MaximumLikelihood), velocity(Algorithm2Rank1));
                ended().is_empty() && ml < 0.7 * closed
            }
            "kinematics-sparse" => {
                let (ml, closed) = (velocity(MaximumLikelihood), velocity(Algorithm1Rank1));
                ended().is_empty() && ml < 0.3 * closed && ml < 0.1
            }
            "kinematics-missing" => ended() == [MultidimensionalScaling],
            "kinematics-four" => {
                ended() == [Algorithm1Rank1, Algorithm2Rank1] && velocity(MaximumLikelihood) < 0.1
            }
            "kinematics-constant" => {
                let margin =
                    |trial| run_kinematics(&scenario, trial).unwrap().estimators[0].acceleration_margin;
                let margin = (0..20).filter_map(margin).sum::<f64>() / 20.0;
                ended().is_empty() && margin < 1.0 && velocity(Algorithm1Rank1) > 1.0
            }
            "kinematics-space" => ended() == [Algorithm1Rank1] && velocity(Algorithm1So) < 1.0,
            other => panic!("{other} teaches nothing that is tested"),
        };
        assert!(right, "{}: {}", preset.name, preset.summary);
    }
}
