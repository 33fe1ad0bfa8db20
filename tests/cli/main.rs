//! The built command line: what it writes, where, and with which exit code.

mod anchorless;
mod command;
mod field;
mod figure;
mod indoor;
mod localize;
mod place;
mod refusals;

use command::{Outcome, folder, rangelab, rangelab_with};
use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::recording::RecordingDocument;
use rangelab::model::run::Run;
use rangelab::model::scenario::{Scenario, WeightSource};
use rangelab::study::report::StudyReport;

#[test]
fn a_run_is_json_and_nothing_else() {
    let run = Run::from_json(&rangelab(&["run", "room", "--steps", "3"]).data()).unwrap();
    assert_eq!((run.estimators.len(), run.estimators[0].steps.len()), (6, 3));
    assert!(run.bounds.iter().all(|bound| bound.steps.len() == 3));
}

#[test]
fn a_run_is_a_table_too() {
    let text = rangelab(&["run", "planar", "--estimators", "kf,eskf", "--format", "csv"]).data();
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 1 + 2 * 40);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    let angle = lines[0].iter().position(|name| *name == "orientation_error_rad").unwrap();
    assert!(lines[1..].iter().all(|line| line[angle].parse::<f64>().unwrap() >= 0.0));
}

#[test]
fn a_recording_gives_the_same_estimates_as_the_run_it_comes_from() {
    for (preset, options) in [("room", &[] as &[&str]), ("planar", &[]), ("tracking-paper", &["--feedback"])]
    {
        let recording = rangelab(&["simulate", preset, "--trial", "5"]).data();
        assert!(RecordingDocument::from_json(&recording).is_ok());
        let estimate = [&["estimate", "-"], options].concat();
        let estimated = rangelab_with(&recording, &estimate).data();
        let run = rangelab(&["run", preset, "--trial", "5"]).data();
        assert_eq!(Run::from_json(&estimated).unwrap(), Run::from_json(&run).unwrap(), "{preset}");
        let other = rangelab(&["run", preset, "--trial", "6"]).data();
        assert_ne!(other, run, "{preset}: trials differ");
    }
}

#[test]
fn sensors_off_their_places_disturb_the_recording_which_does_not_tell_where_they_are() {
    let given = Scenario { weights: WeightSource::True, ..preset("room").unwrap() };
    let mounted = Scenario { mounting_sigma: 0.02, ..given.clone() }.to_json();
    let recording = rangelab_with(&mounted, &["simulate", "-"]).data();
    assert_eq!(RecordingDocument::from_json(&recording).unwrap().sensors, given.sensors);
    let estimated = rangelab_with(&recording, &["estimate", "-"]).data();
    let run = |scenario: &str| Run::from_json(&rangelab_with(scenario, &["run", "-"]).data()).unwrap();
    assert_eq!(Run::from_json(&estimated).unwrap(), run(&mounted));
    assert_ne!(run(&given.to_json()), run(&mounted));
}

#[test]
fn options_reach_the_estimators() {
    let changed = |option: &[&str]| {
        let run = |options: &[&str]| {
            Run::from_json(&rangelab(&[&["run", "tracking-paper", "--steps", "2"], options].concat()).data())
                .unwrap()
        };
        let (plain, changed) = (run(&[]), run(option));
        let steps = plain.estimators.iter().zip(&changed.estimators);
        let changed = steps.filter(|(plain, changed)| plain.steps != changed.steps);
        changed.map(|(plain, _)| plain.name.to_string()).collect::<Vec<_>>().join(",")
    };
    assert_eq!(changed(&["--epsilon", "0"]), "et-kf");
    assert_eq!(changed(&["--relative", "--epsilon", "0.01"]), "et-kf");
    assert_eq!(changed(&["--feedback=false"]), "ortho,et-kf");
    assert_eq!(changed(&["--metric", "information", "--epsilon", "0"]), "ortho,et-kf");
    assert_eq!(changed(&["--seed", "2"]), "kf,ortho,uc-kf,et-kf,eskf,eskf-raw");
    let settings = |option: &str| {
        let run = rangelab(&["run", "room", "--steps", "1", option, "--manifold", "o"]).data();
        Run::from_json(&run).unwrap().settings
    };
    assert!(settings("--decoupled").decoupled && !settings("--decoupled=false").decoupled);
    assert_eq!(settings("--decoupled").manifold, rangelab::math::rotation::Manifold::O);
}

#[test]
fn a_study_does_not_depend_on_the_threads() {
    let study = |threads: &str, format: &str| {
        let command =
            ["study", "planar", "--trials", "90", "--steps", "5", "--threads", threads, "--format", format];
        rangelab(&command).data()
    };
    let report: StudyReport = serde_json::from_str(&study("1", "json")).unwrap();
    assert_eq!((report.trials, report.estimators.len(), report.estimators[0].steps.len()), (90, 6, 5));
    for format in ["json", "csv", "table"] {
        let one = study("1", format);
        assert!(!one.is_empty() && one == study("2", format) && one == study("3", format), "{format}");
    }
    let rows: Vec<usize> = study("2", "csv").lines().map(|line| line.split(',').count()).collect();
    assert!(rows.len() == 1 + 12 * 5 && rows.iter().all(|cells| *cells == rows[0]), "{rows:?}");
}

#[test]
fn a_study_shows_the_steps_that_are_asked_for() {
    let study = |shown: &[&str]| {
        rangelab(
            &[&["study", "planar", "--trials", "3", "--steps", "8", "--estimators", "uc-kf"], shown].concat(),
        )
    };
    let steps = |text: String| {
        let headers = text.lines().filter_map(|line| line.strip_prefix("step ")?.split_whitespace().next());
        headers.map(str::to_owned).collect::<Vec<_>>().join(",")
    };
    assert_eq!(steps(study(&[]).data()), "0,1,2,4,7");
    assert_eq!(steps(study(&["--steps-shown", "6,2"]).data()), "6,2");
    study(&["--steps-shown", "8"]).refused("--steps-shown 8: the scenario has 8 steps, 0 to 7");
}

#[test]
fn presets_are_listed_written_and_run() {
    let list = rangelab(&["presets"]).data();
    for preset in PRESETS {
        assert!(list.contains(preset.name), "{} is not in the list", preset.name);
        let text = rangelab(&["presets", preset.name]).data();
        assert_eq!(Scenario::from_json(&text).unwrap(), preset.scenario());
        assert_eq!(rangelab_with(&text, &["validate", "-"]).data(), "a scenario without problems\n");
    }
    let written = rangelab(&["presets", "planar"]).data();
    assert_eq!(rangelab_with(&written, &["run", "-"]).data(), rangelab(&["run", "planar"]).data());
}

#[test]
fn files_are_read_and_written() {
    let folder = folder("files");
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let (recording, run) = (path("recording.json"), path("run.json"));
    assert_eq!(rangelab(&["simulate", "planar", "-o", &recording]).data(), "");
    assert_eq!(rangelab(&["estimate", &recording, "--output", &run]).data(), "");
    assert!(Run::from_json(&std::fs::read_to_string(&run).unwrap()).is_ok());
    assert_eq!(rangelab(&["validate", &recording]).data(), "a recording without problems\n");
    rangelab(&["presets", "-o", &path("no/such/folder")]).failed(1, "cannot be written");
}

#[test]
fn an_estimator_that_stops_is_named_and_the_rest_is_written() {
    let recording = r#"{"version": 1, "dimension": 2, "anchors": [[0, 0], [1, 0], [0, 1]], "sensors": [[0, 0], [1, 0]],
        "noise": {"kind": "range", "sigma": 1e-6}, "initial": {"covariance": 1e12},
        "epochs": [{"interval": 1, "ranges": [[1e9, 1e9], [1, 1], [0, 0]]}]}"#;
    let Outcome { code, stdout, stderr } = rangelab_with(recording, &["estimate", "-"]);
    let run = Run::from_json(&stdout).unwrap();
    let stopped = run.estimators.iter().filter(|estimator| estimator.failure.is_some()).count();
    assert!(stopped > 0, "this recording stops no estimator any more");
    assert_eq!((code, stderr.lines().count(), stderr.matches("stopped at step 0").count()), (1, 1, stopped));
}

#[test]
fn a_study_counts_the_trials_that_stop() {
    let far = r#"{"version": 1, "dimension": 2, "anchors": [[0, 0], [1, 0], [0, 1]], "sensors": [[0, 0], [1, 0], [3, 2]],
        "noise": {"kind": "range", "sigma": 1e-6}, "initial": {"covariance": 1e12}, "steps": 2,
        "start": {"orientation": [[1, 0], [0, 1]], "position": [1e9, 1e9]}}"#;
    let text = rangelab_with(far, &["study", "-", "--trials", "4", "--steps-shown", "1"]).data();
    let line = |start: &str| text.lines().find(|line| line.starts_with(start)).unwrap();
    assert!(line("step 1").ends_with("  failed"), "{text}");
    assert_eq!(line("ESKF raw").split_whitespace().collect::<Vec<_>>(), ["ESKF", "raw", "4"], "{text}");
    assert!(line("KF ").contains('±'), "{text}");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let outcome = command::rangelab_unread(&["simulate", "tracking-paper", "--steps", "2000"]);
    assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""));
}
