//! The figures of the tracking paper's experiment, at 1000 trials each: `cargo run --release --example figures` prints
//! them. A figure may miss its target by three standard errors, which is far less than what each claim is about; the
//! spoiled reports show that.

#[path = "../crate/examples/figures/claims.rs"]
mod claims;

use claims::Claim;
use rangelab::model::estimator_settings::EstimatorName::{self, Eskf, EskfRaw, EtKf, Kf, Ortho, UcKf};
use rangelab::study::report::StudyReport;

const TRIALS: usize = 1000;
const STANDARD_ERRORS: f64 = 3.0;

fn missed(claims: &[Claim]) -> Vec<String> {
    let missed = claims.iter().filter(|claim| !(claim.missed_by() <= STANDARD_ERRORS));
    missed.map(|claim| format!("{}: {:?}, not in {:?}", claim.what, claim.found, claim.target)).collect()
}

fn assert_none(missed: &[String]) {
    assert!(missed.is_empty(), "\n{}\n", missed.join("\n"));
}

/// The report with the figures of two estimators exchanged.
fn exchanged(report: &StudyReport, a: EstimatorName, b: EstimatorName) -> StudyReport {
    let mut report = report.clone();
    for estimator in &mut report.estimators {
        let name = estimator.name;
        estimator.name = if name == a {
            b
        } else if name == b {
            a
        } else {
            name
        };
    }
    report
}

#[test]
fn fixed_anchors() {
    let report = claims::study("tracking-paper", TRIALS).unwrap();
    assert!(report.estimators.iter().all(|estimator| estimator.steps.iter().all(|s| s.trials == TRIALS)));
    let claims = claims::fixed(&report);
    assert_eq!(claims.len(), 13);
    assert_none(&missed(&claims));
    for (a, b, broken) in [(Kf, UcKf, 5), (Kf, Eskf, 1), (EtKf, Ortho, 4), (Eskf, EskfRaw, 1)] {
        let missed = missed(&claims::fixed(&exchanged(&report, a, b)));
        assert!(missed.len() >= broken, "{a} and {b} exchanged: {missed:?}");
    }
}

#[test]
fn redrawn_anchors() {
    let report = claims::study("tracking-paper-redrawn", TRIALS).unwrap();
    assert_none(&missed(&claims::redrawn(&report)));
    let spoiled = exchanged(&report, Kf, UcKf);
    assert_eq!(missed(&claims::redrawn(&spoiled)).len(), 1);
}

#[test]
fn a_study_without_figures_holds_nothing() {
    let mut report = claims::study("tracking-paper", 1).unwrap();
    report.estimators.clear();
    assert!(
        claims::fixed(&report).iter().chain(&claims::redrawn(&report)).all(|claim| claim.missed_by() > 1e9)
    );
}
