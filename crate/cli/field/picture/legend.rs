//! What the marks and hatches mean.

use super::colours::{INK, NO_BOUND, PAPER, cross_hatched, hatched};
use super::marks;
use crate::cli::field::grid::Grid;
use crate::cli::picture::canvas::{Canvas, Colour, Frame, LINE, text_width};
use crate::cli::picture::scale::short;

const SWATCH: usize = 24;
const GAP: usize = 20;
/// The legend ends so far above the lower edge.
const FROM_BELOW: usize = 12;

/// One line at the foot of the picture.
pub fn draw(canvas: &mut Canvas, frame: Frame, grid: &Grid) {
    let top = canvas.height - LINE - FROM_BELOW;
    let middle = top + LINE / 2;
    let mut left = frame.left;
    marks::anchor_box(canvas, [left + SWATCH / 2, middle], "1");
    left = word(canvas, [left, top], "anchor");
    marks::cross(canvas, [left + SWATCH / 2, middle]);
    left = word(canvas, [left, top], "body");
    if let Some(limit) = grid.limit {
        swatch(canvas, [left, top], PAPER, hatched);
        left = word(canvas, [left, top], &format!("worse than {} {}", short(limit), grid.unit()));
    }
    if grid.values.contains(&None) {
        swatch(canvas, [left, top], NO_BOUND, cross_hatched);
        word(canvas, [left, top], "no bound: not all is seen");
    }
}

fn swatch(canvas: &mut Canvas, [left, top]: [usize; 2], ground: Colour, line: fn(usize, usize) -> bool) {
    let swatch = Frame { left, top, width: SWATCH, height: LINE };
    for j in 0..swatch.height {
        for i in 0..swatch.width {
            canvas.set(left + i, top + j, if line(i, j) { INK } else { ground });
        }
    }
    canvas.border(swatch, INK);
}

/// A word beside its sign; gives where the next sign begins.
fn word(canvas: &mut Canvas, [left, top]: [usize; 2], text: &str) -> usize {
    let left = left + SWATCH + 6;
    canvas.text([left, top], text, INK);
    left + text_width(text) + GAP
}
