//! A run as comma-separated values.

use alloc::borrow::ToOwned;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::{EstimatorRun, PoseErrors, Run, StepRecord};
use crate::math::float::sqrt;

/// A header, then a row for each estimator and step. What is not known is left empty.
pub fn table(run: &Run) -> String {
    let mut text = header(run).join(",") + "\n";
    for estimator in &run.estimators {
        for (k, step) in estimator.steps.iter().enumerate() {
            text += &row(run, estimator, k, step).join(",");
            text += "\n";
        }
    }
    text
}

fn header(run: &Run) -> Vec<String> {
    let axes = 1..=run.dimension;
    let mut names: Vec<String> = ["estimator", "step", "time_s"].map(ToOwned::to_owned).into();
    for i in axes.clone() {
        names.extend(axes.clone().map(|j| format!("orientation_{i}{j}")));
    }
    names.extend(axes.map(|i| format!("position_{i}_m")));
    let rest = [
        "orientation_covariance_trace",
        "position_covariance_trace_m2",
        "defect",
        "event",
        "nis",
        "nis_degrees_of_freedom",
        "orientation_error_frobenius",
        "orientation_error_rad",
        "position_error_m",
        "nees",
        "nees_degrees_of_freedom",
    ];
    names.extend(rest.map(ToOwned::to_owned));
    for bound in &run.bounds {
        names.push(format!("{}_orientation_rad", bound.name));
        names.push(format!("{}_position_m", bound.name));
    }
    names
}

fn row(run: &Run, estimator: &EstimatorRun, k: usize, step: &StepRecord) -> Vec<String> {
    let mut cells = Vec::from([estimator.name.to_string(), k.to_string(), number(step.time)]);
    cells.extend(step.posterior.orientation.iter().flatten().copied().map(number));
    cells.extend(step.posterior.position.iter().copied().map(number));
    cells.push(number(step.covariance_trace.orientation));
    cells.push(number(step.covariance_trace.position));
    cells.push(number(step.defect));
    cells.push(u8::from(step.event).to_string());
    cells.push(number(step.nis.value));
    cells.push(step.nis.degrees_of_freedom.to_string());
    let error = |read: fn(&PoseErrors) -> f64| optional(step.errors.as_ref().map(read));
    cells.push(error(|e| e.orientation_frobenius));
    cells.push(error(|e| e.angle));
    cells.push(error(|e| e.position));
    cells.push(optional(step.nees.map(|nees| nees.value)));
    cells.push(step.nees.map(|nees| nees.degrees_of_freedom.to_string()).unwrap_or_default());
    for bound in &run.bounds {
        let record = bound.steps.get(k).and_then(Option::as_ref);
        cells.push(optional(record.and_then(|record| record.angle_variance).map(sqrt)));
        cells.push(optional(record.map(|record| sqrt(record.position_trace))));
    }
    cells
}

fn optional(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

/// The shortest text that reads back as the same bits, with an exponent where the number is tiny or huge.
fn number(value: f64) -> String {
    format!("{value:?}")
}
