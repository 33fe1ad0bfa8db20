//! What projections cost and give, for people and for plots.

use rangelab::model::estimator_settings::ThresholdKind;
use rangelab::study::budget::{BudgetReport, BudgetRow};
use rangelab::study::moments::Estimate;

const HEADER: [&str; 7] =
    ["epsilon", "projections", "RMSE Q, first", "all steps", "last", "angle, deg, first", "all steps"];
const LEGEND: &str = "\
Each figure ± its standard error; all thresholds get the same random numbers.
  epsilon      threshold of the event trigger; the paper's is 0.15
  projections  of Q onto the rotations, in a run
  RMSE Q       root mean square of ||Q_hat - Q||_F, Q_hat as reported: at the first step, over all, at the last
  angle        of the rotation nearest to Q_hat\n";

pub fn table(report: &BudgetReport) -> String {
    let rows: Vec<Vec<String>> = report.rows.iter().map(row).collect();
    let width = |column: usize| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.chain([HEADER[column].len()]).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..HEADER.len()).map(width).collect();
    let line = |cells: &[String]| {
        let cells = cells.iter().zip(&widths).map(|(cell, &width)| format!("{cell:<width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    let name = if report.name.is_empty() { "no name" } else { &report.name };
    let scale = if report.kind == ThresholdKind::Relative { ", epsilon times sqrt(tr P_q)" } else { "" };
    let mut text = format!("{name}: ET-KF, {} trials{scale}\n\n", report.trials);
    text += &line(&HEADER.map(str::to_owned));
    text.extend(rows.iter().map(|row| line(row)));
    let failed = report.rows.iter().filter(|row| row.failures > 0);
    text.extend(
        failed.map(|row| format!("epsilon {}: {} trials ended in an error\n", row.epsilon, row.failures)),
    );
    text + "\n" + LEGEND
}

fn row(row: &BudgetRow) -> Vec<String> {
    let degrees = |angle: Estimate| Estimate {
        value: angle.value.to_degrees(),
        standard_error: angle.standard_error.to_degrees(),
    };
    let figures = [
        row.projections,
        row.orientation.first,
        row.orientation.all,
        row.orientation.last,
        degrees(row.angle.first),
        degrees(row.angle.all),
    ];
    [row.epsilon.to_string()].into_iter().chain(figures.map(|figure| figure.to_string())).collect()
}

pub fn csv(report: &BudgetReport) -> String {
    let names = ["projections", "rmse_orientation_frobenius", "rms_angle_rad"];
    let places = ["first_step", "all_steps", "last_step"];
    let along = names[1..].iter().flat_map(|name| places.map(|place| format!("{name}_{place}")));
    let figures = [names[0].to_owned()].into_iter().chain(along);
    let with_errors = figures.flat_map(|name| [name.clone(), format!("{name}_standard_error")]);
    let header: Vec<String> =
        ["epsilon", "failures"].map(str::to_owned).into_iter().chain(with_errors).collect();
    let mut lines = vec![header.join(",") + "\n"];
    for row in &report.rows {
        let (q, angle) = (row.orientation, row.angle);
        let figures = [row.projections, q.first, q.all, q.last, angle.first, angle.all, angle.last];
        let cells = figures.map(|figure| format!("{:?},{:?}", figure.value, figure.standard_error));
        lines.push(format!("{:?},{},{}\n", row.epsilon, row.failures, cells.join(",")));
    }
    lines.concat()
}
