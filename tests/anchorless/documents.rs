//! The scenario as a document.

use rangelab::Error;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::presets::{
    DEFAULT_KINEMATICS_PRESET, KINEMATICS_PRESETS, kinematics_preset,
};
use rangelab::model::kinematics::run::KinematicsRun;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::study::kinematics::run::run_kinematics;

#[test]
fn presets_are_valid_and_come_back_from_their_text() {
    for preset in &KINEMATICS_PRESETS {
        let scenario = preset.scenario();
        assert_eq!(scenario.name, preset.name);
        assert_eq!(scenario.validate(), []);
        assert_eq!(KinematicsScenario::from_json(&scenario.to_json()).unwrap(), scenario);
    }
    assert!(kinematics_preset(DEFAULT_KINEMATICS_PRESET).is_ok());
    assert!(matches!(kinematics_preset("nothing"), Err(Error::UnknownName { .. })));
}

#[test]
fn names_are_those_of_the_text() {
    for name in KinematicsName::ALL {
        assert_eq!(serde_json::to_string(&name).unwrap(), format!("\"{name}\""));
        assert_eq!(name.name().parse::<KinematicsName>().unwrap(), name);
    }
    assert!("algorithm-3".parse::<KinematicsName>().is_err());
}

#[test]
fn every_problem_is_told() {
    let text = r#"{"version": 1, "coefficients": [[[0, 0], [1, 2, 3]], [[1e12, 0]]],
        "stamps": {"kind": "regular", "first": 5, "last": -5, "count": 0}, "steps": 0,
        "noise": {"sigma_distance": -1, "missing_probability": 2},
        "estimators": {"degree": 9, "range_degree": 1, "enabled": ["snapshot-sync", "snapshot-sync"]}}"#;
    let Err(Error::Invalid { problems, .. }) = KinematicsScenario::from_json(text) else {
        panic!("accepted")
    };
    let paths: Vec<&str> = problems.iter().map(|problem| problem.path.as_str()).collect();
    let expected = [
        "coefficients[0][1]",
        "coefficients[1]",
        "coefficients[1][0][0]",
        "stamps.last",
        "stamps.count",
        "noise.sigma_distance",
        "noise.missing_probability",
        "estimators.enabled",
        "estimators.degree",
        "estimators.range_degree",
        "steps",
    ];
    assert_eq!(paths, expected);
    for bad in ["[]", "[[]]", "[[[1], [2]]]", "[[[1, 2]]]"] {
        let text = format!(r#"{{"version": 1, "coefficients": {bad}}}"#);
        assert!(matches!(KinematicsScenario::from_json(&text), Err(Error::Invalid { .. })), "{bad}");
    }
    let times = r#"{"version": 1, "coefficients": [[[0, 0], [1, 2]]], "stamps": {"kind": "listed", "times": [0, 1e9]}}"#;
    assert!(KinematicsScenario::from_json(times).unwrap_err().to_string().contains("stamps.times[1]"));
    let unknown = r#"{"version": 1, "coefficients": [[[0, 0], [1, 2]]], "colour": 1}"#;
    assert!(matches!(KinematicsScenario::from_json(unknown), Err(Error::Syntax { .. })));
}

#[test]
fn runs_come_back_from_their_text() {
    for preset in &KINEMATICS_PRESETS {
        let mut scenario = preset.scenario();
        scenario.estimators.enabled = KinematicsName::ALL.into();
        let run = run_kinematics(&scenario, 0).unwrap();
        let back: KinematicsRun = serde_json::from_str(&run.to_json()).unwrap();
        assert_eq!(back, run, "{}", preset.name);
        assert!(run.estimators.iter().any(|each| each.failure.is_none()), "{}", preset.name);
    }
}
