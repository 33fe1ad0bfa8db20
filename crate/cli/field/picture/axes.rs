//! Ticks, numbers and names along the edges of a field.

use rangelab::model::field_settings::FieldPlane;

use super::colours::INK;
use super::{dot, length};
use crate::cli::field::grid::Grid;
use crate::cli::picture::canvas::{Canvas, Frame, LINE, text_width};
use crate::cli::picture::scale::{short, ticks};

const TICK: usize = 6;

pub fn draw(canvas: &mut Canvas, frame: Frame, grid: &Grid) {
    let [across, up] = names(&grid.scenario.field.plane);
    let Frame { left, top, width, .. } = frame;
    canvas.border(frame, INK);
    let mut free = 0;
    for (part, text) in numbers(grid, &grid.layout.u) {
        let [x, _] = frame.pixel([part, 0.0]);
        canvas.fill(Frame { left: x, top: frame.bottom(), width: 1, height: TICK }, INK);
        let start = x.saturating_sub(text_width(&text) / 2);
        // Long numbers, of places far away, would run into each other.
        if start >= free {
            canvas.text([start, frame.bottom() + TICK + 2], &text, INK);
            free = start + text_width(&text) + TICK;
        }
    }
    let middle = (left + width / 2).saturating_sub(text_width(across) / 2);
    canvas.text([middle, frame.bottom() + TICK + 2 + LINE + 4], across, INK);
    for (part, text) in numbers(grid, &grid.layout.v) {
        let [_, y] = frame.pixel([0.0, part]);
        canvas.fill(Frame { left: left - TICK, top: y, width: TICK, height: 1 }, INK);
        canvas.text([(left - TICK - 2).saturating_sub(text_width(&text)), y - LINE / 2], &text, INK);
    }
    canvas.text([12, top - LINE - 12], up, INK);
}

fn names(plane: &FieldPlane) -> [&'static str; 2] {
    match plane {
        FieldPlane::Level | FieldPlane::Horizontal { .. } => ["x, m", "y, m"],
        FieldPlane::Vertical { .. } => ["along the heading, m", "z, m"],
        FieldPlane::Body => ["the body's x, m", "the body's y, m"],
    }
}

/// Parts of an edge with the numbers there.
fn numbers(grid: &Grid, edge: &[f64; 3]) -> Vec<(f64, String)> {
    let whole = length(edge);
    let mut first = dot(&grid.layout.corner, edge) / whole;
    if grid.scenario.field.plane == FieldPlane::Body {
        first -= dot(&grid.body(), edge) / whole;
    }
    ticks(first, first + whole).into_iter().map(|tick| ((tick - first) / whole, short(tick))).collect()
}
