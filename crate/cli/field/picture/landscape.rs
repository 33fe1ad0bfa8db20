//! The field itself: colours, hatches and contour lines.

use super::colours::{INK, NO_BOUND, PAPER, colour_at, cross_hatched, hatched, ink_on};
use crate::cli::field::grid::Grid;
use crate::cli::picture::canvas::{Canvas, Frame, LINE, cell, text_width};
use crate::cli::picture::scale::{Scale, short};
use rangelab::math::float::{exp, log};

/// A contour line with fewer pixels gets no number.
const LEAST_LABELLED: usize = 120;

/// The colours of the cells.
pub fn paint(canvas: &mut Canvas, frame: Frame, grid: &Grid, scale: Option<Scale>) {
    let layout = &grid.layout;
    for j in 0..frame.height {
        for i in 0..frame.width {
            let [s, t] = frame.place(i, j);
            let value = grid.values[cell(t, layout.height) * layout.width + cell(s, layout.width)];
            let worse = value.zip(grid.limit).is_some_and(|(value, limit)| value > limit);
            let colour = match (value, scale) {
                (Some(value), Some(scale)) if worse && hatched(i, j) => ink_on(scale.place(value)),
                (Some(value), Some(scale)) => colour_at(scale.place(value)),
                _ if cross_hatched(i, j) => INK,
                _ => NO_BOUND,
            };
            canvas.set(frame.left + i, frame.top + j, colour);
        }
    }
}

/// Lines between pixels that are on two sides of a level, each long one with its number.
pub fn contours(canvas: &mut Canvas, frame: Frame, grid: &Grid, scale: Scale) {
    let levels = scale.levels();
    let above = |i: usize, j: usize| {
        let value = between_cells(grid, frame.place(i, j))?;
        Some(levels.iter().filter(|level| value > **level).count())
    };
    let sides: Vec<Option<usize>> =
        (0..frame.height).flat_map(|j| (0..frame.width).map(move |i| above(i, j))).collect();
    let mut lines: Vec<Vec<[usize; 2]>> = vec![Vec::new(); levels.len()];
    for j in 0..frame.height - 1 {
        for i in 0..frame.width - 1 {
            let at = j * frame.width + i;
            let Some(own) = sides[at] else { continue };
            let others = [sides[at + 1], sides[at + frame.width]];
            let Some(other) = others.into_iter().flatten().find(|other| *other != own) else { continue };
            let level = own.min(other);
            let place = [frame.left + i, frame.top + j];
            canvas.set(place[0], place[1], ink_on(scale.place(levels[level])));
            lines[level].push(place);
        }
    }
    numbers(canvas, frame, &levels, &lines);
}

fn numbers(canvas: &mut Canvas, frame: Frame, levels: &[f64], lines: &[Vec<[usize; 2]>]) {
    let mut written: Vec<Frame> = Vec::new();
    for (level, line) in levels.iter().zip(lines).filter(|(_, line)| line.len() >= LEAST_LABELLED) {
        let text = short(*level);
        let width = text_width(&text) + 4;
        let boxes = line.iter().map(|[x, y]| Frame {
            left: x.saturating_sub(width / 2),
            top: y.saturating_sub(LINE / 2),
            width,
            height: LINE,
        });
        let fits = |label: &Frame| {
            let inside = label.left >= frame.left + 4
                && label.right() + 4 <= frame.right()
                && label.top >= frame.top + 4
                && label.bottom() + 4 <= frame.bottom();
            inside && !written.iter().any(|other| overlap(label, other))
        };
        let fitting: Vec<Frame> = boxes.filter(fits).collect();
        let Some(label) = fitting.get(fitting.len() / 2) else { continue };
        canvas.fill(*label, PAPER);
        canvas.text([label.left + 2, label.top], &text, INK);
        written.push(*label);
    }
}

fn overlap(one: &Frame, other: &Frame) -> bool {
    one.left < other.right()
        && other.left < one.right()
        && one.top < other.bottom()
        && other.top < one.bottom()
}

/// The value at a place between the middles of cells, linear in the logarithm; none beside a cell without a bound.
fn between_cells(grid: &Grid, [s, t]: [f64; 2]) -> Option<f64> {
    let layout = &grid.layout;
    let (columns, across) = neighbours(s, layout.width);
    let (rows, up) = neighbours(t, layout.height);
    let mut sum = 0.0;
    for (row, share_of_row) in rows.into_iter().zip(up) {
        for (column, share) in columns.into_iter().zip(across) {
            sum += share_of_row * share * log(grid.values[row * layout.width + column]?);
        }
    }
    Some(exp(sum))
}

/// The two cells whose middles are around a place, and the share of each.
fn neighbours(place: f64, count: usize) -> ([usize; 2], [f64; 2]) {
    let along = (place * count as f64 - 0.5).clamp(0.0, (count - 1) as f64);
    let first = cell(along / count as f64, count);
    let share = along - first as f64;
    ([first, (first + 1).min(count - 1)], [1.0 - share, share])
}
