//! What \[T\] says of its figures, and what rangelab adds, each as a number with a target.
//!
//! "Follows" and "similar" are made: within a tenth. A claim about every step is held against the step where it is worst.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::reading::Reading;
use super::scenarios::{FIXED, INFORMATION_METRIC, OFF_CENTRE, OVER_O, PAPER, REDRAWN};
use crate::model::estimator_settings::EstimatorName::{self, Eskf, EskfRaw, EtKf, Kf, Ortho, UcKf};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::extreme::{least, most};
use crate::study::figures::wording::{beyond, paper};
use crate::study::moments::Estimate;
use crate::study::report::StudyReport;
use crate::study::tally::Summary;

const WITHIN_A_TENTH: Interval = Interval::between(0.9, 1.1);
const A_TENTH_ABOVE: Interval = Interval::most(1.1);
const A_TENTH_BELOW: Interval = Interval::most(0.9);
const BELOW: Interval = Interval::most(1.0);
const ABOVE: Interval = Interval::least(1.0);

const ORIENTATION: fn(&Summary) -> Estimate = |s| s.rmse_orientation;
const POSITION: fn(&Summary) -> Estimate = |s| s.rmse_position;
const ANGLE: fn(&Summary) -> Estimate = |s| s.rms_angle;

pub(super) fn figure_2(studies: &[Study]) -> Vec<Claim> {
    let studies: Vec<&StudyReport> = studies.iter().filter_map(Study::track).collect();
    let anchors = [(FIXED, "fixed"), (REDRAWN, "redrawn")].map(|(i, name)| (Reading(studies[i]), name));
    let mut claims = Vec::new();
    for (study, name) in anchors {
        claims.extend(of_the_paper(study, name));
    }
    claims.push(lower_orientation(Reading(studies[OVER_O]), UcKf, "redrawn, over O(3)"));
    claims.push(similar_positions(Reading(studies[OFF_CENTRE]), "fixed, body frame at the base"));
    let fixed = anchors[0].0;
    claims.extend(at_the_bound(fixed));
    claims.extend(about_consistency(fixed));
    claims.extend(about_the_trigger(fixed, &studies));
    let raw = fixed.at(EskfRaw, 0, POSITION).zip(fixed.at(Eskf, 0, POSITION));
    let found = raw.and_then(|(raw, projected)| raw.over(projected));
    claims.push(beyond(
        "ESKF on unprojected ranges: RMSE(t) over that of ESKF, step 0",
        found,
        Interval::most(0.5),
    ));
    claims
}

pub(super) fn figure_3(studies: &[Study]) -> Vec<Claim> {
    let studies: Vec<&StudyReport> = studies.iter().filter_map(Study::track).collect();
    let mut claims = Vec::new();
    for (index, anchors) in [(FIXED, "fixed"), (REDRAWN, "redrawn")] {
        let study = Reading(studies[index]);
        for name in [Ortho, EtKf, UcKf] {
            let over_kf =
                |read: fn(&Summary) -> Estimate| most(study.steps(), |k| study.versus(name, Kf, k, read));
            let what = |what: &str| format!("{anchors}: {} of {} over that of KF", what, name.label());
            let (k, found) = over_kf(|s| s.paper_mae);
            claims.push(paper(at_worst(&what("MAE as printed"), k), found, BELOW));
            let (k, found) = over_kf(ANGLE);
            claims.push(paper(at_worst(&what("rotation angle"), k), found, A_TENTH_BELOW));
        }
    }
    let fixed = Reading(studies[FIXED]);
    for name in [UcKf, Eskf] {
        let (k, found) = most(fixed.steps(), |k| fixed.over_bound(name, k, ANGLE, |b| b.angle));
        let what = format!("fixed: rotation angle of {} over the posterior bound", name.label());
        claims.push(beyond(at_worst(&what, k), found, A_TENTH_ABOVE));
    }
    claims
}

/// The paper's sentences, in one of the two drawn scenarios.
fn of_the_paper(study: Reading<'_>, anchors: &str) -> Vec<Claim> {
    let mut claims = Vec::new();
    for k in [0, 4, 9, 19] {
        let claimed = study.at(Kf, k, |s| s.claimed_orientation);
        let found =
            study.at(Kf, k, ORIENTATION).zip(claimed).and_then(|(error, claimed)| error.over(claimed));
        let what = format!("{anchors}: RMSE(Q) of KF over its estimated covariance, step {k}");
        claims.push(paper(what, found, WITHIN_A_TENTH));
    }
    claims.extend([Ortho, EtKf, UcKf].map(|name| lower_orientation(study, name, anchors)));
    claims.push(similar_positions(study, anchors));
    let (k, found) = least(study.steps(), |k| study.versus(EtKf, Ortho, k, ORIENTATION));
    claims.push(paper(
        at_worst(&format!("{anchors}: RMSE(Q) of ET-KF over that of KF-ortho"), k),
        found,
        ABOVE,
    ));
    let overestimated =
        |k| study.at(UcKf, k, |s| s.claimed_orientation)?.over(study.at(UcKf, k, ORIENTATION)?);
    let (k, found) = least(study.steps(), overestimated);
    claims.push(paper(
        at_worst(&format!("{anchors}: estimated covariance of UC-KF over its RMSE(Q)"), k),
        found,
        ABOVE,
    ));
    claims
}

fn lower_orientation(study: Reading<'_>, name: EstimatorName, anchors: &str) -> Claim {
    let (k, found) = most(study.steps(), |k| study.versus(name, Kf, k, ORIENTATION));
    paper(at_worst(&format!("{anchors}: RMSE(Q) of {} over that of KF", name.label()), k), found, BELOW)
}

fn similar_positions(study: Reading<'_>, anchors: &str) -> Claim {
    let spread = |k| {
        let errors: Vec<Estimate> = PAPER.iter().filter_map(|name| study.at(*name, k, POSITION)).collect();
        let by_value = |a: &&Estimate, b: &&Estimate| a.value.total_cmp(&b.value);
        errors.iter().max_by(by_value)?.over(*errors.iter().min_by(by_value)?)
    };
    let (k, found) = most(study.steps(), spread);
    let what = format!("{anchors}: largest RMSE(t) of the paper's estimators over the least");
    paper(at_worst(&what, k), found, A_TENTH_ABOVE)
}

fn at_the_bound(study: Reading<'_>) -> Vec<Claim> {
    let mut claims = Vec::new();
    for name in [UcKf, Eskf] {
        let orientation = most(study.steps(), |k| study.over_bound(name, k, ORIENTATION, |b| b.orientation));
        let position = most(study.steps(), |k| study.over_bound(name, k, POSITION, |b| b.position));
        for (letter, (k, found)) in [("Q", orientation), ("t", position)] {
            let what = format!("fixed: RMSE({letter}) of {} over the posterior bound", name.label());
            claims.push(beyond(at_worst(&what, k), found, A_TENTH_ABOVE));
        }
    }
    claims
}

fn about_consistency(study: Reading<'_>) -> Vec<Claim> {
    let nees = |k| study.at(Eskf, k, |s| s.nees);
    let (high, low) = (most(study.steps(), nees), least(study.steps(), nees));
    let linear = |k| study.at(Kf, k, |s| s.claimed_orientation)?.over(study.linear_bound(k)?.orientation);
    let (k, found) = most(study.steps(), linear);
    let (first, last) =
        (study.linear_over_intrinsic(0), study.linear_over_intrinsic(study.steps().saturating_sub(1)));
    [
        beyond(at_worst("fixed: most NEES of ESKF per degree of freedom", high.0), high.1, A_TENTH_ABOVE),
        beyond(
            at_worst("fixed: least NEES of ESKF per degree of freedom", low.0),
            low.1,
            Interval::least(0.9),
        ),
        beyond(
            at_worst("fixed: estimated covariance of KF over the linear posterior bound", k),
            found,
            WITHIN_A_TENTH,
        ),
        beyond(
            "fixed: linear posterior bound on Q over the one on rotations, step 0",
            first,
            Interval::least(3.0),
        ),
        beyond(
            "fixed: linear posterior bound on Q over the one on rotations, last step",
            last,
            Interval::least(2.0),
        ),
    ]
    .into()
}

/// What the threshold 0.15 does, and what a better metric would.
fn about_the_trigger(fixed: Reading<'_>, studies: &[&StudyReport]) -> Vec<Claim> {
    let events = |k| fixed.at(EtKf, k, |s| s.event_rate);
    let frobenius = Reading(studies[REDRAWN]).at(EtKf, 0, ORIENTATION);
    let information = Reading(studies[INFORMATION_METRIC]).at(EtKf, 0, ORIENTATION);
    let found = information.zip(frobenius).and_then(|(information, frobenius)| information.over(frobenius));
    [
        beyond("fixed: share of trials that ET-KF projects, step 0", events(0), Interval::between(0.5, 0.7)),
        beyond("fixed: share of trials that ET-KF projects, step 4", events(4), Interval::most(0.05)),
        beyond(
            "redrawn: RMSE(Q) of ET-KF projecting in the metric of its covariance over that of ET-KF, step 0",
            found,
            Interval::most(0.5),
        ),
    ]
    .into()
}

fn at_worst(what: &str, step: usize) -> String {
    format!("{what}, worst step ({step})")
}
