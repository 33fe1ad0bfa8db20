//! The module of the lab Localize, in a browser: the same bits as the native library.
#![cfg(target_arch = "wasm32")]

#[path = "../golden/fingerprint.rs"]
mod fingerprint;

use fingerprint::snapshot_fingerprints;
use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::preset;
use rangelab::model::scenario::Scenario;
use rangelab::study::localization::LocalizationStudy;
use rangelab::study::localization::run::{cloud_stride, localize_trial};
use rangelab_localize::{
    LocalizationSum, localization_block, localization_cloud, localize, localize_at_noise,
};
use serde_json::{Value, to_string};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

const TRIALS: usize = 60;

fn scenario() -> Scenario {
    Scenario { steps: 1, ..preset("room").unwrap() }
}

#[wasm_bindgen_test]
fn snapshot_estimators_give_the_golden_bits() {
    assert_eq!(snapshot_fingerprints(), include_str!("../golden/snapshots.txt"));
}

#[wasm_bindgen_test]
fn one_trial_and_the_cloud_are_those_of_the_crate() {
    let scenario = scenario();
    let run = localize(&scenario.to_json(), 3).ok().unwrap();
    let native = localize_trial(&scenario, 3).unwrap();
    assert_eq!(run, to_string(&native).unwrap());
    let cloud = localization_cloud(&scenario.to_json(), 4).ok().unwrap();
    let row = scenario.localize.enabled.len() * cloud_stride(3);
    assert_eq!(cloud.len(), 4 * row);
    let last = &cloud[3 * row..];
    for (numbers, estimate) in last.chunks(cloud_stride(3)).zip(&native.estimators) {
        let Some(pose) = &estimate.pose else {
            assert!(numbers.iter().all(|x| *x == 0.0));
            continue;
        };
        let (flags, errors) = numbers.split_at(3);
        assert_eq!(flags, [1.0, f64::from(u8::from(estimate.reflected)), estimate.iterations as f64]);
        let (turned, moved) = errors.split_at(9);
        for row in 0..3 {
            let error = pose.position[row] - native.truth.position[row];
            assert_eq!(moved[row].to_bits(), error.to_bits());
            for column in 0..3 {
                let products = pose.orientation[row].iter().zip(&native.truth.orientation[column]);
                let entry: f64 = products.map(|(a, b)| a * b).sum();
                assert!((turned[3 * row + column] - entry).abs() < 1e-14, "row by row");
            }
        }
    }
    assert!(localize("{}", 0).is_err() && localization_cloud("{}", 1).is_err());
}

/// Blocks of workers, joined, are the study of the crate; so are the averages at the scenario's own noise.
#[wasm_bindgen_test]
fn a_sweep_in_blocks_is_the_study_of_the_crate() {
    let scenario = scenario();
    let (text, points) = (scenario.to_json(), [0.1, 0.01].map(|sigma| RangeNoise::Range { sigma }));
    let sweep = to_string(&points).unwrap();
    let mut sum = LocalizationSum::new(&text, &sweep).ok().unwrap();
    let later = localization_block(&text, &sweep, 50, TRIALS - 50).ok().unwrap();
    assert!(sum.push(&later).is_err(), "the first block is missing");
    assert!(sum.push(&later[..7]).is_err());
    sum.push(&localization_block(&text, &sweep, 0, 50).ok().unwrap()).ok().unwrap();
    sum.push(&later).ok().unwrap();
    let native = LocalizationStudy::new(&scenario, points.to_vec(), TRIALS).unwrap().run().unwrap();
    assert_eq!(sum.report().ok().unwrap(), to_string(&native).unwrap());
    let own = LocalizationStudy::new(&scenario, vec![scenario.noise], TRIALS).unwrap().run().unwrap();
    assert_eq!(localize_at_noise(&text, TRIALS).ok().unwrap(), to_string(&own).unwrap());
    assert!(localization_block(&text, &sweep, 7, 10).is_err());
    assert!(
        localization_block(&text, "[1]", 0, 10).is_err() && localization_block(&text, &sweep, 0, 0).is_err()
    );
    assert!(localize_at_noise(&text, 0).is_err());
    let document: Value = serde_json::from_str(&sum.report().ok().unwrap()).unwrap();
    assert_eq!(document["trials"], TRIALS);
}
