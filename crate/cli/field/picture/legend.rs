//! What the marks and hatches mean.

use super::colours::{INK, NO_BOUND, PAPER, cross_hatched, hatched};
use super::{marks, obstacles};
use crate::cli::field::grid::Grid;
use crate::cli::picture::canvas::{Canvas, Colour, Frame, LINE, text_width};
use crate::cli::picture::scale::short;

const SWATCH: usize = 24;
const GAP: usize = 20;
/// The legend ends so far above the lower edge.
const FROM_BELOW: usize = 12;

/// From one line of the legend to the next.
pub const LINE_HEIGHT: usize = LINE + 8;

/// Whether obstacles or the best place of one more anchor have to be explained.
pub fn has_second_line(grid: &Grid) -> bool {
    grid.best.is_some() || !obstacles::outlines(grid).is_empty()
}

/// Lines at the foot of the picture.
pub fn draw(canvas: &mut Canvas, frame: Frame, grid: &Grid) {
    second(canvas, frame, grid);
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
        let text = if grid.of_next_anchor() { "no value" } else { "no bound: not all is seen" };
        word(canvas, [left, top], text);
    }
}

/// The line above: what is drawn only in some pictures.
fn second(canvas: &mut Canvas, frame: Frame, grid: &Grid) {
    let top = canvas.height - LINE - FROM_BELOW - LINE_HEIGHT;
    let mut left = frame.left;
    if grid.best.is_some() {
        marks::anchor_box(canvas, [left + SWATCH / 2, top + LINE / 2], marks::NEXT);
        left = word(canvas, [left, top], "best next anchor");
    }
    let outlines = obstacles::outlines(grid);
    for (stroke, text) in [
        (obstacles::CROSSING, "wall or box"),
        (obstacles::BESIDE, "above or below"),
        (obstacles::KEEP_OUT, "keep out"),
    ] {
        if outlines.iter().any(|outline| outline.stroke == stroke) {
            let sample = Frame { left, top, width: SWATCH, height: LINE };
            canvas.line(sample, [0.0, 0.5], [1.0, 0.5], stroke);
            left = word(canvas, [left, top], text);
        }
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
