//! A study as a table for people.

use std::iter::repeat_n;

use rangelab::bounds::BoundKind;
use rangelab::study::moments::Estimate;
use rangelab::study::report::{EstimatorReport, StudyReport};
use rangelab::study::tally::Summary;

use super::comparison::{bound, bound_of};

const HEADER: [&str; 11] = [
    "",
    "RMSE Q",
    "/bound",
    "angle, deg",
    "RMSE t, m",
    "/bound",
    "RMSE/claimed Q",
    "NEES/dof",
    "projected",
    "mirrored",
    "failed",
];
/// The bounds that an estimator at that step can be held against: those that know all steps before.
const BOUNDS: [BoundKind; 3] =
    [BoundKind::LinearPosteriorCrb, BoundKind::PosteriorCrb, BoundKind::PosteriorCrbRaw];
const LEGEND: &str = "\
Each figure ± its standard error; a figure alone is certain to the digits shown, or of one trial.
  RMSE Q          root mean square of ||Q_hat - Q||_F, Q_hat as reported; angle: of the rotation nearest to it
  /bound          ratio to posterior_crb, for ESKF raw to posterior_crb_raw
  RMSE/claimed Q  ratio to sqrt(tr P_q), what the estimator's own covariance claims; 1 where it is right
  NEES/dof        squared error in units of the claimed covariance; 1 where it is right
  projected       share of the trials in which Q was projected onto the rotations
  mirrored        share of the trials in which the reported Q mirrors the body
  failed          trials that ended in an error by this step
Bounds (the others by --format csv). They average over all that the initial covariance holds possible: where a scenario
starts closer to the truth than that and the ranges see little, errors can lie below them.";

type Row = Vec<String>;

/// Estimators and bounds at the given steps.
pub fn table(report: &StudyReport, steps: &[usize]) -> String {
    let sections: Vec<Vec<Row>> = steps.iter().map(|&step| section(report, step)).collect();
    let kept: Vec<usize> = (0..HEADER.len())
        .filter(|&column| column == 0 || sections.iter().flatten().any(|row| !row[column].is_empty()))
        .collect();
    let widths: Vec<usize> = kept.iter().map(|&column| width(&sections, column)).collect();
    let line = |row: &[String]| {
        let cells = kept.iter().zip(&widths).map(|(&column, &width)| format!("{:<width$}", row[column]));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    let name = if report.name.is_empty() { "no name" } else { &report.name };
    let mut text = format!("{name}: {} trials\n", report.trials);
    for (step, rows) in steps.iter().zip(&sections) {
        let mut header = HEADER.map(str::to_owned);
        header[0] = format!("step {step}");
        text += "\n";
        text += &line(&header);
        text.extend(rows.iter().map(|row| line(row)));
    }
    text + "\n" + &legend(&kept)
}

fn section(report: &StudyReport, step: usize) -> Vec<Row> {
    let estimators = report.estimators.iter().map(|estimator| estimator_row(report, estimator, step));
    estimators.chain(BOUNDS.iter().filter_map(|&kind| bound_row(report, kind, step))).collect()
}

fn estimator_row(report: &StudyReport, estimator: &EstimatorReport, step: usize) -> Row {
    let summary = &estimator.steps[step];
    let failed = if summary.failures > 0 { summary.failures.to_string() } else { String::new() };
    if summary.trials == 0 {
        let empty = repeat_n(String::new(), HEADER.len() - 2);
        return [estimator.label.clone()].into_iter().chain(empty).chain([failed]).collect();
    }
    let bound = bound(report, bound_of(estimator.name), step);
    let over = |of: Estimate, by: Option<Estimate>| optional(by.and_then(|by| of.over(by)));
    vec![
        estimator.label.clone(),
        summary.rmse_orientation.to_string(),
        over(summary.rmse_orientation, bound.map(|bound| bound.orientation)),
        degrees(summary.rms_angle).to_string(),
        summary.rmse_position.to_string(),
        over(summary.rmse_position, bound.map(|bound| bound.position)),
        over(summary.rmse_orientation, Some(summary.claimed_orientation)),
        summary.nees.to_string(),
        rate(estimator, |summary| summary.event_rate, step),
        rate(estimator, |summary| summary.reflection_rate, step),
        failed,
    ]
}

fn bound_row(report: &StudyReport, kind: BoundKind, step: usize) -> Option<Row> {
    let bound = bound(report, kind, step)?;
    let mut row = vec![String::new(); HEADER.len()];
    kind.name().clone_into(&mut row[0]);
    row[1] = bound.orientation.to_string();
    row[3] = degrees(bound.angle).to_string();
    row[4] = bound.position.to_string();
    Some(row)
}

/// A share of the trials; left empty for an estimator for which it is 0 in every step, as it never happens.
fn rate(estimator: &EstimatorReport, of: fn(&Summary) -> Estimate, step: usize) -> String {
    let happens = estimator.steps.iter().any(|summary| of(summary).value > 0.0);
    if happens { of(&estimator.steps[step]).to_string() } else { String::new() }
}

fn degrees(angle: Estimate) -> Estimate {
    Estimate { value: angle.value.to_degrees(), standard_error: angle.standard_error.to_degrees() }
}

fn optional(estimate: Option<Estimate>) -> String {
    estimate.map(|estimate| estimate.to_string()).unwrap_or_default()
}

fn width(sections: &[Vec<Row>], column: usize) -> usize {
    let cells = sections.iter().flatten().map(|row| row[column].chars().count());
    let header = if column == 0 { "step 9999" } else { HEADER[column] };
    cells.chain([header.len()]).max().unwrap_or(0)
}

/// Explains the columns that are there.
fn legend(kept: &[usize]) -> String {
    let absent =
        |line: &str| (8..HEADER.len()).any(|i| !kept.contains(&i) && line.trim().starts_with(HEADER[i]));
    let lines = LEGEND.lines().filter(|line| !absent(line)).map(|line| format!("{line}\n"));
    let bounds = BOUNDS.iter().map(|kind| format!("  {:<22}{}\n", kind.name(), kind.label()));
    lines.chain(bounds).collect()
}
