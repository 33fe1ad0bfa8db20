//! What is drawn in the figures of \[L\].

use alloc::string::ToString;
use alloc::vec::Vec;

use super::experiments::{FIXED, FIXED_OVER_O, PAPER, REDRAWN, TOTAL};
use super::reading::{Read, ReadBound};
use crate::math::float::{degrees, sqrt};
use crate::model::localize_settings::LocalizerName::{self, ClassicalLs};
use crate::model::noise::RangeNoise;
use crate::study::figures::experiment::Study;
use crate::study::figures::report::{Axis, Curve, CurveKind, Panel, Point};
use crate::study::localization::SnapshotBound::{self, Classical, Crb, UnitaryCrb};
use crate::study::localization::report::LocalizationReport;
use crate::study::moments::Estimate;

/// What goes up in a panel.
struct Quantity {
    name: &'static str,
    axis: fn() -> Axis,
    error: Read,
    bounds: &'static [(SnapshotBound, ReadBound)],
}

const ORIENTATION: Quantity = Quantity {
    name: "orientation",
    axis: || Axis::log("RMSE(Q), Frobenius norm", ""),
    error: |s| s.rmse_orientation,
    bounds: &[(Crb, |b| b.orientation), (UnitaryCrb, |b| b.orientation)],
};
const REFLECTIONS: Quantity = Quantity {
    name: "reflections",
    axis: || Axis::linear("share of the trials", ""),
    error: |s| s.reflection_rate,
    bounds: &[],
};
const BIAS: Quantity = Quantity {
    name: "bias",
    axis: || Axis::log("bias of Q, Frobenius norm", ""),
    error: |s| s.bias_orientation,
    bounds: &[],
};
/// The paper's formula (52), literally: the root of a mean sum of the three columns' angles.
const PAPER_MAE: Quantity = Quantity {
    name: "paper-mae",
    axis: || Axis::log("MAE(Q)", "sqrt(rad)"),
    error: |s| s.paper_mae.map(|mae| times(mae, sqrt(3.0))),
    bounds: &[],
};
const ANGLE: Quantity = Quantity {
    name: "angle",
    axis: || Axis::log("RMS angle", "deg"),
    error: |s| s.rms_angle.map(|angle| times(angle, degrees(1.0))),
    bounds: &[(UnitaryCrb, |b| b.angle.map(|angle| times(angle, degrees(1.0))))],
};
const POSITION: Quantity = Quantity {
    name: "position",
    axis: || Axis::log("RMSE(t)", "m"),
    error: |s| s.rmse_position,
    bounds: &[(UnitaryCrb, |b| b.position)],
};
const SENSORS: Quantity = Quantity {
    name: "sensors",
    axis: || Axis::log("RMSE(S), all sensors together", "m"),
    error: |s| Some(s.rmse_sensors),
    bounds: &[(Classical, |b| b.sensors), (UnitaryCrb, |b| b.sensors)],
};

pub(super) fn figure_2(studies: &[Study]) -> Vec<Panel> {
    let studies = sweeps(studies);
    [
        panel(studies[FIXED], "fixed", "Anchors fixed", &ORIENTATION, &PAPER),
        panel(studies[REDRAWN], "redrawn", "Anchors redrawn", &ORIENTATION, &PAPER),
        panel(
            studies[FIXED_OVER_O],
            "reflections",
            "Mirrored estimates over O(3), anchors fixed",
            &REFLECTIONS,
            &PAPER,
        ),
    ]
    .into()
}

pub(super) fn figure_3(studies: &[Study]) -> Vec<Panel> {
    [panel(sweeps(studies)[FIXED], "bias", "Bias, anchors fixed", &BIAS, &PAPER)].into()
}

pub(super) fn figure_4(studies: &[Study]) -> Vec<Panel> {
    angles(sweeps(studies)[FIXED], &PAPER)
}

pub(super) fn figure_5(studies: &[Study]) -> Vec<Panel> {
    let study = sweeps(studies)[FIXED];
    let mut panel = panel(study, "position", "Anchors fixed", &POSITION, &PAPER);
    let classical = estimator(study, ClassicalLs, SENSORS.error);
    panel.curves.extend(classical.map(|curve| Curve { label: "classical LS, RMSE(S)".to_string(), ..curve }));
    [panel].into()
}

pub(super) fn figure_6(studies: &[Study]) -> Vec<Panel> {
    let enabled = [&[ClassicalLs], &PAPER[..]].concat();
    [panel(sweeps(studies)[FIXED], "sensors", "Anchors fixed", &SENSORS, &enabled)].into()
}

pub(super) fn figure_7(studies: &[Study]) -> Vec<Panel> {
    [panel(sweeps(studies)[FIXED], "orientation", "Sensors misplaced by 10 cm", &ORIENTATION, &TOTAL)].into()
}

pub(super) fn figure_8(studies: &[Study]) -> Vec<Panel> {
    angles(sweeps(studies)[FIXED], &TOTAL)
}

pub(super) fn figure_9(studies: &[Study]) -> Vec<Panel> {
    [panel(sweeps(studies)[FIXED], "position", "Sensors misplaced by 10 cm", &POSITION, &TOTAL)].into()
}

fn angles(study: &LocalizationReport, enabled: &[LocalizerName]) -> Vec<Panel> {
    [
        panel(study, PAPER_MAE.name, "MAE as in the paper, of the columns of Q", &PAPER_MAE, enabled),
        panel(study, ANGLE.name, "Angle of the rotation error", &ANGLE, enabled),
    ]
    .into()
}

pub(super) fn sweeps(studies: &[Study]) -> Vec<&LocalizationReport> {
    studies.iter().filter_map(Study::sweep).collect()
}

fn panel(
    study: &LocalizationReport,
    name: &str,
    title: &str,
    quantity: &Quantity,
    enabled: &[LocalizerName],
) -> Panel {
    let estimators = enabled.iter().filter_map(|name| estimator(study, *name, quantity.error));
    let bounds = quantity.bounds.iter().filter_map(|(kind, read)| bound(study, *kind, *read));
    Panel {
        name: name.to_string(),
        title: title.to_string(),
        x: Axis::linear("reference range zeta", "dB"),
        y: (quantity.axis)(),
        curves: estimators.chain(bounds).collect(),
    }
}

fn zeta_db(study: &LocalizationReport, point: usize) -> Option<f64> {
    match study.points.get(point)?.noise {
        RangeNoise::Toa { zeta_db } => Some(zeta_db),
        _ => None,
    }
}

fn estimator(study: &LocalizationReport, name: LocalizerName, read: Read) -> Option<Curve> {
    let report = study.estimators.iter().find(|report| report.name == name)?;
    let point = |(k, summary)| {
        let summary: &crate::study::localization::report::SnapshotSummary = summary;
        Some(Point {
            x: zeta_db(study, k)?,
            y: read(summary).filter(|_| summary.trials > 0)?,
            trials: summary.trials,
            failures: summary.failures,
            reflections: summary.reflection_rate,
        })
    };
    Some(Curve {
        name: name.to_string(),
        label: report.label.clone(),
        kind: CurveKind::Estimator,
        points: report.points.iter().enumerate().filter_map(point).collect(),
    })
}

fn bound(study: &LocalizationReport, kind: SnapshotBound, read: ReadBound) -> Option<Curve> {
    let report = study.bounds.iter().find(|report| report.name == kind.name())?;
    let points = report.points.iter().enumerate().filter_map(|(k, summary)| {
        Some(Point {
            x: zeta_db(study, k)?,
            y: read(summary)?,
            trials: summary.trials,
            failures: study.trials - summary.trials,
            reflections: None,
        })
    });
    Some(Curve {
        name: report.name.clone(),
        label: report.label.clone(),
        kind: CurveKind::Bound,
        points: points.collect(),
    })
}

fn times(estimate: Estimate, factor: f64) -> Estimate {
    Estimate { value: estimate.value * factor, standard_error: estimate.standard_error * factor }
}
