//! `rangelab indoor`: one trial and many, and what is refused.

use rangelab::model::indoor::IndoorScenario;
use rangelab::model::indoor::presets::{INDOOR_PRESETS, indoor_preset};
use rangelab::model::indoor::run::IndoorRun;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::indoor::report::IndoorReport;
use rangelab::study::indoor::run::run_indoor;

use crate::command::{rangelab, rangelab_with};

#[test]
fn one_trial_is_what_the_crate_finds() {
    let run =
        |format| rangelab(&["indoor", "run", "indoor-bridge", "--trial", "3", "--format", format]).data();
    let expected = run_indoor(&indoor_preset("indoor-bridge").unwrap(), 3).unwrap();
    assert_eq!(serde_json::from_str::<IndoorRun>(&run("json")).unwrap(), expected);
    let (table, csv) = (run("table"), run("csv"));
    for filter in &expected.filters {
        let line = table.lines().find(|line| line.starts_with(&format!("{}  ", filter.label))).unwrap();
        assert!(line.contains(&format!("{:.4}", filter.rms_position_error())), "{line}");
        assert!(line.contains(&format!("{:.4}", filter.rms_angle_error().to_degrees())), "{line}");
        assert!(line.contains(&format!("{:.4}", filter.mean_nees())), "{line}");
    }
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 1 + expected.filters.len() * expected.times.len());
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
    let last = expected.filters.last().unwrap().steps.last().unwrap();
    let error: f64 = rows.last().unwrap()[6].parse().unwrap();
    assert_eq!(error.to_bits(), last.position_error.to_bits());
}

#[test]
fn a_study_is_the_crates_whatever_the_threads() {
    let study = |threads, format| {
        let command = ["indoor", "study", "indoor-bridge", "--trials", "45", "--filters", "ekf,mekf"];
        rangelab(&[&command[..], &["--threads", threads, "--format", format]].concat()).data()
    };
    let mut scenario = indoor_preset("indoor-bridge").unwrap();
    scenario.filters.enabled = ["ekf", "mekf"].map(|name| name.parse().unwrap()).into();
    let expected = IndoorMonteCarlo::new(&scenario, 45).unwrap().run().unwrap();
    assert_eq!(serde_json::from_str::<IndoorReport>(&study("1", "json")).unwrap(), expected);
    for format in ["json", "csv", "table"] {
        assert_eq!(study("1", format), study("3", format), "{format}");
    }
    assert_eq!(study("2", "csv").lines().count(), 1 + 2 * 50);
    let table = study("2", "table");
    let line = table.lines().find(|line| line.starts_with("MEKF  ")).unwrap();
    assert!(line.contains(&expected.filters[1].summary.position.to_string()), "{line}");
}

#[test]
fn options_replace_what_the_scenario_says() {
    let run = |options: &[&str]| {
        let command = ["indoor", "run", "indoor-bridge", "--filters", "ekf-rie", "--format", "csv"];
        rangelab(&[&command[..], options].concat()).data()
    };
    let plain = run(&[]);
    for options in [["--seed", "9"], ["--convention", "disc"], ["--sigma", "0.5"]] {
        assert_ne!(run(&options), plain, "{options:?}");
    }
    assert_eq!(run(&["--convention", "sample", "--sigma", "0.1", "--seed", "1"]), plain);
}

#[test]
fn presets_are_listed_written_validated_and_run() {
    let list = rangelab(&["presets"]).data();
    for preset in &INDOOR_PRESETS {
        assert!(list.contains(&format!("\n{}  ", preset.name)), "{list}");
        let text = rangelab(&["presets", preset.name]).data();
        assert_eq!(IndoorScenario::from_json(&text).unwrap(), preset.scenario());
        assert_eq!(rangelab_with(&text, &["validate", "-"]).data(), "an indoor scenario without problems\n");
    }
    let text = rangelab(&["presets", "indoor-zigzag"]).data();
    assert_eq!(
        rangelab_with(&text, &["indoor", "run", "-"]).data(),
        rangelab(&["indoor", "run", "indoor-zigzag"]).data()
    );
}

#[test]
fn what_is_no_indoor_scenario_is_refused() {
    rangelab(&["indoor", "run", "indoor-x"])
        .refused("no indoor preset is called \"indoor-x\"; there are: indoor-u, ");
    rangelab(&["indoor", "study", "indoor-u", "--trials", "0"]).refused("the number of trials is 0");
    rangelab(&["indoor", "run", "indoor-u", "--sigma", "-1"]).refused("ranging.sigma");
    rangelab(&["presets", "indoor-x"]).refused("there are: indoor-u, ");
    let outcome = rangelab_with(r#"{"version": 1, "path": "u", "imu": {"rate_hz": -1}}"#, &["validate", "-"]);
    assert!(outcome.code == 2 && outcome.stdout.starts_with("imu.rate_hz"), "{outcome:?}");
    assert!(outcome.stderr.contains("the indoor scenario has 1 problem"), "{outcome:?}");
}
