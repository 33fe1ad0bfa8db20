//! `rangelab localize`: one snapshot as table, JSON and CSV, and what is refused.

use rangelab::model::localize_settings::LocalizerName;
use rangelab::model::presets::preset;
use rangelab::study::localization::run::{SnapshotRun, localize_trial};

use crate::command::{rangelab, rangelab_with};

#[test]
fn one_trial_is_what_the_crate_finds() {
    let text = rangelab(&["localize", "localization-paper", "--trial", "3", "--format", "json"]).data();
    let run: SnapshotRun = serde_json::from_str(&text).unwrap();
    assert_eq!(run, localize_trial(&preset("localization-paper").unwrap(), 3).unwrap());
    let table = rangelab(&["localize", "localization-paper", "--trial", "3"]).data();
    for estimate in &run.estimators {
        assert!(table.lines().any(|line| line.starts_with(&estimate.label)), "{table}");
    }
    let error = run.estimators[4].errors.as_ref().unwrap().position;
    assert!(
        table.lines().any(|line| line.starts_with("OUC-LS ") && line.contains(&format!("{error:.4}"))),
        "{table}"
    );
}

#[test]
fn options_choose_the_localizers() {
    let csv = |options: &[&str]| {
        let text =
            rangelab(&[&["localize", "localization-paper", "--format", "csv"], options].concat()).data();
        let rows: Vec<Vec<String>> =
            text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect();
        assert!(rows.iter().all(|row| row.len() == rows[0].len()), "{text}");
        rows
    };
    assert_eq!(csv(&[]).len(), 1 + LocalizerName::ALL.len() + 4);
    let two = csv(&["--localizers", "ouc-ls,ouc-tls"]);
    assert_eq!(two.len(), 1 + 2 + 4);
    assert_eq!(two[1][2..], two[2][2..], "no mounting errors: total least squares are least squares");
    let three = csv(&["--localizers", "ouc-ls,ouc-tls", "--tls-sigma", "0.3"]);
    assert_eq!(three[1], two[1]);
    assert_ne!(three[2], two[2]);
}

#[test]
fn a_mirrored_body_is_told() {
    // At 0 dB the sign of the determinant is a coin; over rotations it is not.
    let scenario =
        preset("localization-paper").unwrap().to_json().replace("\"zeta_db\":60.0", "\"zeta_db\":0.0");
    let mirrored = |group: &str| {
        let trials = 0..20;
        let told = |trial: i32| {
            let trial = trial.to_string();
            let table = rangelab_with(
                &scenario,
                &["localize", "-", "--localizers", "ouc-ls", "--group", group, "--trial", &trial],
            );
            table.data().contains("mirrored")
        };
        trials.filter(|&trial| told(trial)).count()
    };
    assert_eq!(mirrored("so"), 0);
    assert!((3..18).contains(&mirrored("o")));
}

#[test]
fn what_cannot_be_found_has_a_cause() {
    let table = rangelab(&["localize", "three-anchors"]).data();
    assert!(
        table.contains("OUC-LS, SUC-TLS, ") && table.contains("3 anchors where at least 4 are needed"),
        "{table}"
    );
    rangelab(&["localize", "room", "--tls-sigma", "-1"]).refused("localize.tls_sigma");
}
