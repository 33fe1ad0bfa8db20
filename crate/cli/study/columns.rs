//! A study as comma-separated values.

use rangelab::study::moments::Estimate;
use rangelab::study::report::{BoundSummary, StudyReport};
use rangelab::study::tally::Summary;

/// Figures with a standard error: name of the column, and where an estimator and a bound have it.
type Figure = (&'static str, fn(&Summary) -> Estimate, Option<fn(&BoundSummary) -> Estimate>);

const FIGURES: [Figure; 12] = [
    ("rmse_orientation_frobenius", |s| s.rmse_orientation, Some(|b| b.orientation)),
    ("rmse_position_m", |s| s.rmse_position, Some(|b| b.position)),
    ("rms_angle_rad", |s| s.rms_angle, Some(|b| b.angle)),
    ("paper_mae_sqrt_rad", |s| s.paper_mae, None),
    ("bias_orientation_frobenius", |s| s.bias_orientation, None),
    ("bias_position_m", |s| s.bias_position, None),
    ("claimed_orientation_frobenius", |s| s.claimed_orientation, None),
    ("claimed_position_m", |s| s.claimed_position, None),
    ("nees_per_degree_of_freedom", |s| s.nees, None),
    ("nis_per_degree_of_freedom", |s| s.nis, None),
    ("event_rate", |s| s.event_rate, None),
    ("reflection_rate", |s| s.reflection_rate, None),
];

/// A header, then a row for each estimator and step, then one for each bound and step. What there is not is left empty.
pub fn csv(report: &StudyReport) -> String {
    let mut header = ["kind", "name", "step", "trials", "failures"].map(str::to_owned).to_vec();
    header
        .extend(FIGURES.iter().flat_map(|(name, ..)| [(*name).to_owned(), format!("{name}_standard_error")]));
    let mut rows = vec![header];
    for estimator in &report.estimators {
        for (step, summary) in estimator.steps.iter().enumerate() {
            let mut row = vec!["estimator".to_owned(), estimator.name.to_string(), step.to_string()];
            row.extend([summary.trials, summary.failures].map(|count| count.to_string()));
            row.extend(FIGURES.iter().flat_map(|(_, of, _)| cells(Some(of(summary)))));
            rows.push(row);
        }
    }
    for bound in &report.bounds {
        for (step, summary) in bound.steps.iter().enumerate() {
            let mut row = vec!["bound".to_owned(), bound.name.clone(), step.to_string()];
            row.extend([summary.trials.to_string(), (report.trials - summary.trials).to_string()]);
            row.extend(FIGURES.iter().flat_map(|(_, _, of)| cells(of.map(|of| of(summary)))));
            rows.push(row);
        }
    }
    rows.iter().map(|row| row.join(",") + "\n").collect()
}

fn cells(estimate: Option<Estimate>) -> [String; 2] {
    estimate.map_or_else(Default::default, |estimate| {
        [estimate.value, estimate.standard_error].map(|number| format!("{number:?}"))
    })
}
