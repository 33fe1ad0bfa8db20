//! What the command line refuses: one sentence on stderr, nothing on stdout, exit code 2. And what its help says.

use crate::command::{folder, rangelab, rangelab_with};

const RECORDING: &str = r#"{"version": 1, "dimension": 2, "noise": {"kind": "range", "sigma": 0.05},
    "anchors": [[0, 0], [9, 0], [0, 9]], "sensors": [[0, 0], [1, 0]],
    "epochs": [{"interval": 0.1, "ranges": [[5.0, 5.7], [6.4, null], [6.7, 7.2]]}]}"#;

/// A change to the recording, and words of the answer.
const SPOILED: [(&str, &str, &str); 13] = [
    ("7.2]]}]}", "7.2", "EOF while parsing"),
    ("\"version\": 1", "\"version\": 2", "version"),
    ("\"version\": 1, ", "", "missing field `version`"),
    ("\"version\": 1", "\"version\": 1, \"colour\": \"red\"", "unknown field `colour`"),
    ("6.4, null", "6.4, NaN", "expected value at line 3"),
    ("6.4, null", "6.4, \"NaN\"", "invalid type: string \"NaN\""),
    ("6.4, null", "6.4, 1e999", "number out of range"),
    (
        "6.4, null",
        "-6.4, null",
        "epochs[0].ranges[1][0] is -6.4, allowed: from 0 to 1e10 m, or null if missing",
    ),
    ("6.4, null", "6.4", "epochs[0].ranges[1] is 1 long, allowed: 2 entries, one a sensor"),
    ("[6.4, null], ", "", "epochs[0].ranges is 2 rows, allowed: 3 rows, one an anchor"),
    ("[9, 0]", "[9]", "anchors[1] is 1 long, allowed: 2 numbers"),
    ("\"sigma\": 0.05", "\"sigma\": 0", "noise.sigma is 0"),
    ("\"dimension\": 2", "\"dimension\": 1000000000", "dimension is 1000000000, allowed: 2 or 3"),
];

#[test]
fn bad_recordings_are_refused_with_the_place() {
    assert!(rangelab_with(RECORDING, &["estimate", "-"]).data().starts_with('{'));
    for (from, to, words) in SPOILED {
        assert!(RECORDING.contains(from), "{from}");
        let spoiled = RECORDING.replacen(from, to, 1);
        rangelab_with(&spoiled, &["estimate", "-"]).refused(words);
    }
    for nothing in ["", "[]", "3", "null", "\u{feff}{}", "\0"] {
        rangelab_with(nothing, &["estimate", "-"]).refused("stdin: the recording cannot be read");
    }
    let nested = "[".repeat(1_000_000);
    rangelab_with(&nested, &["estimate", "-"]).refused("stdin: the recording cannot be read");
}

#[test]
fn huge_scenarios_are_refused_before_they_take_memory() {
    let scenario = rangelab(&["presets", "room"]).data();
    let spoiled = |from: &str, to: &str| {
        assert!(scenario.contains(from), "{from}");
        rangelab_with(&scenario.replacen(from, to, 1), &["run", "-"])
    };
    spoiled("\"steps\":60", "\"steps\":4000000000").refused("steps is 4000000000, allowed: 1 to 10000");
    spoiled("\"dimension\":3", "\"dimension\":4000000000").refused("dimension is 4000000000");
    spoiled("\"seed\":1", "\"seed\":18446744073709551615").refused("seed is 18446744073709551615");
    let anchors = format!("\"anchors\":[{}", "[0,0,0],".repeat(2000));
    spoiled("\"anchors\":[", &anchors).refused("anchors is 2006 long, allowed: 1 to 1000 entries");
    rangelab(&["run", "room", "--steps", "10001"]).refused("steps is 10001");
    rangelab(&["study", "room", "--trials", "18446744073709551615"]).refused("from 1 to 1000000");
    rangelab(&["study", "room", "--trials", "0"]).refused("from 1 to 1000000");
}

#[test]
fn only_the_first_problems_are_named_and_validate_lists_all() {
    let spoiled =
        RECORDING.replace("5.7", "-5.7").replace("6.4", "-6.4").replace("6.7", "-6.7").replace("7.2", "-7.2");
    let outcome = rangelab_with(&spoiled, &["estimate", "-"]);
    outcome.refused("the recording has 4 problems; epochs[0].ranges[0][1] is -5.7");
    assert!(outcome.stderr.contains("`rangelab validate`") && !outcome.stderr.contains("-7.2"));
    let listed = rangelab_with(&spoiled, &["validate", "-"]);
    assert_eq!((listed.code, listed.stdout.lines().count()), (2, 4), "{}", listed.stdout);
    assert_eq!(listed.stderr, "rangelab: stdin: the recording has 4 problem(s)\n");
    let json = rangelab_with(&spoiled, &["validate", "-", "--format", "json"]);
    let problems: Vec<serde_json::Value> = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!((json.code, problems.len(), &problems[3]["value"]), (2, 4, &serde_json::json!("-7.2")));
}

#[test]
fn a_mounting_error_below_zero_is_a_problem_with_its_limit() {
    let scenario = rangelab(&["presets", "room"]).data();
    let spoiled = scenario.replacen("\"mounting_sigma\":0.0", "\"mounting_sigma\":-0.01", 1);
    let listed = rangelab_with(&spoiled, &["validate", "-"]);
    assert_eq!((listed.code, &*listed.stdout), (2, "mounting_sigma is -0.01, allowed: from 0 to 1e9 m\n"));
    rangelab_with(&spoiled, &["simulate", "-"]).refused("mounting_sigma is -0.01");
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let folder = folder("refusals");
    let bytes = folder.join("bytes.json");
    std::fs::write(&bytes, [0xff, 0xfe, 0x00]).unwrap();
    for command in ["run", "estimate", "validate", "simulate", "study", "field", "place"] {
        rangelab(&[command, folder.to_str().unwrap()]).refused("is a directory");
        rangelab(&[command, "no-such-file.json"]).refused("no-such-file.json: there is no such file");
        rangelab(&[command, bytes.to_str().unwrap()]).refused("valid UTF-8");
    }
    rangelab(&["run", "tracking-papre"]).refused("no preset is called \"tracking-papre\"; there are: room, ");
    rangelab(&["presets", "moon"]).refused("there are: room, planar");
}

#[test]
fn bad_options_are_refused() {
    let refused = |arguments: &[&str], words: &str| {
        let outcome = rangelab(arguments);
        assert!(outcome.code == 2 && outcome.stdout.is_empty(), "{arguments:?}: {outcome:?}");
        assert!(outcome.stderr.contains(words), "{arguments:?}: {}", outcome.stderr);
    };
    refused(&[], "Usage");
    refused(&["fly"], "unrecognized subcommand 'fly'");
    refused(&["run"], "<SCENARIO>");
    refused(&["run", "room", "--estimators", "ukf"], "kf, ortho, uc-kf, et-kf, eskf, eskf-raw");
    refused(&["run", "room", "--estimators", "kf,kf"], "each estimator at most once");
    refused(&["run", "room", "--manifold", "u"], "so, o");
    refused(&["run", "room", "--epsilon", "nan"], "threshold.epsilon is NaN");
    refused(&["run", "room", "--epsilon", "-0.1"], "threshold.epsilon is -0.1");
    refused(&["run", "room", "--trial", "-1"], "unexpected argument '-1'");
    refused(&["study", "room", "--threads", "0"], "--threads");
    let estimate = rangelab_with(RECORDING, &["estimate", "-", "--estimators", "kf,kf", "--epsilon", "inf"]);
    estimate.refused("the estimator settings has 2 problem(s)");
}

#[test]
fn help_names_every_option_and_its_examples_work() {
    let options = [
        (
            "run",
            "--steps --seed --trial --estimators --manifold --feedback --relative --decoupled --epsilon --metric",
        ),
        ("simulate", "--steps --seed --trial --output"),
        (
            "estimate",
            "--estimators --manifold --feedback --relative --decoupled --epsilon --metric --format --output",
        ),
        ("study", "--trials --threads --estimators --steps-shown --format --steps --seed --output"),
        (
            "field",
            "--plane --height --heading-deg --offset --quantity --form --headings --limit --resolution --at --format --output",
        ),
        ("figure", "[NAME] --trials --seed --threads --format --output"),
        ("place", "--restarts --threads --criterion --target --over --output --seed"),
        ("presets", "--output [NAME]"),
        ("validate", "--format --output <FILE>"),
    ];
    for (command, options) in options {
        let help = rangelab(&[command, "--help"]).data();
        for option in options.split(' ').chain(["Examples:", "  rangelab "]) {
            assert!(help.contains(option), "{command} --help does not say {option}");
        }
        assert_eq!(help, rangelab(&[command, "-h"]).data(), "one help, short enough for both");
        assert!(help.lines().all(|line| line.chars().count() <= 100), "{help}");
    }
    let help = rangelab(&["--help"]).data();
    assert!(options.iter().all(|(command, _)| help.contains(command)));
    let help = rangelab(&["estimate", "--help"]).data();
    let example = &help[help.find("{\"version\"").unwrap()..=help.rfind("]}]}").unwrap() + 3];
    assert!(rangelab_with(example, &["estimate", "-"]).data().starts_with('{'));
}
