//! A figure as comma-separated values.

use alloc::format;
use alloc::string::String;
use core::fmt::Write;

use super::report::{CurveKind, FigureReport, Point};

const HEADER: &str = "panel,curve,kind,x,y,y_standard_error,trials,failures,reflection_rate,\
                      reflection_rate_standard_error";

impl FigureReport {
    /// The figure as comma-separated values: comments with title, command, claims, axes and scenarios; then a row for each
    /// point of each curve.
    pub fn to_csv(&self) -> String {
        let mut text = format!("# {}\n# {}\n# {}\n", self.heading(), self.command, self.caption);
        text.extend(self.claims.iter().map(|claim| format!("# claim: {claim}\n")));
        for panel in &self.panels {
            let _ = writeln!(text, "# panel {}: x: {}, y: {}", panel.name, panel.x.name(), panel.y.name());
        }
        for named in &self.scenarios {
            let _ = writeln!(text, "# scenario {}: {}", named.name, named.scenario.to_json().trim_end());
        }
        text += HEADER;
        text.push('\n');
        for panel in &self.panels {
            for curve in &panel.curves {
                let kind = kind(curve.kind);
                let row = |point| format!("{},{},{kind},{}\n", panel.name, curve.name, numbers(point));
                text.extend(curve.points.iter().map(row));
            }
        }
        text
    }
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
