//! Every preset teaches what its summary says: in its own first trial, and in nine of ten others. What holds only by the
//! luck of a seed is no lesson.

mod geometry;
mod statistics;

use rangelab::model::estimator_settings::EstimatorName;
use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::run::{EstimatorRun, Run, StepRecord};
use rangelab::model::scenario::Scenario;
use rangelab::study::track_run::run_scenario;

const TRIALS: u64 = 40;

fn run(scenario: &Scenario, trial: u64) -> Run {
    run_scenario(scenario, trial).unwrap()
}

/// A preset with something changed.
fn changed(name: &str, change: impl FnOnce(&mut Scenario)) -> Scenario {
    let mut scenario = preset(name).unwrap();
    change(&mut scenario);
    scenario
}

/// Asks for `shows` in the first trial of a preset and in nine of ten.
#[track_caller]
fn teaches(name: &str, shows: impl Fn(u64, &Run) -> bool) {
    let scenario = preset(name).unwrap();
    let seen: Vec<bool> = (0..TRIALS).map(|trial| shows(trial, &run(&scenario, trial))).collect();
    let count = seen.iter().filter(|&&seen| seen).count();
    println!("{name}: seen in {count} of {TRIALS} trials");
    assert!(seen[0] && 10 * count >= 9 * seen.len(), "{name}: seen in {count} of {TRIALS} trials, {seen:?}");
}

fn of(run: &Run, name: EstimatorName) -> &EstimatorRun {
    run.estimators.iter().find(|estimator| estimator.name == name).unwrap()
}

/// The mean of a figure over some steps of an estimator.
fn mean(
    run: &Run,
    name: EstimatorName,
    steps: std::ops::Range<usize>,
    figure: impl Fn(&StepRecord) -> f64,
) -> f64 {
    let count = steps.len() as f64;
    of(run, name).steps[steps].iter().map(figure).sum::<f64>() / count
}

/// Rotation angle between estimate and truth, rad.
fn angle(step: &StepRecord) -> f64 {
    step.errors.as_ref().unwrap().angle
}

/// Distance between estimate and truth, m.
fn position(step: &StepRecord) -> f64 {
    step.errors.as_ref().unwrap().position
}

#[test]
fn every_estimator_of_every_preset_goes_on_to_the_end() {
    for each in &PRESETS {
        let scenario = each.scenario();
        for trial in 0..TRIALS {
            for estimator in run(&scenario, trial).estimators {
                assert_eq!(estimator.failure, None, "{}, trial {trial}: {}", each.name, estimator.label);
            }
        }
    }
}

#[test]
fn presets_have_names_and_one_lesson_of_readable_length() {
    for (i, each) in PRESETS.iter().enumerate() {
        assert!((60..=220).contains(&each.summary.len()), "{}: {}", each.name, each.summary.len());
        assert!(PRESETS[..i].iter().all(|other| other.name != each.name && other.title != each.title));
    }
}
