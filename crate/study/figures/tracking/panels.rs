//! What is drawn in the figures of \[T\].

use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

use super::scenarios::{FIXED, REDRAWN};
use crate::bounds::BoundKind;
use crate::math::float::degrees;
use crate::model::estimator_settings::EstimatorName::{self, Eskf, EtKf, Kf, Ortho, UcKf};
use crate::study::figures::experiment::Study;
use crate::study::figures::report::{Axis, Curve, CurveKind, Panel, Point};
use crate::study::moments::Estimate;
use crate::study::report::{BoundSummary, StudyReport};
use crate::study::tally::Summary;

/// What goes up in a panel.
struct Quantity {
    name: &'static str,
    title: &'static str,
    axis: (&'static str, &'static str),
    error: fn(&Summary) -> Estimate,
    /// What the KF claims of it.
    claimed: Option<fn(&Summary) -> Estimate>,
    bound: Option<fn(&BoundSummary) -> Estimate>,
}

const ORIENTATION: Quantity = Quantity {
    name: "orientation",
    title: "Orientation",
    axis: ("RMSE(Q), Frobenius norm", ""),
    error: |s| s.rmse_orientation,
    claimed: Some(|s| s.claimed_orientation),
    bound: Some(|b| b.orientation),
};
const POSITION: Quantity = Quantity {
    name: "position",
    title: "Position",
    axis: ("RMSE(t)", "m"),
    error: |s| s.rmse_position,
    claimed: Some(|s| s.claimed_position),
    bound: Some(|b| b.position),
};
/// The paper's formula, literally: the root of a mean angle.
const PAPER_MAE: Quantity = Quantity {
    name: "paper-mae",
    title: "MAE as in the paper, of the columns of Q",
    axis: ("MAE(Q)", "sqrt(rad)"),
    error: |s| s.paper_mae,
    claimed: None,
    bound: None,
};
const ANGLE: Quantity = Quantity {
    name: "angle",
    title: "Angle of the rotation error",
    axis: ("RMS angle", "deg"),
    error: |s| in_degrees(s.rms_angle),
    claimed: None,
    bound: Some(|b| in_degrees(b.angle)),
};

const SHOWN: [EstimatorName; 5] = [Kf, Ortho, EtKf, UcKf, Eskf];

pub(super) fn figure_2(studies: &[Study]) -> Vec<Panel> {
    panels(studies, &[ORIENTATION, POSITION])
}

pub(super) fn figure_3(studies: &[Study]) -> Vec<Panel> {
    panels(studies, &[PAPER_MAE, ANGLE])
}

fn panels(studies: &[Study], quantities: &[Quantity; 2]) -> Vec<Panel> {
    let studies: Vec<&StudyReport> = studies.iter().filter_map(Study::track).collect();
    let anchors = [(FIXED, "fixed"), (REDRAWN, "redrawn")];
    let each = anchors.iter().flat_map(|anchors| quantities.iter().map(move |quantity| (anchors, quantity)));
    each.map(|((index, anchors), quantity)| Panel {
        name: format!("{}-{anchors}", quantity.name),
        title: format!("{}, anchors {anchors}", quantity.title),
        x: Axis::linear("step", ""),
        y: Axis::log(quantity.axis.0, quantity.axis.1),
        curves: curves(studies[*index], quantity),
    })
    .collect()
}

fn curves(study: &StudyReport, quantity: &Quantity) -> Vec<Curve> {
    let mut curves: Vec<Curve> =
        SHOWN.iter().filter_map(|name| estimator(study, *name, quantity.error)).collect();
    if let Some(claimed) = quantity.claimed {
        let kf = estimator(study, Kf, claimed);
        curves.extend(kf.map(|curve| Curve {
            label: "KF, estimated covariance".to_string(),
            kind: CurveKind::Covariance,
            ..curve
        }));
    }
    curves.extend(quantity.bound.and_then(|read| bound(study, BoundKind::PosteriorCrb, read)));
    curves
}

fn estimator(study: &StudyReport, name: EstimatorName, read: fn(&Summary) -> Estimate) -> Option<Curve> {
    let report = study.estimators.iter().find(|report| report.name == name)?;
    let point = |(k, step): (usize, &Summary)| Point {
        x: k as f64,
        y: read(step),
        trials: step.trials,
        failures: step.failures,
        reflections: Some(step.reflection_rate),
    };
    let reached = report.steps.iter().enumerate().filter(|(_, step)| step.trials > 0);
    Some(Curve {
        name: name.to_string(),
        label: report.label.clone(),
        kind: CurveKind::Estimator,
        points: reached.map(point).collect(),
    })
}

fn bound(study: &StudyReport, kind: BoundKind, read: fn(&BoundSummary) -> Estimate) -> Option<Curve> {
    let report = study.bounds.iter().find(|report| report.name == kind.name())?;
    let point = |(k, step): (usize, &BoundSummary)| Point {
        x: k as f64,
        y: read(step),
        trials: step.trials,
        failures: study.trials - step.trials,
        reflections: None,
    };
    let existing = report.steps.iter().enumerate().filter(|(_, step)| step.trials > 0);
    Some(Curve {
        name: report.name.clone(),
        label: report.label.clone(),
        kind: CurveKind::Bound,
        points: existing.map(point).collect(),
    })
}

fn in_degrees(angle: Estimate) -> Estimate {
    Estimate { value: degrees(angle.value), standard_error: degrees(angle.standard_error) }
}
