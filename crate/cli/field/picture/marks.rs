//! Anchors and body, seen along the normal of the plane.

use super::canvas::{Canvas, Frame, text_width};
use super::colours::{INK, PAPER};
use super::dot;
use crate::cli::field::grid::{Grid, lifted};

/// Half of a mark's edge, pixels.
const HALF: usize = 5;

pub fn draw(canvas: &mut Canvas, frame: Frame, grid: &Grid) {
    let place = |point: [f64; 3]| frame.pixel(place(grid, point));
    for (m, anchor) in grid.scenario.anchors.iter().enumerate() {
        let [x, y] = place(lifted(anchor));
        square(canvas, [x, y]);
        let name = (m + 1).to_string();
        canvas.text([x - text_width(&name) / 2, y + HALF + 1], &name, INK);
    }
    cross(canvas, place(grid.body()));
}

/// An anchor.
pub fn square(canvas: &mut Canvas, [x, y]: [usize; 2]) {
    let mark = |half: usize| Frame {
        left: x.saturating_sub(half),
        top: y.saturating_sub(half),
        width: 2 * half + 1,
        height: 2 * half + 1,
    };
    canvas.fill(mark(HALF), INK);
    canvas.fill(mark(HALF - 2), PAPER);
}

/// The body.
pub fn cross(canvas: &mut Canvas, [x, y]: [usize; 2]) {
    for (half, reach, colour) in [(2, HALF + 3, PAPER), (1, HALF + 2, INK)] {
        for (across, up) in [(half, reach), (reach, half)] {
            let (left, top) = (x.saturating_sub(across), y.saturating_sub(up));
            canvas.fill(Frame { left, top, width: 2 * across + 1, height: 2 * up + 1 }, colour);
        }
    }
}

/// Parts of both edges.
fn place(grid: &Grid, point: [f64; 3]) -> [f64; 2] {
    let from_corner = core::array::from_fn(|i| point[i] - grid.layout.corner[i]);
    [grid.layout.u, grid.layout.v].map(|edge| dot(&from_corner, &edge) / dot(&edge, &edge))
}
