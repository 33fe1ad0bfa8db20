//! Recordings.

use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::recording::RecordingDocument;
use rangelab::model::scenario::{Scenario, WeightSource};
use rangelab::simulate::simulate;
use rangelab::{Error, with_dimension};
use serde_json::{Value, json};

use super::{Rule, as_value, breaks_only, problems_of};

/// Every preset, with and without true weights, missing ranges and displaced sensors.
fn scenarios() -> Vec<Scenario> {
    let mut all = Vec::new();
    for each in PRESETS {
        for weights in [WeightSource::Measured, WeightSource::True] {
            for missing_probability in [0.0, 0.3] {
                all.push(Scenario { weights, missing_probability, ..each.scenario() });
            }
            all.push(Scenario { weights, mounting_sigma: 0.02, ..each.scenario() });
        }
    }
    all
}

fn survives<const D: usize>(scenario: &Scenario) -> Result<(), Error> {
    let recording = simulate::<D>(scenario, 3)?;
    let document = RecordingDocument::new(&scenario.name, &recording);
    let read = RecordingDocument::from_json(&document.to_json())?;
    assert_eq!(read, document);
    assert!(read.recording::<D>()? == recording, "{}: the recording changed", scenario.name);
    Ok(())
}

#[test]
fn recordings_survive_json_to_the_bit() {
    for scenario in scenarios() {
        with_dimension!(scenario.dimension, D => survives::<D>(&scenario)).unwrap();
    }
}

fn recording_value() -> Value {
    let mut scenario = preset("planar").unwrap();
    scenario.steps = 3;
    as_value(&RecordingDocument::new("three epochs", &simulate::<2>(&scenario, 0).unwrap()).to_json())
}

#[test]
fn every_rule_of_a_recording_can_be_broken() {
    let rules: Vec<Rule> = vec![
        ("/version", json!(0), "version", "0"),
        ("/name", json!("x".repeat(201)), "name", "201 bytes"),
        ("/dimension", json!(7), "dimension", "7"),
        ("/anchors/1", json!([1, 2, 3]), "anchors[1]", "3 long"),
        ("/sensors/0/0", json!(1e10), "sensors[0][0]", "1e10"),
        ("/noise/sigma", json!(0), "noise.sigma", "0"),
        ("/initial/covariance", json!(-1), "initial.covariance", "-1"),
        ("/process/sigma_q", json!(-1), "process.sigma_q", "-1"),
        ("/epochs", json!([]), "epochs", "0 long"),
        ("/epochs/1/interval", json!(0), "epochs[1].interval", "0"),
        ("/epochs/1/velocity", json!([1]), "epochs[1].velocity", "1 long"),
        ("/epochs/1/angular_velocity", json!([1, 2]), "epochs[1].angular_velocity", "2 long"),
        ("/epochs/1/squared_ranges/3", json!([1]), "epochs[1].squared_ranges[3]", "1 long"),
        ("/epochs/1/squared_ranges", json!([]), "epochs[1].squared_ranges", "0 rows"),
        ("/epochs/1/squared_ranges/3/2", json!(1e30), "epochs[1].squared_ranges[3][2]", "1e30"),
        ("/epochs/1/squared_ranges", json!(null), "epochs[1]", "without ranges"),
        ("/epochs/1/ranges", json!([]), "epochs[1]", "both"),
        ("/epochs/2/truth/orientation", json!([[1, 0], [0, 2]]), "epochs[2].truth.orientation", "3"),
        ("/epochs/2/truth/position", json!([1]), "epochs[2].truth.position", "1 long"),
    ];
    let document = recording_value();
    let read = |text: &str| problems_of(RecordingDocument::from_json(text));
    breaks_only(&document, &rules, read);

    let mut unknown_truth = document.clone();
    unknown_truth["weights"] = json!("true");
    breaks_only(&unknown_truth, &[("/epochs/2/truth", json!(null), "epochs[2].truth", "missing")], read);
    let mut long = document.clone();
    long["epochs"] = Value::Array(vec![document["epochs"][0].clone(); 10_001]);
    assert_eq!(read(&long.to_string())[0].path, "epochs");
}

#[test]
fn ranges_are_squared_and_must_not_be_negative() {
    let mut document = recording_value();
    let epoch = document["epochs"][1].as_object_mut().unwrap();
    epoch.remove("squared_ranges");
    epoch.insert("ranges".into(), json!([[1, 2, 3], [4, null, 6], [7, 8, 9], [1, 1, 1.5]]));
    let recording = RecordingDocument::from_json(&document.to_string()).unwrap().recording::<2>().unwrap();
    let ranges = &recording.epochs[1].ranges;
    assert_eq!((ranges.get(1, 2), ranges.get(1, 1), ranges.get(3, 2)), (Some(36.0), None, Some(2.25)));
    // The usual mark of a missing range in a log file must not pass as 1 m^2.
    let rule = ("/epochs/1/ranges/1/1", json!(-1), "epochs[1].ranges[1][1]", "-1");
    breaks_only(&document, &[rule], |text| problems_of(RecordingDocument::from_json(text)));
}

#[test]
fn a_recording_without_truth_or_motion_is_read() {
    let mut document = recording_value();
    for epoch in document["epochs"].as_array_mut().unwrap() {
        for key in ["truth", "velocity", "angular_velocity"] {
            epoch.as_object_mut().unwrap().remove(key);
        }
    }
    let recording = RecordingDocument::from_json(&document.to_string()).unwrap().recording::<2>().unwrap();
    assert_eq!(recording.truth, [None; 3]);
    assert!(recording.epochs.iter().all(|epoch| epoch.motion.velocity == nalgebra::Vector2::zeros()));
}
