//! Geometry that hides something is named: each scene of the suite with its cause, the motion that is not seen, and a
//! finite answer everywhere.

use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::preset;
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::study::exploration::{Exploration, explore};
use serde_json::Value;

/// The room, changed.
fn room(change: impl FnOnce(&mut Scenario)) -> Scenario {
    let mut scenario = preset("room").unwrap();
    scenario.field.form = RangeForm::Raw;
    change(&mut scenario);
    scenario
}

fn anchors(scenario: &mut Scenario, points: &[[f64; 3]]) {
    scenario.anchors = points.iter().map(|point| point.to_vec()).collect();
}

fn explored(scenario: &Scenario) -> Exploration {
    let found = explore(scenario).unwrap();
    let text = serde_json::to_string(&found).unwrap();
    // serde_json writes what is no finite number as null; where a number must stand there is none of these.
    let document: Value = serde_json::from_str(&text).unwrap();
    for list in ["anchor_singular_values", "sensor_singular_values"] {
        assert!(document[list].as_array().unwrap().iter().all(Value::is_number), "{text}");
    }
    assert!(!text.contains("NaN"), "{text}");
    found
}

/// The cause and the words of the sentence.
fn named(scenario: &Scenario, cause: Option<&str>, words: &[&str]) -> Exploration {
    let found = explored(scenario);
    assert_eq!(found.cause, cause, "{}", found.bound.sentence);
    assert_eq!(found.bound.position_sigma.is_some(), cause.is_none());
    for word in words {
        assert!(found.bound.sentence.contains(word), "{word}: {}", found.bound.sentence);
    }
    // Where something is not seen, the first motion has no standard deviation.
    assert_eq!(found.modes[0].standard_deviation.is_none(), cause.is_some(), "{:?}", found.modes[0]);
    found
}

const LINE: [[f64; 3]; 4] = [[0.0, 0.0, 2.0], [2.0, 0.0, 2.0], [5.0, 0.0, 2.0], [8.0, 0.0, 2.0]];
const CEILING: [[f64; 3]; 4] = [[0.0, 0.0, 3.0], [8.0, 0.0, 3.0], [0.0, 6.0, 3.0], [8.0, 6.0, 3.0]];

#[test]
fn collinear_anchors() {
    let scenario = room(|s| anchors(s, &LINE));
    named(&scenario, Some("anchors-on-one-line"), &["4 anchors", "on one line", "turning the body about"]);
    let projected = room(|s| {
        anchors(s, &LINE);
        s.field.form = RangeForm::Projected;
    });
    named(&projected, Some("anchors-on-one-line"), &["on one line"]);
}

#[test]
fn coplanar_anchors_and_the_mirror_pose() {
    let scenario = room(|s| anchors(s, &CEILING));
    let found = named(&scenario, None, &[]);
    let twin = found.twin.expect("anchors in one plane have a mirror image");
    assert!(!twin.proper, "a solid body is not its mirror image: {}", twin.sentence);
    for (m, anchor) in scenario.anchors.iter().enumerate() {
        let setup = scenario.setup::<3>().unwrap();
        for (n, twin) in twin.sensors.iter().enumerate() {
            let distance =
                |s: &[f64]| anchor.iter().zip(s).map(|(a, s)| (a - s) * (a - s)).sum::<f64>().sqrt();
            let sensor = setup.start.act(&setup.model.topology().sensors()[n]);
            let (real, mirrored) = (distance(sensor.as_slice()), distance(twin));
            assert!((real - mirrored).abs() < 1e-12, "range {m} to {n}: {real} and {mirrored}");
        }
    }
    let flat = room(|s| {
        anchors(s, &CEILING);
        s.sensors.iter_mut().for_each(|sensor| sensor[2] = 0.0);
    });
    assert!(explored(&flat).twin.unwrap().proper, "a flat body can be turned over");
    let projected = room(|s| {
        anchors(s, &CEILING);
        s.field.form = RangeForm::Projected;
    });
    let found = named(&projected, Some("anchors-in-one-plane"), &["in one plane", "not seen"]);
    let unseen = found.modes.iter().filter(|mode| mode.standard_deviation.is_none()).count();
    // The tilt of a rigid body is seen through the other two rows of its rotation.
    assert_eq!(unseen, 1, "the height alone: {:?}", found.modes);
    assert!(found.modes[0].shift[2].abs() > 0.999_999, "{:?}", found.modes[0]);
    assert!(explored(&preset("room").unwrap()).twin.is_none());
}

#[test]
fn two_anchors_at_one_place() {
    let scenario = room(|s| s.anchors[1] = s.anchors[0].clone());
    named(&scenario, None, &[]);
    let all = room(|s| s.anchors = vec![vec![1.0, 2.0, 3.0]; 4]);
    named(&all, Some("anchors-at-one-point"), &["at one point"]);
}

#[test]
fn a_sensor_on_an_anchor() {
    let scenario = room(|s| {
        let setup = s.setup::<3>().unwrap();
        s.anchors[0] = setup.start.act(&setup.model.topology().sensors()[0]).as_slice().to_vec();
    });
    named(&scenario, None, &[]);
}

#[test]
fn one_two_and_three_anchors() {
    for count in 1..=3 {
        let scenario = room(|s| {
            s.anchors.truncate(count);
            s.field.form = RangeForm::Projected;
        });
        let words = format!("{count} anchor");
        named(&scenario, Some("too-few-anchors"), &[&words, "at least 4"]);
    }
    for count in 1..=2 {
        let scenario = room(|s| s.anchors.truncate(count));
        named(&scenario, Some("too-few-anchors"), &["at least 3"]);
    }
    let scenario = room(|s| s.anchors.truncate(3));
    named(&scenario, None, &[]);
}

#[test]
fn one_and_two_sensors() {
    for count in 1..=2 {
        let scenario = room(|s| s.sensors.truncate(count));
        let words = format!("{count} sensor");
        named(&scenario, Some("too-few-sensors"), &[&words, "at least 3"]);
    }
}

#[test]
fn collinear_sensors_hide_the_spin_about_their_line() {
    let scenario = room(|s| s.sensors = [-0.5, 0.0, 0.2, 0.5].map(|x| vec![x, 0.0, 0.0]).to_vec());
    let found =
        named(&scenario, Some("sensors-on-one-line"), &["sensors lie on one line", "moves no sensor"]);
    let spin = &found.modes[0].rotation;
    let length = spin.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(spin[0].abs() / length > 0.999_999, "about the line itself: {spin:?}");
    assert!(found.modes[1].standard_deviation.is_some());
}

#[test]
fn no_noise_and_much_noise() {
    let silent = room(|s| s.noise = RangeNoise::Range { sigma: 0.0 });
    assert!(explore(&silent).unwrap_err().to_string().contains("noise.sigma is 0"));
    let loud = room(|s| s.noise = RangeNoise::Range { sigma: 1e9 });
    assert!(named(&loud, None, &[]).bound.position_sigma.unwrap() > 1e8);
}

#[test]
fn a_body_far_away() {
    let scenario = room(|s| s.start.position = vec![1e7, 0.0, 0.0]);
    let found = explored(&scenario);
    assert!(
        found.cause == Some("this-pose") || found.bound.position_sigma.unwrap() > 1.0,
        "{:?}",
        found.cause
    );
}

#[test]
fn ranges_that_cannot_be_measured() {
    let near = room(|s| s.availability.max_ranges = vec![Some(0.01); s.anchors.len()]);
    named(&near, Some("no-ranges"), &["No range"]);
    let few = room(|s| {
        s.availability.max_ranges = vec![Some(0.01); s.anchors.len()];
        s.availability.max_ranges[0] = None;
        s.availability.max_ranges[1] = None;
    });
    let found = named(&few, Some("missing-ranges"), &["ranges are missing"]);
    assert_eq!(found.available.iter().filter(|anchor| anchor.iter().all(|range| *range)).count(), 2);
}

#[test]
fn singular_values_measure_the_clouds() {
    let scenario = room(|s| anchors(s, &LINE));
    let values = explored(&scenario).anchor_singular_values;
    // x = 0, 2, 5, 8 about 3.75: squares 14.0625 + 3.0625 + 1.5625 + 18.0625.
    assert!((values[0] - 36.75_f64.sqrt()).abs() < 1e-12 && values[1] < 1e-12, "{values:?}");
    let rod = room(|s| s.sensors = [-0.5, 0.5].map(|x| vec![x, 0.0, 0.0]).to_vec());
    let values = explored(&rod).sensor_singular_values;
    let expected = [2.0_f64.sqrt(), 0.5_f64.sqrt(), 0.0, 0.0];
    assert!(values.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{values:?}");
}
