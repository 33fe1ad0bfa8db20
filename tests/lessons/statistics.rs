//! What estimators claim, and what they are told.

use rangelab::model::estimator_settings::EstimatorName;
use rangelab::model::estimator_settings::EstimatorName::{Eskf, Kf, UcKf};
use rangelab::model::run::StepRecord;

use crate::{angle, changed, mean, position, run, teaches};

fn nees(step: &StepRecord) -> f64 {
    let nees = step.nees.as_ref().unwrap();
    nees.value / nees.degrees_of_freedom as f64
}

/// What the covariance says the distance from the truth is, m.
fn claimed(step: &StepRecord) -> f64 {
    step.covariance_trace.position.sqrt()
}

#[test]
fn room() {
    teaches("room", |_, run| {
        EstimatorName::ALL.into_iter().all(|name| {
            mean(run, name, 20..60, position) < 0.012 && mean(run, name, 20..60, angle) < 2.5_f64.to_radians()
        })
    });
}

#[test]
fn missing_ranges() {
    teaches("missing-ranges", |trial, seen| {
        let room = run(&changed("room", |_| ()), trial);
        let ratio = |figure: fn(&StepRecord) -> f64| {
            mean(seen, UcKf, 5..60, figure) / mean(&room, UcKf, 5..60, figure)
        };
        (1.05..1.7).contains(&(0.5 * (ratio(angle) + ratio(position))))
    });
}

#[test]
fn overconfident() {
    teaches("overconfident", |trial, seen| {
        let told = run(
            &changed("overconfident", |scenario| {
                scenario.process.sigma_q *= 10.0;
                scenario.process.sigma_t *= 10.0;
            }),
            trial,
        );
        [Kf, UcKf, Eskf].into_iter().all(|name| {
            mean(seen, name, 30..60, nees) > 5.0
                && mean(&told, name, 30..60, nees) < 3.0
                && mean(seen, name, 30..60, position) > 3.0 * mean(seen, name, 30..60, claimed)
        })
    });
}

#[test]
fn wide_prior() {
    let narrow = changed("wide-prior", |scenario| scenario.initial.covariance = 0.01);
    teaches("wide-prior", |trial, seen| {
        let narrow = run(&narrow, trial);
        let first = |name| mean(seen, name, 0..1, angle);
        EstimatorName::ALL
            .into_iter()
            .all(|name| first(name) < 0.25 && mean(seen, name, 0..1, position) < 0.03)
            && mean(&narrow, Eskf, 0..5, angle) > 2.0 * mean(seen, Eskf, 0..5, angle)
    });
}
