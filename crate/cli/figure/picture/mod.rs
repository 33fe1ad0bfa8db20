//! A figure as a picture: panels, key, caption, and a table of what is claimed.

mod axes;
mod drawing;
mod looks;
mod pixels;
mod svg;

use rangelab::study::figures::claim::{Claim, Verdict};
use rangelab::study::figures::report::{Curve, FigureReport};

use super::table::rows;
use crate::cli::failure::Failure;
use crate::cli::picture::canvas::{LINE, text_width};
use crate::cli::text::wrapped;
use axes::Frame;
use drawing::{Drawing, Group, Shape, Side};
use looks::{INK, Look, SOFT, WARNING};

const WIDTH: f64 = 1240.0;
const EDGE: f64 = 24.0;
const COLUMNS: usize = 2;
/// Frame of a panel, and how far it is from panel to panel.
const PANEL: [f64; 2] = [520.0, 280.0];
const PITCH: [f64; 2] = [600.0, 384.0];
/// From the corner of a panel's place to that of its frame.
const INSET: [f64; 2] = [72.0, 56.0];
const ROW: f64 = LINE as f64 + 4.0;
/// From an entry of the key to the next.
const GAP: f64 = 24.0;
const SWATCH: f64 = 40.0;

/// The picture as SVG, its metadata JSON with command and scenarios.
pub fn svg(report: &FigureReport) -> String {
    svg::svg(&draw(report), &report.heading(), &report.caption, &metadata(report))
}

/// The picture as a PNG file; the chunks `Command` and `Scenarios` (iTXt) say how it came about.
pub fn png(report: &FigureReport) -> Result<Vec<u8>, Failure> {
    let unmade =
        |error: &dyn std::fmt::Display| Failure::Other(format!("the picture cannot be made: {error}"));
    let canvas = pixels::pixels(&draw(report)).ok_or_else(|| unmade(&"it has no pixels"))?;
    let texts = [
        ("Title", report.heading()),
        ("Description", report.caption.clone()),
        ("Command", report.command.clone()),
        ("Scenarios", scenarios(report)),
    ];
    canvas.png(&texts).map_err(|error| unmade(&error))
}

fn metadata(report: &FigureReport) -> String {
    format!("{{\"command\": \"{}\", \"scenarios\": {}}}", report.command, scenarios(report))
}

fn scenarios(report: &FigureReport) -> String {
    serde_json::to_string(&report.scenarios).expect("numbers and texts always have a JSON form")
}

fn draw(report: &FigureReport) -> Drawing {
    let mut head = Group::new("");
    let mut y = EDGE;
    let text = report.heading();
    head.shapes.push(Shape::Text { at: [EDGE, y], text, colour: INK, side: Side::Start, strong: true });
    y += ROW;
    let detail = format!("{} trials; bands of two standard errors. {}", report.trials, report.command);
    head.text([EDGE, y], detail, SOFT, Side::Start);
    y += 1.4 * ROW;
    let mut groups = vec![head];
    groups.push(key(report, &mut y));
    for (index, panel) in report.panels.iter().enumerate() {
        let corner = [index % COLUMNS, index / COLUMNS].map(|place| place as f64);
        let [left, top] = [INSET[0] + corner[0] * PITCH[0], y + INSET[1] + corner[1] * PITCH[1]];
        let [width, height] = PANEL;
        groups.extend(axes::draw(panel, Frame { left, top, width, height }));
    }
    y += report.panels.len().div_ceil(COLUMNS) as f64 * PITCH[1] + ROW;
    groups.push(caption(report, &mut y));
    groups.push(claims(report, &mut y));
    Drawing { width: pixels_of(WIDTH), height: pixels_of(y + EDGE), groups }
}

/// Every curve once, however many panels show it.
fn key(report: &FigureReport, y: &mut f64) -> Group {
    let mut group = Group::new("");
    let mut shown: Vec<&Curve> = Vec::new();
    for curve in report.panels.iter().flat_map(|panel| &panel.curves) {
        if !shown.iter().any(|other| other.label == curve.label) {
            shown.push(curve);
        }
    }
    let mut x = EDGE;
    for curve in shown {
        let width = SWATCH + 8.0 + text_width(&curve.label) as f64;
        if x + width > WIDTH - EDGE {
            (x, *y) = (EDGE, *y + ROW);
        }
        let Look { colour, mark, dash } = Look::of(curve);
        let points = vec![[x, *y], [x + SWATCH, *y]];
        group.shapes.push(Shape::Line { points, colour, width: 1.75, dash });
        if let Some(mark) = mark {
            mark.draw(&mut group, [x + SWATCH / 2.0, *y], colour);
        }
        group.text([x + SWATCH + 8.0, *y], &curve.label, INK, Side::Start);
        x += width + GAP;
    }
    *y += ROW;
    group
}

fn caption(report: &FigureReport, y: &mut f64) -> Group {
    let mut group = Group::new("");
    let letters = pixels_of(WIDTH - 2.0 * EDGE) / text_width("x");
    for line in wrapped(&report.caption, letters) {
        group.text([EDGE, *y], line, INK, Side::Start);
        *y += ROW;
    }
    *y += ROW;
    group
}

/// Claim, number, target and verdict in columns; what does not hold is set off.
fn claims(report: &FigureReport, y: &mut f64) -> Group {
    let mut group = Group::new("");
    let claims: Vec<&Claim> = report.claims.iter().collect();
    let header = ["claim", "found", "target", "verdict"].map(str::to_owned);
    let rows = [header].into_iter().chain(rows(&claims)).collect::<Vec<_>>();
    let width = |column: usize| rows.iter().map(|row| text_width(&row[column])).max().unwrap_or(0) as f64;
    for (i, row) in rows.iter().enumerate() {
        let fails = i > 0 && claims[i - 1].verdict == Verdict::DoesNotHold;
        let colour = if i == 0 {
            SOFT
        } else if fails {
            WARNING
        } else {
            INK
        };
        let mut x = EDGE;
        for (column, text) in row.iter().enumerate() {
            group.text([x, *y], text, colour, Side::Start);
            x += width(column) + 1.5 * GAP;
        }
        *y += ROW;
    }
    group
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a size of a picture")]
fn pixels_of(length: f64) -> usize {
    length.ceil() as usize
}
