//! One panel: its frame, its ticks with numbers, and its curves.

use rangelab::study::figures::report::{Axis, AxisScale, Curve, CurveKind, Panel, Point};

use super::drawing::{Group, Place, Shape, Side};
use super::looks::{FRAME, GRID, INK, Look, SOFT};
use crate::cli::picture::canvas::LINE;
use crate::cli::picture::scale::{Scale, short, ticks};

/// The frame of a panel, pixels.
#[derive(Clone, Copy)]
pub struct Frame {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

/// Bands reach so many standard errors to either side, as on the page.
const SPREAD: f64 = 2.0;
/// Pixels from mark to mark on a curve.
const MARK_SPACING: f64 = 34.0;
/// Empty part of a frame at either end of the curves.
const MARGIN: f64 = 0.04;
const TICK: f64 = 5.0;

pub fn draw(panel: &Panel, frame: Frame) -> Vec<Group> {
    let ranges = Ranges::of(panel);
    let mut groups = vec![ground(panel, frame, &ranges)];
    for (index, one) in panel.curves.iter().enumerate() {
        let alone = !panel.curves[..index].iter().any(|other| coincide(one, other));
        let banded = one.kind == CurveKind::Estimator && alone;
        groups.push(curve(one, banded, frame, &ranges));
    }
    // Above all lines, so that a curve is seen where another covers it.
    let curves = panel.curves.iter().enumerate();
    groups.extend(curves.filter_map(|(index, one)| marks(one, index, frame, &ranges)));
    groups
}

/// Whether two curves are one line to the eye: they share a band, which would else grow dark.
fn coincide(one: &Curve, other: &Curve) -> bool {
    let same = |(a, b): (&Point, &Point)| {
        a.x.to_bits() == b.x.to_bits() && (a.y.value - b.y.value).abs() <= 1e-3 * b.y.value.abs()
    };
    one.points.len() == other.points.len() && one.points.iter().zip(&other.points).all(same)
}

/// What the two axes hold.
struct Ranges {
    x: Range,
    y: Range,
}

/// From 0 at `low` to 1 at `high`.
struct Range {
    scale: AxisScale,
    low: f64,
    high: f64,
}

impl Ranges {
    fn of(panel: &Panel) -> Self {
        let points = || panel.curves.iter().flat_map(|curve| &curve.points);
        Self {
            x: Range::of(&panel.x, points().map(|point| point.x)),
            y: Range::of(&panel.y, points().map(|point| point.y.value)),
        }
    }

    fn place(&self, frame: Frame, x: f64, y: f64) -> Place {
        let (s, t) = (self.x.part(x), self.y.part(y).clamp(0.0, 1.0));
        [frame.left + s * frame.width, frame.top + (1.0 - t) * frame.height]
    }
}

impl Range {
    fn of(axis: &Axis, values: impl Iterator<Item = f64>) -> Self {
        let scale = axis.scale;
        let shown = values.filter(|value| value.is_finite() && (scale == AxisScale::Linear || *value > 0.0));
        let (low, high) = shown
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (1.0, 1.0) };
        match scale {
            AxisScale::Linear if low < high => Self { scale, low, high },
            AxisScale::Linear => Self { scale, low: low - 1.0, high: high + 1.0 },
            AxisScale::Log => Self { scale, low: low / 1.25, high: high * 1.25 },
        }
    }

    fn part(&self, value: f64) -> f64 {
        let part = match self.scale {
            AxisScale::Linear => (value - self.low) / (self.high - self.low),
            AxisScale::Log => self.logarithmic().place(value.max(1e-3 * self.low)),
        };
        if self.scale == AxisScale::Linear { MARGIN + (1.0 - 2.0 * MARGIN) * part } else { part }
    }

    fn ticks(&self) -> Vec<f64> {
        match self.scale {
            AxisScale::Linear => ticks(self.low, self.high),
            AxisScale::Log => self.logarithmic().levels(),
        }
    }

    fn logarithmic(&self) -> Scale {
        Scale { low: self.low, high: self.high, more: false }
    }
}

fn ground(panel: &Panel, frame: Frame, ranges: &Ranges) -> Group {
    let mut group = Group::new("");
    let Frame { left, top, width, height } = frame;
    let (right, bottom) = (left + width, top + height);
    for tick in ranges.x.ticks() {
        let [x, _] = ranges.place(frame, tick, ranges.y.low);
        group.line(vec![[x, top], [x, bottom + TICK]], GRID, 1.0);
        group.text([x, bottom + TICK + 11.0], short(tick), SOFT, Side::Middle);
    }
    let mut last = top - LINE as f64;
    for tick in ranges.y.ticks().into_iter().rev() {
        let [_, y] = ranges.place(frame, ranges.x.low, tick);
        group.line(vec![[left - TICK, y], [right, y]], GRID, 1.0);
        // Where ticks are close, a number would hide the one above.
        if y - last >= LINE as f64 {
            group.text([left - TICK - 4.0, y], short(tick), SOFT, Side::End);
            last = y;
        }
    }
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
    group.line(corners.to_vec(), FRAME, 1.0);
    let line = LINE as f64;
    let (title, at) = (panel.title.clone(), [left, top - 2.2 * line]);
    group.shapes.push(Shape::Text { at, text: title, colour: INK, side: Side::Start, strong: true });
    group.text([left, top - line], panel.y.name(), SOFT, Side::Start);
    group.text([left + width / 2.0, bottom + TICK + 12.0 + 1.1 * line], panel.x.name(), SOFT, Side::Middle);
    group
}

fn curve(curve: &Curve, banded: bool, frame: Frame, ranges: &Ranges) -> Group {
    let Look { colour, dash, .. } = Look::of(curve);
    let mut group = Group::new(&curve.label);
    let shown = shown(curve, ranges);
    let edge = |point: &Point, sign: f64| {
        ranges.place(frame, point.x, point.y.value + sign * SPREAD * point.y.standard_error)
    };
    if banded {
        let upper = shown.iter().map(|point| edge(point, 1.0));
        let points = upper.chain(shown.iter().rev().map(|point| edge(point, -1.0))).collect();
        group.shapes.push(Shape::Area { points, colour, opacity: 0.2 });
    }
    let points = shown.iter().map(|point| ranges.place(frame, point.x, point.y.value)).collect();
    group.shapes.push(Shape::Line { points, colour, width: 1.75, dash });
    group
}

fn marks(curve: &Curve, index: usize, frame: Frame, ranges: &Ranges) -> Option<Group> {
    let Look { colour, mark, .. } = Look::of(curve);
    let mark = mark?;
    let mut group = Group::new(&curve.label);
    let shown = shown(curve, ranges);
    // Each curve begins its marks at another point: where curves meet, their marks take turns.
    let every = stride(shown.len(), frame.width);
    for point in shown.iter().skip(every - 1 - index % every).step_by(every) {
        mark.draw(&mut group, ranges.place(frame, point.x, point.y.value), colour);
    }
    Some(group)
}

/// The points that the axis can hold.
fn shown<'a>(curve: &'a Curve, ranges: &Ranges) -> Vec<&'a Point> {
    let log = ranges.y.scale == AxisScale::Log;
    curve.points.iter().filter(|point| !log || point.y.value > 0.0).collect()
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most the number of points")]
fn stride(points: usize, width: f64) -> usize {
    ((MARK_SPACING * points as f64 / width).ceil() as usize).max(1)
}
