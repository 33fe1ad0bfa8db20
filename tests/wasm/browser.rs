//! The module that the page loads, in a browser: the same bits as the native library, errors as sentences.
#![cfg(target_arch = "wasm32")]

#[path = "../golden/fingerprint.rs"]
mod fingerprint;

use fingerprint::fingerprints;
use rangelab::model::presets::PRESETS;
use rangelab::model::recording::RecordingDocument;
use rangelab::model::run::Run;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;
use rangelab_wasm::{TrackRun, estimate, preset, presets, track, validate};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

/// The golden file of a preset; a preset without one does not compile.
fn golden(name: &str) -> &'static str {
    match name {
        "room" => include_str!("../golden/room.txt"),
        "tracking-paper" => include_str!("../golden/tracking-paper.txt"),
        "tracking-paper-redrawn" => include_str!("../golden/tracking-paper-redrawn.txt"),
        "planar" => include_str!("../golden/planar.txt"),
        "coplanar-ceiling" => include_str!("../golden/coplanar-ceiling.txt"),
        "three-anchors" => include_str!("../golden/three-anchors.txt"),
        other => panic!("the preset {other} has no golden file here"),
    }
}

fn run_of(name: &str) -> TrackRun {
    track(&preset(name).ok().unwrap(), 0).ok().unwrap()
}

fn sentence<T>(result: Result<T, JsError>) -> String {
    let error = JsValue::from(result.err().expect("an error is thrown"));
    error.dyn_into::<js_sys::Error>().expect("it is an Error").message().into()
}

#[wasm_bindgen_test]
fn every_preset_gives_the_golden_bits() {
    for each in PRESETS {
        let run = Run::from_json(&run_of(each.name).to_json()).unwrap();
        assert_eq!(fingerprints(&run), golden(each.name), "{}", each.name);
    }
}

#[wasm_bindgen_test]
fn presets_have_names_titles_and_sentences() {
    let list: Value = serde_json::from_str(&presets()).unwrap();
    let list = list.as_array().unwrap();
    assert_eq!(list.len(), PRESETS.len());
    for entry in list {
        assert!(["name", "title", "summary"].iter().all(|key| entry[key].is_string()), "{entry}");
        assert_eq!(entry.as_object().unwrap().len(), 3);
    }
    assert!(sentence(preset("moon")).starts_with("no preset is called \"moon\"; there are: room"));
}

#[wasm_bindgen_test]
fn typed_arrays_hold_what_the_document_says() {
    for name in ["planar", "room"] {
        let arrays = run_of(name);
        let run = Run::from_json(&arrays.to_json()).unwrap();
        let (steps, dimension) = (arrays.steps(), arrays.dimension());
        assert_eq!((steps, dimension), (run.times.len(), run.dimension));
        assert_eq!(arrays.anchors(), run.anchors.concat());
        for (e, estimator) in run.estimators.iter().enumerate() {
            assert_eq!(
                (arrays.failed_at(e), arrays.failure(e)),
                (-1, String::new()),
                "{name} {}",
                estimator.label
            );
            let last = estimator.steps.last().unwrap();
            let tail = |numbers: Vec<f64>, width: usize| {
                assert_eq!(numbers.len(), steps * width);
                numbers[(steps - 1) * width..].to_vec()
            };
            let square = dimension * dimension;
            assert_eq!(tail(arrays.orientations(e), square), last.posterior.orientation.concat());
            assert_eq!(tail(arrays.positions(e), dimension), last.posterior.position);
            assert_eq!(tail(arrays.position_covariances(e), square), last.position_covariance.concat());
            let errors = last.errors.unwrap();
            assert_eq!(tail(arrays.orientation_errors(e), 1), [errors.angle]);
            assert_eq!(tail(arrays.position_errors(e), 1), [errors.position]);
            assert_eq!(tail(arrays.defects(e), 1), [last.defect]);
            assert_eq!(tail(arrays.nees(e), 1), [last.nees.unwrap().value]);
            assert_eq!(arrays.events(e)[steps - 1], u8::from(last.event));
        }
        for (b, bound) in run.bounds.iter().enumerate() {
            let record = bound.steps[steps - 1].as_ref().unwrap();
            assert_eq!(arrays.position_bounds(b)[steps - 1..], [record.position_trace.sqrt()]);
            assert_eq!(arrays.orientation_bounds(b)[steps - 1..], [record.angle_variance.unwrap().sqrt()]);
        }
    }
}

#[wasm_bindgen_test]
fn a_recording_gives_what_its_scenario_gives() {
    let scenario = Scenario::from_json(&preset("room").ok().unwrap()).unwrap();
    let recording = RecordingDocument::new(&scenario.name, &simulate::<3>(&scenario, 7).unwrap());
    let settings = serde_json::to_string(&scenario.estimators).unwrap();
    let estimated = estimate(&recording.to_json(), &settings).ok().unwrap();
    assert_eq!(estimated.to_json(), track(&scenario.to_json(), 7).ok().unwrap().to_json());
}

#[wasm_bindgen_test]
fn without_truth_errors_and_bounds_are_not_invented() {
    let scenario = Scenario::from_json(&preset("room").ok().unwrap()).unwrap();
    let mut recording = RecordingDocument::new("log", &simulate::<3>(&scenario, 0).unwrap());
    recording.epochs.iter_mut().for_each(|epoch| epoch.truth = None);
    let run = estimate(&recording.to_json(), r#"{"enabled": ["eskf"]}"#).ok().unwrap();
    assert!(run.orientation_errors(0).iter().all(|x| x.is_nan()));
    assert!(run.truth_positions().iter().all(|x| x.is_nan()));
    assert!(run.positions(0).iter().all(|x| x.is_finite()));
}

#[wasm_bindgen_test]
fn problems_have_paths_and_sentences() {
    let mut scenario: Value = serde_json::from_str(&preset("room").ok().unwrap()).unwrap();
    assert_eq!(validate(&scenario.to_string()), "[]");
    scenario["interval"] = json!(0);
    scenario["anchors"][1][2] = json!(1e12);
    let found: Value = serde_json::from_str(&validate(&scenario.to_string())).unwrap();
    assert_eq!(found[0]["path"], "anchors[1][2]");
    assert_eq!(found[1]["message"], "interval is 0, allowed: above 0 and at most 1e6 s");
    assert!(sentence(track(&scenario.to_string(), 0)).starts_with("the scenario has 2 problem(s)"));
    let found: Value = serde_json::from_str(&validate("{")).unwrap();
    assert!(found[0]["path"] == "" && found[0]["message"].as_str().unwrap().contains("line 1"), "{found}");
}
