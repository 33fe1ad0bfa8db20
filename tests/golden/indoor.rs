//! Every number of a run of each indoor preset, and of a study, by fingerprint; the browser checks the same file.

use rangelab::model::indoor::presets::{INDOOR_PRESETS, indoor_preset};
use rangelab::model::indoor::run::{IndoorFilterRun, IndoorStepRecord};
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::indoor::run::run_indoor;

use crate::fingerprint::study_fingerprint;

fn step(step: &IndoorStepRecord) -> Vec<f64> {
    let matrices =
        step.pose.orientation.iter().chain(&step.position_covariance).chain(&step.rotation_covariance);
    let mut numbers: Vec<f64> = matrices.flatten().copied().collect();
    numbers.extend(&step.pose.position);
    numbers.extend(step.velocity);
    numbers.extend(step.singular_values);
    // No statistic is negative.
    numbers.extend([step.nis.unwrap_or(-1.0), step.position_error, step.angle_error, step.nees]);
    numbers.extend([step.repairs as f64, f64::from(u8::from(step.reflected))]);
    numbers
}

fn filter(run: &IndoorFilterRun) -> Vec<f64> {
    run.steps.iter().flat_map(step).collect()
}

/// A line for each filter of each preset, and one for two blocks of a study, the second cut short.
pub fn indoor_fingerprints() -> String {
    let mut text = String::new();
    for preset in &INDOOR_PRESETS {
        let run = run_indoor(&preset.scenario(), 0).unwrap();
        for each in &run.filters {
            text += &study_fingerprint(&format!("{} {}", preset.name, each.name), &filter(each));
        }
    }
    let scenario = indoor_preset("indoor-delta").unwrap();
    let study = IndoorMonteCarlo::new(&scenario, 23).unwrap();
    let mut sum = study.start();
    (0..study.blocks()).for_each(|index| sum.merge(&study.block(index).unwrap()).unwrap());
    text + &study_fingerprint("study of indoor-delta", &sum.to_numbers())
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn indoor_runs_give_the_same_bits_as_ever() {
    assert_eq!(indoor_fingerprints(), include_str!("indoor.txt"));
}
