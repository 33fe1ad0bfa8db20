//! Golden bits: every number of a run of each preset, by fingerprint. The browser checks the same files.
//!
//! A change of a number on purpose: `cargo test --test golden -- --ignored`, then say in the commit why it moved.

#[path = "golden/fingerprint.rs"]
mod fingerprint;
#[path = "golden/indoor.rs"]
mod indoor;
#[path = "golden/kinematics.rs"]
mod kinematics;

use std::fs;
use std::path::PathBuf;

use fingerprint::{
    figure_fingerprints, fingerprints, geometry_fingerprints, snapshot_fingerprints, study_fingerprint,
};
use rangelab::model::presets::{PRESETS, Preset, preset};
use rangelab::model::run::Run;
use rangelab::study::figures::figure;
use rangelab::study::figures::plan::FigurePlan;
use rangelab::study::monte_carlo::MonteCarlo;
use rangelab::study::track_run::run_scenario;

fn file(preset: &Preset) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{}.txt", preset.name))
}

fn run(preset: &Preset) -> Run {
    run_scenario(&preset.scenario(), 0).unwrap()
}

#[test]
fn every_preset_gives_the_same_bits_as_ever() {
    for preset in &PRESETS {
        let golden =
            fs::read_to_string(file(preset)).unwrap_or_else(|error| panic!("{}: {error}", preset.name));
        assert_eq!(fingerprints(&run(preset)), golden, "{}", preset.name);
    }
}

#[test]
fn one_bit_changes_one_line_and_the_text() {
    let clean = run(&PRESETS[0]);
    let mut spoiled = clean.clone();
    let x = &mut spoiled.estimators[1].steps[7].posterior.position[2];
    *x = f64::from_bits(x.to_bits() ^ 1);
    let (before, after) = (fingerprints(&clean), fingerprints(&spoiled));
    let changed: Vec<&str> = before
        .lines()
        .zip(after.lines())
        .filter(|(a, b)| a != b)
        .map(|(a, _)| a.split_once(' ').unwrap().1)
        .collect();
    assert_eq!(changed, [clean.estimators[1].name.name(), "json"]);
}

/// Two blocks, the second cut short, joined; in the plane and in space.
fn studies() -> String {
    let study = |name: &str| {
        let scenario = preset(name).unwrap();
        let study = MonteCarlo::new(&scenario, 27).unwrap();
        let mut sum = study.start();
        (0..study.blocks()).for_each(|index| sum.merge(&study.block(index).unwrap()).unwrap());
        study_fingerprint(name, &sum.to_numbers())
    };
    study("planar") + &study("room")
}

#[test]
fn studies_give_the_same_bits_as_ever() {
    assert_eq!(studies(), include_str!("golden/studies.txt"));
}

/// As workers do it: every block travels as a row of numbers.
fn figures() -> String {
    let plan = |name: &str, trials, seed| FigurePlan::new(figure(name).unwrap(), trials, seed).unwrap();
    figure_fingerprints(
        |name, trials, seed| {
            let plan = plan(name, trials, seed);
            (0..plan.jobs()).map(|job| plan.to_numbers(&plan.job(job).unwrap())).collect()
        },
        |name, trials, seed, blocks| {
            let plan = plan(name, trials, seed);
            let mut sum = plan.start();
            for block in blocks {
                sum.merge(&plan.from_numbers(block).unwrap()).unwrap();
            }
            plan.report(&sum).unwrap().to_json()
        },
    )
}

#[test]
fn figures_give_the_same_bits_as_ever() {
    assert_eq!(figures(), include_str!("golden/figures.txt"));
}

#[test]
fn fields_and_placements_give_the_same_bits_as_ever() {
    assert_eq!(geometry_fingerprints(), include_str!("golden/geometry.txt"));
}

#[test]
fn snapshots_give_the_same_bits_as_ever() {
    assert_eq!(snapshot_fingerprints(), include_str!("golden/snapshots.txt"));
}

#[test]
#[ignore = "writes the golden files anew"]
fn write_the_golden_files() {
    for preset in &PRESETS {
        fs::write(file(preset), fingerprints(&run(preset))).unwrap();
    }
    let beside = |name: &str| file(&PRESETS[0]).with_file_name(name);
    fs::write(beside("studies.txt"), studies()).unwrap();
    fs::write(beside("figures.txt"), figures()).unwrap();
    fs::write(beside("geometry.txt"), geometry_fingerprints()).unwrap();
    fs::write(beside("indoor.txt"), indoor::indoor_fingerprints()).unwrap();
    fs::write(beside("kinematics.txt"), kinematics::kinematics_fingerprints()).unwrap();
    fs::write(beside("snapshots.txt"), snapshot_fingerprints()).unwrap();
}
