//! The module of the lab Indoor, in a browser: the same bits as the native library.
#![cfg(target_arch = "wasm32")]

use rangelab::model::indoor::presets::{INDOOR_PRESETS, indoor_preset};
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab_indoor::{
    IndoorSum, complete_indoor, indoor_block, indoor_preset_scenario, indoor_presets, run_indoor,
    validate_indoor,
};
use serde_json::{Value, to_string};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

#[wasm_bindgen_test]
fn presets_and_documents_are_those_of_the_crate() {
    let list: Value = serde_json::from_str(&indoor_presets()).unwrap();
    assert_eq!(list.as_array().unwrap().len(), INDOOR_PRESETS.len());
    for preset in &INDOOR_PRESETS {
        let text = indoor_preset_scenario(preset.name).ok().unwrap();
        assert_eq!(text, preset.scenario().to_json());
        assert_eq!((validate_indoor(&text), complete_indoor(&text).ok().unwrap()), ("[]".into(), text));
    }
    assert!(indoor_preset_scenario("nowhere").is_err() && complete_indoor("{}").is_err());
    let found: Value =
        serde_json::from_str(&validate_indoor(r#"{"version": 1, "imu": {"rate_hz": -1}}"#)).unwrap();
    assert_eq!(found[0]["path"], "imu.rate_hz");
    assert_eq!(serde_json::from_str::<Value>(&validate_indoor("no")).unwrap()[0]["path"], "");
}

#[wasm_bindgen_test]
fn a_run_as_arrays_is_the_run_of_the_crate() {
    let mut scenario = indoor_preset("indoor-u").unwrap();
    scenario.ranging.missing_probability = 0.2;
    let run = run_indoor(&scenario.to_json(), 2).ok().unwrap();
    let native = rangelab::study::indoor::run::run_indoor(&scenario, 2).unwrap();
    assert_eq!(to_string(run.document()).unwrap(), to_string(&native).unwrap());
    let steps = native.times.len();
    for (index, filter) in native.filters.iter().enumerate() {
        let last = filter.steps.last().unwrap();
        assert_eq!(run.positions(index)[3 * (steps - 1)..], last.pose.position);
        assert_eq!(run.singular_values(index)[3 * (steps - 1)..], last.singular_values);
        assert_eq!(run.position_errors(index)[steps - 1].to_bits(), last.position_error.to_bits());
        assert_eq!(run.rotation_covariances(index).len(), 9 * steps);
        assert_eq!((run.failed_at(index), run.failure(index)), (-1, String::new()));
    }
    let (present, fixes) = (run.present(), run.fixes());
    let rows: Vec<&[u8]> = present.chunks(4 * 3).collect();
    assert_eq!(rows.len(), steps);
    assert!(rows.iter().zip(&fixes).all(|(row, fix)| *fix == 1 || row.iter().all(|seen| *seen == 0)));
    let seen: usize = present.iter().map(|seen| usize::from(*seen)).sum();
    assert!((60..120).contains(&seen), "{seen} of 120 ranges, a fifth of which is missing on average");
}

/// Blocks of workers, joined, are the study of the crate.
#[wasm_bindgen_test]
fn a_study_in_blocks_is_the_study_of_the_crate() {
    let scenario = indoor_preset("indoor-u").unwrap();
    let text = scenario.to_json();
    let mut sum = IndoorSum::new(&text).ok().unwrap();
    let later = indoor_block(&text, 20).ok().unwrap();
    assert!(sum.push(&later).is_err(), "the first block is missing");
    assert!(sum.push(&later[..7]).is_err());
    sum.push(&indoor_block(&text, 0).ok().unwrap()).ok().unwrap();
    sum.push(&later).ok().unwrap();
    let native = IndoorMonteCarlo::new(&scenario, 40).unwrap().run().unwrap();
    assert_eq!(sum.report().ok().unwrap(), to_string(&native).unwrap());
    assert!(
        indoor_block(&text, 7).is_err() && indoor_block("{}", 0).is_err() && IndoorSum::new("{}").is_err()
    );
}
