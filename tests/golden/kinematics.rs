//! Every number that each estimator of relative kinematics finds on each preset, and a study, by fingerprint; the browser
//! checks the same file.

use rangelab::model::kinematics::presets::{KINEMATICS_PRESETS, kinematics_preset};
use rangelab::model::kinematics::run::KinematicsEstimatorRun;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::kinematics::run::run_kinematics;

use crate::fingerprint::study_fingerprint;

fn numbers(run: &KinematicsEstimatorRun) -> Vec<f64> {
    let mut numbers: Vec<f64> = run.coefficients.iter().flatten().flatten().copied().collect();
    for errors in
        [&run.coefficient_errors, &run.gram_errors, &run.position_errors, &run.aligned_position_errors]
    {
        numbers.extend(errors);
    }
    numbers.extend(run.snapshots.iter().flatten().flatten().flatten());
    // No margin is negative. A refusal has no numbers but these.
    numbers.extend([run.acceleration_margin.unwrap_or(-1.0), run.iterations as f64]);
    numbers.push(run.failure.as_ref().map_or(0, String::len) as f64);
    numbers
}

/// A line for each estimator on each preset, and one for two blocks of a study, the second cut short.
pub fn kinematics_fingerprints() -> String {
    let mut text = String::new();
    for preset in &KINEMATICS_PRESETS {
        let mut scenario = preset.scenario();
        scenario.estimators.enabled = KinematicsName::ALL.into();
        let run = run_kinematics(&scenario, 0).unwrap();
        text += &study_fingerprint(&format!("{} truth", preset.name), &run.truth.concat().concat());
        for each in &run.estimators {
            text += &study_fingerprint(&format!("{} {}", preset.name, each.name), &numbers(each));
        }
    }
    let mut scenario = kinematics_preset("kinematics-paper").unwrap();
    scenario.stamps = Stamps::Regular { first: -5.0, last: 5.0, count: 20 };
    let study = KinematicsMonteCarlo::new(&scenario, 23).unwrap();
    let mut sum = study.start();
    (0..study.blocks()).for_each(|index| sum.merge(&study.block(index).unwrap()).unwrap());
    text + &study_fingerprint("study of kinematics-paper", &sum.to_numbers())
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn relative_kinematics_give_the_same_bits_as_ever() {
    assert_eq!(kinematics_fingerprints(), include_str!("kinematics.txt"));
}
