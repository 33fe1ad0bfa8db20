//! The colour bar.

use super::colours::{INK, colour_at};
use crate::cli::picture::canvas::{Canvas, Frame, LINE};
use crate::cli::picture::scale::{Scale, short};

const GAP: usize = 24;
const WIDTH: usize = 20;
const TICK: usize = 6;

/// Beside the frame, with a number at each level: the contour lines are there.
pub fn draw(canvas: &mut Canvas, frame: Frame, unit: &str, scale: Scale) {
    let bar = Frame { left: frame.right() + GAP, width: WIDTH, ..frame };
    for j in 0..bar.height {
        let [_, place] = bar.place(0, j);
        canvas.fill(Frame { top: bar.top + j, height: 1, ..bar }, colour_at(place));
    }
    canvas.border(bar, INK);
    for level in scale.levels() {
        let [_, y] = bar.pixel([0.0, scale.place(level)]);
        canvas.fill(Frame { left: bar.right(), top: y, width: TICK, height: 1 }, INK);
        canvas.text([bar.right() + TICK + 4, y - LINE / 2], &short(level), INK);
    }
    if scale.more {
        canvas.text([bar.right() + TICK + 4, bar.top - LINE / 2], "and more", INK);
    }
    canvas.text([bar.left, bar.top - LINE - 12], &format!("{unit}, log scale"), INK);
}
