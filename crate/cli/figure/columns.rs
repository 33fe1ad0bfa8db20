//! A figure as comma-separated values.

use std::fmt::Write;

use rangelab::study::figures::report::{CurveKind, FigureReport, Point};

const HEADER: &str = "panel,curve,kind,x,y,y_standard_error,trials,failures,reflection_rate,\
                      reflection_rate_standard_error";

/// Comments with title, command, claims, axes and scenarios; then a row for each point of each curve.
pub fn csv(report: &FigureReport) -> String {
    let mut text = format!("# {}\n# {}\n# {}\n", report.heading(), report.command, report.caption);
    text.extend(report.claims.iter().map(|claim| format!("# claim: {claim}\n")));
    for panel in &report.panels {
        let _ = writeln!(text, "# panel {}: x: {}, y: {}", panel.name, panel.x.name(), panel.y.name());
    }
    for named in &report.scenarios {
        let _ = writeln!(text, "# scenario {}: {}", named.name, named.scenario.to_json().trim_end());
    }
    text += HEADER;
    text.push('\n');
    for panel in &report.panels {
        for curve in &panel.curves {
            let kind = kind(curve.kind);
            let row = |point| format!("{},{},{kind},{}\n", panel.name, curve.name, numbers(point));
            text.extend(curve.points.iter().map(row));
        }
    }
    text
}

fn kind(kind: CurveKind) -> &'static str {
    match kind {
        CurveKind::Estimator => "estimator",
        CurveKind::Covariance => "covariance",
        CurveKind::Bound => "bound",
    }
}

fn numbers(point: &Point) -> String {
    let Point { x, y, trials, failures, reflections } = point;
    let [rate, error] = reflections.map_or_else(Default::default, |rate| {
        [rate.value, rate.standard_error].map(|number| format!("{number:?}"))
    });
    format!("{x:?},{:?},{:?},{trials},{failures},{rate},{error}", y.value, y.standard_error)
}
