//! Anchors and body, seen along the normal of the plane.

use super::colours::{INK, PAPER};
use crate::cli::field::grid::{Grid, lifted};
use crate::cli::picture::canvas::{Canvas, Frame, LINE, text_width};

/// Half of the height of an anchor's box, pixels.
const HALF: usize = LINE / 2 + 1;
/// In the box of the best place of one more anchor.
pub const NEXT: &str = "+";
/// Half of an arm of the body's cross.
const ARM: usize = 7;

pub fn draw(canvas: &mut Canvas, frame: Frame, grid: &Grid) {
    let place = |point: [f64; 3]| frame.pixel(super::place(grid, point));
    for (m, anchor) in grid.scenario.anchors.iter().enumerate() {
        anchor_box(canvas, place(lifted(anchor)), &(m + 1).to_string());
    }
    cross(canvas, place(grid.body()));
    if let Some(best) = &grid.best {
        anchor_box(canvas, place(lifted(&best.point)), NEXT);
    }
}

/// An anchor: its number in a box, readable on every colour.
pub fn anchor_box(canvas: &mut Canvas, [x, y]: [usize; 2], number: &str) {
    let width = text_width(number) + 6;
    let (left, top) = (x.saturating_sub(width / 2), y.saturating_sub(HALF));
    let frame = Frame { left, top, width, height: 2 * HALF };
    canvas.fill(frame, PAPER);
    canvas.border(frame, INK);
    canvas.text([left + 3, top + 1], number, INK);
}

/// The body.
pub fn cross(canvas: &mut Canvas, [x, y]: [usize; 2]) {
    for (half, reach, colour) in [(2, ARM + 1, PAPER), (1, ARM, INK)] {
        for (across, up) in [(half, reach), (reach, half)] {
            let (left, top) = (x.saturating_sub(across), y.saturating_sub(up));
            canvas.fill(Frame { left, top, width: 2 * across + 1, height: 2 * up + 1 }, colour);
        }
    }
}
