//! The module of the lab Anchorless, in a browser: the same bits as the native library.
#![cfg(target_arch = "wasm32")]

use rangelab::model::kinematics::presets::{KINEMATICS_PRESETS, kinematics_preset};
use rangelab::study::kinematics::bounds::{KinematicsBounds, NodeQuantity};
use rangelab::study::kinematics::deviations::KinematicsDeviations;
use rangelab::study::kinematics::errors::Yardstick;
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::kinematics::run::run_kinematics;
use rangelab::study::kinematics::spectrum::gram_spectrum;
use rangelab_anchorless::{
    AnchorlessBounds, AnchorlessSum, anchorless_block, anchorless_bounds, anchorless_preset_scenario,
    anchorless_presets, anchorless_spectrum, complete_anchorless, run_anchorless, validate_anchorless,
};
use serde_json::{Value, to_string};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

#[wasm_bindgen_test]
fn presets_and_documents_are_those_of_the_crate() {
    let list: Value = serde_json::from_str(&anchorless_presets()).unwrap();
    assert_eq!(list.as_array().unwrap().len(), KINEMATICS_PRESETS.len());
    for preset in &KINEMATICS_PRESETS {
        let text = anchorless_preset_scenario(preset.name).ok().unwrap();
        assert_eq!(text, preset.scenario().to_json());
        assert_eq!(
            (validate_anchorless(&text), complete_anchorless(&text).ok().unwrap()),
            ("[]".into(), text)
        );
    }
    assert!(anchorless_preset_scenario("nowhere").is_err() && complete_anchorless("{}").is_err());
    let bad = r#"{"version": 1, "coefficients": [[[0, 0], [1]]]}"#;
    let found: Value = serde_json::from_str(&validate_anchorless(bad)).unwrap();
    assert_eq!(found[0]["path"], "coefficients[0][1]");
    assert_eq!(serde_json::from_str::<Value>(&validate_anchorless("no")).unwrap()[0]["path"], "");
}

#[wasm_bindgen_test]
fn a_run_as_arrays_is_the_run_of_the_crate() {
    for name in ["kinematics-sparse", "kinematics-four", "kinematics-space"] {
        let scenario = kinematics_preset(name).unwrap();
        let text = scenario.to_json();
        let run = run_anchorless(&text, 2).ok().unwrap();
        let native = run_kinematics(&scenario, 2).unwrap();
        let deviations = KinematicsDeviations::of(&native).unwrap();
        assert_eq!(to_string(run.document()).unwrap(), to_string(&native).unwrap());
        let size = scenario.steps * scenario.nodes() * scenario.dimension();
        assert_eq!((run.times(), run.truth().len()), (native.instants.clone(), size));
        for (index, estimator) in native.estimators.iter().enumerate() {
            let found = !estimator.coefficients.is_empty();
            assert_eq!(run.errors(index).len(), if found { size } else { 0 });
            assert_eq!(run.position_errors(index), estimator.position_errors);
            let Some(motion) = &deviations.estimators[index].motion else { continue };
            assert_eq!(run.coefficient_error(index, 1), motion.coefficient(1).as_slice());
        }
        let spectrum = anchorless_spectrum(&text, 2).ok().unwrap();
        assert_eq!(spectrum, to_string(&gram_spectrum(&scenario, 2).unwrap()).unwrap());
    }
}

#[wasm_bindgen_test]
fn bounds_are_those_of_the_crate() {
    let scenario = kinematics_preset("kinematics-sparse").unwrap();
    let text = scenario.to_json();
    let native = KinematicsMonteCarlo::new(&scenario, 1).unwrap();
    let own = to_string(&[native.report(&native.start()).bounds]).unwrap();
    assert_eq!(anchorless_bounds(&text, &[]).ok().unwrap(), own);
    assert_eq!(anchorless_bounds(&text, &[10]).ok().unwrap(), own);
    let bounds = AnchorlessBounds::new(&text).ok().unwrap();
    assert_eq!(format!("[{}]", bounds.reports()), own);
    let setup = scenario.setup().unwrap();
    let native = KinematicsBounds::new(&scenario, &setup, &Yardstick::new(&scenario, &setup));
    let expected = |accelerations, quantity| native.node_covariances(accelerations, quantity).unwrap();
    let covariances = bounds.positions(true, 3.0).ok().unwrap();
    assert_eq!(covariances[..4], *expected(true, NodeQuantity::Position(3.0))[0].as_slice());
    assert_eq!(covariances.len(), 4 * scenario.nodes());
    let tip = NodeQuantity::Tip { coefficient: 1, factor: 20.0 };
    let tips = bounds.tips(false, 1, 20.0).ok().unwrap();
    assert_eq!(tips[4..8], *expected(false, tip)[1].as_slice());
    assert!(bounds.tips(false, 3, 1.0).is_err());
    let exact = text.replace("\"sigma_distance\":0.01", "\"sigma_distance\":0.0");
    assert!(exact != text && AnchorlessBounds::new(&exact).ok().unwrap().positions(false, 0.0).is_err());
}

/// Blocks of workers, joined, are the study of the crate, at each number of stamps.
#[wasm_bindgen_test]
fn a_study_in_blocks_is_the_study_of_the_crate() {
    let mut scenario = kinematics_preset("kinematics-sparse").unwrap();
    scenario.steps = 3;
    scenario.estimators.enabled.truncate(2);
    let text = scenario.to_json();
    let counts = [10, 20];
    let mut sum = AnchorlessSum::new(&text, &counts).ok().unwrap();
    let later = anchorless_block(&text, &counts, 20).ok().unwrap();
    assert!(sum.push(&later).is_err(), "the first block is missing");
    assert!(sum.push(&later[..7]).is_err());
    sum.push(&anchorless_block(&text, &counts, 0).ok().unwrap()).ok().unwrap();
    sum.push(&later).ok().unwrap();
    let mut native = KinematicsMonteCarlo::new(&scenario, 40).unwrap().run().unwrap();
    native.bounds.clear();
    let reports: Vec<Value> = serde_json::from_str(&sum.reports().ok().unwrap()).unwrap();
    assert_eq!(reports[0].to_string(), serde_json::to_value(&native).unwrap().to_string());
    assert_eq!((reports[1]["stamps"].as_u64(), reports[1]["trials"].as_u64()), (Some(20), Some(40)));
    let own = anchorless_block(&text, &[], 0).ok().unwrap();
    assert_eq!(own[..], anchorless_block(&text, &[10], 0).ok().unwrap()[..]);
    assert!(anchorless_block(&text, &[], 7).is_err() && anchorless_block(&text, &[0], 0).is_err());
    assert!(AnchorlessSum::new("{}", &[]).is_err());
}
