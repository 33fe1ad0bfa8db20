//! The figures of relative kinematics. At the few trials of these tests some claims stay open that are decided at full size.

use rangelab::model::kinematics::settings::KinematicsName::Algorithm2Rank1;
use rangelab::study::figures::claim::Verdict;
use rangelab::study::figures::experiment::Study;
use rangelab::study::figures::report::FigureReport;
use rangelab::study::kinematics::report::KinematicsReport;

use super::{claims_come_out_over, computed, plan};

pub const FAIL: [&str; 11] = [
    "RMSE(B1) of Algorithm 2 over that of Algorithm 1, worst",
    "RMSE(B0) of Algorithm 1 over the CRB from distances",
    "RMSE(B1) of Algorithm 1 over the CRB from distances",
    "RMSE(B2) of Algorithm 1 over the CRB from distances",
    "RMSE(B0) of Algorithm 2 over the CRB with accelerations",
    "RMSE(B1) of Algorithm 2 over the CRB with accelerations",
    "RMSE(B2) of Algorithm 2 over the CRB with accelerations",
    "RMSE of Algorithm 1 at t = -5 s, the noise a thousandth",
    "RMSE of Algorithm 1 at t = 5 s, the noise a thousandth",
    "RMSE of Algorithm 2 at t = -5 s, the noise a thousandth",
    "RMSE of Algorithm 2 at t = 5 s, the noise a thousandth",
];
pub const OPEN: [&str; 8] = [
    // Its largest trial makes the figure.
    "RMSE(Y1) of Algorithm 1, as printed over that of Algorithm 1, rank one",
    "RMSE(Y0) of Snapshot synchronization over",
    "RMSE(Y0) of ML, distances over the CRB",
    "RMSE(Y1) of ML, distances over the CRB",
    "RMSE(Y2) of ML, distances over the CRB",
    "RMSE(Y1) of ML, distances and accelerations over the CRB",
    "aligned at t = -5 s: RMSE of Algorithm 2, O(D)",
    "aligned at t = 5 s: RMSE of Algorithm 2, O(D)",
];

const TRIALS: usize = 200;

/// A ratio of estimators of which one failed where it is hard says nothing.
#[track_caller]
fn none_fails(reports: &[FigureReport]) {
    for report in reports {
        let curves = report.panels.iter().flat_map(|panel| &panel.curves);
        for curve in curves {
            let failures: usize = curve.points.iter().map(|point| point.failures).sum();
            assert_eq!(failures, 0, "{}, {}", report.name, curve.name);
        }
    }
}

#[test]
fn figure_1() {
    let spoils =
        [("algorithm-1-rank1", "range-polynomial", 10), ("algorithm-1-rank1", "algorithm-2-rank1", 2)];
    none_fails(&claims_come_out_over(TRIALS, &[("kinematics-1", 38, &spoils)]));
}

#[test]
fn figure_2a() {
    let spoils = [
        ("algorithm-1-rank1", "algorithm-2-rank1", 3),
        ("maximum-likelihood", "algorithm-2-rank1", 5),
        ("algorithm-2-rank1", "algorithm-2-so", 1),
    ];
    none_fails(&claims_come_out_over(TRIALS, &[("kinematics-2a", 44, &spoils)]));
}

#[test]
fn figure_2b() {
    let spoils = [
        ("algorithm-1-rank1", "algorithm-2-rank1", 1),
        ("maximum-likelihood", "algorithm-1-rank1", 2),
        ("algorithm-2-so", "algorithm-1-rank1", 2),
    ];
    none_fails(&claims_come_out_over(TRIALS, &[("kinematics-2b", 17, &spoils)]));
}

fn points(study: &mut Study) -> &mut Vec<KinematicsReport> {
    let Study::Kinematics(report) = study else { panic!("another kind of study") };
    &mut report.points
}

#[test]
fn claims_about_an_estimator_that_failed_have_no_number() {
    let plan = plan("kinematics-2b", 2, 1);
    let mut studies = plan.studies(&computed(&plan)).unwrap();
    let sound = plan.report_of(&studies).claims;
    assert!(sound.iter().all(|claim| claim.found.is_some()));
    let estimators = studies.iter_mut().flat_map(points).flat_map(|point| &mut point.estimators);
    estimators.filter(|each| each.name == Algorithm2Rank1).for_each(|each| each.summary.failures = 1);
    let spoiled = plan.report_of(&studies).claims;
    let lost: Vec<bool> = spoiled.iter().map(|claim| claim.found.is_none()).collect();
    // The paper's Algorithm 2 is that of rank one; "Algorithm 2, O(D)" is another.
    let about: Vec<bool> =
        spoiled.iter().map(|claim| claim.what.starts_with("RMSE of Algorithm 2 ")).collect();
    assert_eq!(lost, about);
    assert_eq!(lost.iter().filter(|lost| **lost).count(), 3);
    studies.iter_mut().map(points).for_each(Vec::clear);
    assert!(plan.report_of(&studies).claims.iter().all(|claim| claim.verdict == Verdict::NotDecided));
}
