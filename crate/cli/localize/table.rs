//! A snapshot as a table for people, and as comma-separated values.

use rangelab::math::float::degrees;
use rangelab::study::localization::run::{SnapshotBoundFigures, SnapshotEstimate, SnapshotRun};

const HEADER: [&str; 7] = ["", "error Q", "angle, deg", "error t, m", "error S, m", "iterations", "optimum"];
const LEGEND: &str = "Errors against the truth of this trial; bounds are least root mean square errors, below which one error may well lie.
  error Q     ||Q_hat - Q||_F; angle: of the rotation nearest to Q_hat
  error t     distance of the position from the true one; S: root of the sum over the sensors
  iterations  until the estimator's own rule stopped it
  optimum     formula: there is no other; certified: proven to be the best; searched, local: not proven
";

/// Estimators, then bounds, then what the columns mean.
pub fn table(run: &SnapshotRun) -> String {
    let estimators = run.estimators.iter().map(estimator_row);
    let bounds = run.bounds.iter().map(bound_row);
    let rows: Vec<[String; 7]> =
        std::iter::once(HEADER.map(str::to_owned)).chain(estimators).chain(bounds).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; 7] = std::array::from_fn(width);
    let line = |row: &[String; 7]| {
        let cells = row.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).chain(failures(run)).chain([LEGEND.to_owned()]).collect()
}

/// Each reason once, behind the estimators that it holds for.
fn failures(run: &SnapshotRun) -> Vec<String> {
    let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
    for estimate in &run.estimators {
        let Some(failure) = &estimate.failure else { continue };
        let reason = failure.strip_prefix(&format!("{}: ", estimate.label)).unwrap_or(failure);
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, labels)) => labels.push(&estimate.label),
            None => reasons.push((reason, vec![&estimate.label])),
        }
    }
    reasons.iter().map(|(reason, labels)| format!("{}: {reason}\n", labels.join(", "))).collect()
}

fn estimator_row(estimate: &SnapshotEstimate) -> [String; 7] {
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:.4}"));
    let errors = estimate.errors.as_ref();
    let done = estimate.failure.is_none();
    let optimum =
        if estimate.reflected { format!("{}, mirrored", estimate.optimum) } else { estimate.optimum.clone() };
    [
        estimate.label.clone(),
        number(errors.map(|e| e.orientation_frobenius)),
        number(errors.map(|e| degrees(e.angle))),
        number(errors.map(|e| e.position)),
        number(done.then_some(estimate.sensors_error)),
        if done { estimate.iterations.to_string() } else { String::new() },
        if done { optimum } else { "no estimate".to_owned() },
    ]
}

fn bound_row(bound: &SnapshotBoundFigures) -> [String; 7] {
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:.4}"));
    [
        bound.label.clone(),
        number(bound.orientation),
        number(bound.angle.map(degrees)),
        number(bound.position),
        number(Some(bound.sensors)),
        String::new(),
        "bound".to_owned(),
    ]
}

/// A header, a row for each estimator, a row for each bound; what there is not is left empty.
pub fn csv(run: &SnapshotRun) -> String {
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:?}"));
    let header =
        "kind,name,orientation_frobenius,angle_rad,position_m,sensors_m,iterations,reflected,optimum";
    let mut rows = vec![header.to_owned()];
    for e in &run.estimators {
        let errors = e.errors.as_ref();
        rows.push(
            [
                "estimator".to_owned(),
                e.name.to_string(),
                number(errors.map(|e| e.orientation_frobenius)),
                number(errors.map(|e| e.angle)),
                number(errors.map(|e| e.position)),
                number(e.failure.is_none().then_some(e.sensors_error)),
                if e.failure.is_none() { e.iterations.to_string() } else { String::new() },
                if e.failure.is_none() { e.reflected.to_string() } else { String::new() },
                e.optimum.clone(),
            ]
            .join(","),
        );
    }
    for b in &run.bounds {
        let figures = [b.orientation, b.angle, b.position, Some(b.sensors)].map(number);
        rows.push(format!("bound,{},{},,,", b.name, figures.join(",")));
    }
    rows.join("\n")
}
