//! `rangelab anchorless`: one trial and many, and what is refused.

use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::presets::{KINEMATICS_PRESETS, kinematics_preset};
use rangelab::model::kinematics::run::KinematicsRun;
use rangelab::model::kinematics::settings::KinematicsName::{Algorithm1Rank1, MaximumLikelihood};
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::kinematics::report::KinematicsReport;
use rangelab::study::kinematics::run::run_kinematics;
use rangelab::study::moments::Estimate;

use crate::command::{rangelab, rangelab_with};

fn shown(value: f64) -> String {
    Estimate { value, standard_error: 0.0 }.to_string()
}

#[test]
fn one_trial_is_what_the_crate_finds() {
    let run = |format| {
        rangelab(&["anchorless", "run", "kinematics-sparse", "--trial", "3", "--format", format]).data()
    };
    let scenario = kinematics_preset("kinematics-sparse").unwrap();
    let expected = run_kinematics(&scenario, 3).unwrap();
    assert_eq!(serde_json::from_str::<KinematicsRun>(&run("json")).unwrap(), expected);
    let (table, csv) = (run("table"), run("csv"));
    assert!(table.starts_with("kinematics-sparse: 10 nodes, 10 stamps\n"), "{table}");
    for estimator in &expected.estimators {
        let line = table.lines().find(|line| line.starts_with(&format!("{}  ", estimator.label))).unwrap();
        let last = estimator.position_errors.last().unwrap();
        for error in estimator.coefficient_errors.iter().chain([last]) {
            assert!(line.contains(&shown(*error)), "{error}: {line}");
        }
    }
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
    // Three coefficients of the motion, three of the Gram matrix, positions twice; five estimators and two bounds.
    assert_eq!(rows.len(), 1 + (3 + 3 + 2 * expected.instants.len()) * (expected.estimators.len() + 2));
    let velocity =
        rows.iter().find(|row| row[..4] == ["estimator", "snapshot-sync", "coefficient", "1"]).unwrap();
    let found: f64 = velocity[5].parse().unwrap();
    assert_eq!(found.to_bits(), expected.estimators[2].coefficient_errors[1].to_bits());
}

#[test]
fn a_study_is_the_crates_whatever_the_threads() {
    let study = |threads, format| {
        let names = "algorithm-1-rank1,maximum-likelihood";
        let command = ["anchorless", "study", "kinematics-paper", "--trials", "45", "--stamps", "12"];
        rangelab(&[&command[..], &["--estimators", names, "--threads", threads, "--format", format]].concat())
            .data()
    };
    let mut scenario = kinematics_preset("kinematics-paper").unwrap();
    scenario.estimators.enabled = vec![Algorithm1Rank1, MaximumLikelihood];
    scenario.stamps = scenario.stamps.evenly(12);
    let expected = KinematicsMonteCarlo::new(&scenario, 45).unwrap().run().unwrap();
    assert_eq!(serde_json::from_str::<KinematicsReport>(&study("1", "json")).unwrap(), expected);
    for format in ["json", "csv", "table"] {
        assert_eq!(study("1", format), study("3", format), "{format}");
    }
    let table = study("2", "table");
    let line = |start: &str| table.lines().find(|line| line.starts_with(start)).unwrap();
    let velocity = &expected.estimators[1].summary.coefficients[1];
    assert!(line("ML, distances  ").contains(&velocity.to_string()), "{table}");
    assert!(line("CRB, distances  ").contains(&shown(expected.bounds[0].coefficients[1])), "{table}");
}

#[test]
fn an_estimator_that_cannot_says_why_and_the_others_are_shown() {
    let table = rangelab(&["anchorless", "run", "kinematics-four"]).data();
    let run = run_kinematics(&kinematics_preset("kinematics-four").unwrap(), 0).unwrap();
    let failed: Vec<_> = run.estimators.iter().filter(|each| each.failure.is_some()).collect();
    assert!(!failed.is_empty() && failed.len() < run.estimators.len());
    for estimator in failed {
        let line = table.lines().find(|line| line.starts_with(&format!("{}  ", estimator.label))).unwrap();
        assert!(line.ends_with("no estimate"), "{line}");
        assert!(table.contains(estimator.failure.as_ref().unwrap()), "{table}");
    }
    let exact = ["anchorless", "run", "kinematics-sparse", "--sigma", "0"];
    assert!(rangelab(&exact).data().contains("CRB, distances; CRB, distances and accelerations: "));
    let study =
        rangelab(&["anchorless", "study", "kinematics-four", "--trials", "5", "--stamps", "20"]).data();
    let line = study.lines().find(|line| line.starts_with("Algorithm 1, rank one")).unwrap();
    assert!(line.ends_with("  5"), "{line}");
}

#[test]
fn options_replace_what_the_scenario_says() {
    let run = |options: &[&str]| {
        let command =
            ["anchorless", "run", "kinematics-sparse", "--estimators", "algorithm-2-so", "--format", "csv"];
        rangelab(&[&command[..], options].concat()).data()
    };
    let plain = run(&[]);
    for options in [["--seed", "9"], ["--stamps", "11"], ["--sigma", "0.5"], ["--trial", "1"]] {
        assert_ne!(run(&options), plain, "{options:?}");
    }
    assert_eq!(run(&["--stamps", "10", "--sigma", "0.01", "--seed", "1"]), plain);
}

#[test]
fn presets_are_listed_written_validated_and_run() {
    let list = rangelab(&["presets"]).data();
    for preset in &KINEMATICS_PRESETS {
        assert!(list.contains(&format!("\n{}  ", preset.name)), "{list}");
        let text = rangelab(&["presets", preset.name]).data();
        assert_eq!(KinematicsScenario::from_json(&text).unwrap(), preset.scenario());
        assert_eq!(
            rangelab_with(&text, &["validate", "-"]).data(),
            "a kinematics scenario without problems\n"
        );
    }
    let text = rangelab(&["presets", "kinematics-four"]).data();
    assert_eq!(
        rangelab_with(&text, &["anchorless", "run", "-"]).data(),
        rangelab(&["anchorless", "run", "kinematics-four"]).data()
    );
}

#[test]
fn what_is_no_kinematics_scenario_is_refused() {
    rangelab(&["anchorless", "run", "kinematics-x"])
        .refused("no kinematics preset is called \"kinematics-x\"; there are: kinematics-paper, ");
    rangelab(&["anchorless", "study", "kinematics-paper", "--trials", "0"])
        .refused("the number of trials is 0");
    rangelab(&["anchorless", "run", "kinematics-paper", "--sigma", "-1"]).refused("noise.sigma_distance");
    rangelab(&["anchorless", "run", "kinematics-paper", "--stamps", "0"]).refused("stamps.count");
    rangelab(&["presets", "kinematics-x"]).refused("there are: kinematics-paper, ");
    let outcome =
        rangelab_with(r#"{"version": 1, "coefficients": [[[0, 0]]], "steps": 0}"#, &["validate", "-"]);
    assert!(
        outcome.code == 2 && outcome.stderr.contains("the kinematics scenario has 2 problem"),
        "{outcome:?}"
    );
}
