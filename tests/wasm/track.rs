//! The module that the page starts with, in a browser: the same bits as the native library, errors as sentences.
#![cfg(target_arch = "wasm32")]

#[path = "../golden/fingerprint.rs"]
mod fingerprint;

use fingerprint::{fingerprints, study_fingerprint};
use rangelab::math::rotation::rotation_angles;
use rangelab::model::presets::PRESETS;
use rangelab::model::recording::RecordingDocument;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;
use rangelab::study::moments::Estimate;
use rangelab::study::monte_carlo::MonteCarlo;
use rangelab::study::track_run::run_document;
use rangelab_track::{
    StudySum, TrackRun, chi_squared_interval, complete, preset, presets, study_block, track, validate,
};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

/// The golden file of a preset; a preset without one does not compile.
fn golden(name: &str) -> &'static str {
    match name {
        "room" => include_str!("../golden/room.txt"),
        "planar" => include_str!("../golden/planar.txt"),
        "figure-eight" => include_str!("../golden/figure-eight.txt"),
        "towers" => include_str!("../golden/towers.txt"),
        "corridor" => include_str!("../golden/corridor.txt"),
        "coplanar-ceiling" => include_str!("../golden/coplanar-ceiling.txt"),
        "three-anchors" => include_str!("../golden/three-anchors.txt"),
        "mirrored" => include_str!("../golden/mirrored.txt"),
        "missing-ranges" => include_str!("../golden/missing-ranges.txt"),
        "small-body" => include_str!("../golden/small-body.txt"),
        "rod" => include_str!("../golden/rod.txt"),
        "overconfident" => include_str!("../golden/overconfident.txt"),
        "wide-prior" => include_str!("../golden/wide-prior.txt"),
        "tracking-paper" => include_str!("../golden/tracking-paper.txt"),
        "tracking-paper-redrawn" => include_str!("../golden/tracking-paper-redrawn.txt"),
        "localization-paper" => include_str!("../golden/localization-paper.txt"),
        "localization-paper-redrawn" => include_str!("../golden/localization-paper-redrawn.txt"),
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
        assert_eq!(fingerprints(run_of(each.name).document()), golden(each.name), "{}", each.name);
    }
}

/// The blocks that workers give are the sums of the native study, bit by bit, and so is what the page joins of them.
#[wasm_bindgen_test]
fn blocks_of_a_study_give_the_golden_bits() {
    let study = |name: &str| {
        let scenario = preset(name).ok().unwrap();
        let mut sum = StudySum::new(&scenario).ok().unwrap();
        let blocks =
            [(0, 20), (20, 7)].map(|(first, trials)| study_block(&scenario, first, trials).ok().unwrap());
        for block in &blocks {
            sum.push(block).ok().unwrap();
        }
        assert_eq!(sum.trials(), 27);
        study_fingerprint(name, &sum.to_numbers())
    };
    assert_eq!(study("planar") + &study("room"), include_str!("../golden/studies.txt"));
}

#[wasm_bindgen_test]
fn a_study_reads_as_curves() {
    let scenario = preset("room").ok().unwrap();
    let mut sum = StudySum::new(&scenario).ok().unwrap();
    assert!(sum.angle(0).iter().all(|x| x.is_nan()), "no trial, no number");
    assert_eq!(sum.bounds(), "[]");
    sum.push(&study_block(&scenario, 0, 40).ok().unwrap()).ok().unwrap();
    let scenario = Scenario::from_json(&scenario).unwrap();
    let study = MonteCarlo::new(&scenario, 40).unwrap();
    let mut native = study.start();
    (0..2).for_each(|index| native.merge(&study.block(index).unwrap()).unwrap());
    let report = study.report(&native);
    let curve = |read: &dyn Fn(usize) -> Estimate| -> Vec<f64> {
        let steps = 0..scenario.steps;
        steps.clone().map(|k| read(k).value).chain(steps.map(|k| read(k).standard_error)).collect()
    };
    for (e, estimator) in report.estimators.iter().enumerate() {
        assert_eq!(sum.angle(e), curve(&|k| estimator.steps[k].rms_angle));
        assert_eq!(sum.position(e), curve(&|k| estimator.steps[k].rmse_position));
        assert_eq!(sum.nees(e), curve(&|k| estimator.steps[k].nees));
        assert_eq!(sum.event_rate(e), curve(&|k| estimator.steps[k].event_rate));
        assert_eq!(sum.nees_degrees_of_freedom(e), estimator.steps[0].nees_degrees_of_freedom);
        assert!(sum.failures(e).iter().all(|failures| *failures == 0));
    }
    for (b, bound) in report.bounds.iter().enumerate() {
        assert_eq!(sum.angle_bound(b), curve(&|k| bound.steps[k].angle));
        assert_eq!(sum.position_bound(b), curve(&|k| bound.steps[k].position));
    }
}

#[wasm_bindgen_test]
fn blocks_out_of_order_or_of_another_scenario_are_refused() {
    let (room, planar) = (preset("room").ok().unwrap(), preset("planar").ok().unwrap());
    let mut sum = StudySum::new(&room).ok().unwrap();
    let later = study_block(&room, 20, 20).ok().unwrap();
    let said = sentence(sum.push(&later));
    assert_eq!(said, "20 trials before the block that is appended where 0 are needed");
    assert!(sentence(sum.push(&study_block(&planar, 0, 20).ok().unwrap())).contains("numbers in a block"));
    assert!(sentence(sum.push(&later[..7])).contains("7 numbers in a block"));
    assert_eq!(sum.trials(), 0);
    assert!(sentence(study_block(&room, 7, 20)).contains("multiple of 20"));
    assert!(sentence(study_block(&room, 20, 0)).contains("number of trials"));
    assert!(sentence(study_block("{}", 0, 20)).contains("version"));
}

#[wasm_bindgen_test]
fn a_scenario_is_completed_or_refused_with_a_sentence() {
    let short = r#"{"version": 1, "dimension": 2, "anchors": [[0, 0], [9, 0], [0, 9]],
        "sensors": [[-0.5, 0], [0.5, 0]], "noise": {"kind": "range", "sigma": 0.05}}"#;
    let full: Value = serde_json::from_str(&complete(short).ok().unwrap()).unwrap();
    assert_eq!((&full["steps"], &full["initial"]["position"]), (&json!(20), &json!([0.0, 0.0])));
    assert_eq!(complete(&full.to_string()).ok().unwrap(), complete(short).ok().unwrap());
    assert!(sentence(complete(r#"{"version": 2}"#)).contains("version 2"));
}

#[wasm_bindgen_test]
fn chi_squared_intervals_pass_the_door() {
    let [low, high] = chi_squared_interval(6.0, 0.95).ok().unwrap()[..] else { panic!("two numbers") };
    assert!((low - 1.237_344_245_791).abs() < 1e-11 && (high - 14.449_375_335_448).abs() < 1e-11);
    assert!(sentence(chi_squared_interval(f64::NAN, 0.95)).contains("degrees of freedom"));
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
        let run = arrays.document();
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
            let nees = last.nees.unwrap();
            assert_eq!(tail(arrays.nees(e), 1), [nees.value]);
            assert_eq!(arrays.nees_degrees_of_freedom(e), nees.degrees_of_freedom);
            let width = rotation_angles(dimension).pow(2);
            let rotation_covariance = last.rotation_covariance.as_ref().unwrap().concat();
            assert_eq!(tail(arrays.rotation_covariances(e), width), rotation_covariance);
            assert_eq!(arrays.events(e)[steps - 1], u8::from(last.event));
        }
    }
}

#[wasm_bindgen_test]
fn typed_arrays_hold_the_bounds_of_the_document() {
    for name in ["planar", "room"] {
        let arrays = run_of(name);
        let run = arrays.document();
        let last = arrays.steps() - 1;
        for (b, bound) in run.bounds.iter().enumerate() {
            let record = bound.steps[last].as_ref().unwrap();
            let covariance = record.rotation_covariance.as_ref().unwrap().concat();
            assert!(arrays.rotation_bound_covariances(b).ends_with(&covariance));
            assert_eq!(arrays.position_bounds(b)[last..], [record.position_trace.sqrt()]);
            assert_eq!(arrays.orientation_bounds(b)[last..], [record.angle_variance.unwrap().sqrt()]);
        }
    }
}

#[wasm_bindgen_test]
fn missing_ranges_are_marked_where_they_are() {
    let mut scenario = Scenario::from_json(&preset("room").ok().unwrap()).unwrap();
    scenario.missing_probability = 0.3;
    let recording = simulate::<3>(&scenario, 0).unwrap();
    let present = track(&scenario.to_json(), 0).ok().unwrap().present();
    let ranges = recording.epochs.iter().flat_map(|epoch| {
        let pairs =
            (0..scenario.anchors.len()).flat_map(|m| (0..scenario.sensors.len()).map(move |n| (m, n)));
        pairs.map(|(m, n)| u8::from(epoch.ranges.get(m, n).is_some()))
    });
    assert_eq!(present, ranges.collect::<Vec<u8>>());
    assert!(present.contains(&0) && present.contains(&1));
}

#[wasm_bindgen_test]
fn the_geometry_names_what_hides() {
    let geometry = |name: &str| -> Value { serde_json::from_str(&run_of(name).geometry()).unwrap() };
    let (room, ceiling) = (geometry("room"), geometry("coplanar-ceiling"));
    assert!(room["unseen"].is_null() && room["anchors"]["plane"]["thickness"].as_f64() > Some(0.1));
    assert!((0.01..0.1).contains(&ceiling["anchors"]["plane"]["thickness"].as_f64().unwrap()), "{ceiling}");
    let three = geometry("three-anchors");
    assert!(three["unseen"].as_str().unwrap().contains("3 anchors"), "{three}");
    assert!(three["anchors"]["plane"]["thickness"].as_f64() < Some(1e-9));
    let plane = geometry("planar");
    assert!(
        plane["sensors"]["plane"].is_null() && plane["sensors"]["line"]["thickness"].as_f64() > Some(0.0)
    );
}

#[wasm_bindgen_test]
fn without_truth_errors_and_bounds_are_not_invented() {
    let scenario = Scenario::from_json(&preset("room").ok().unwrap()).unwrap();
    let mut recording = RecordingDocument::new("log", &simulate::<3>(&scenario, 0).unwrap());
    recording.epochs.iter_mut().for_each(|epoch| epoch.truth = None);
    let run = TrackRun::from(run_document(&recording, &scenario.estimators).unwrap());
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
