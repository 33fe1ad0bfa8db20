//! A field as a picture that needs no words beside it.

mod axes;
mod bar;
mod colours;
mod landscape;
mod legend;
mod marks;
mod obstacles;

use std::fmt::Display;

use super::grid::Grid;
use crate::cli::failure::Failure;
use crate::cli::picture::canvas::{Canvas, Frame, cell};
use crate::cli::picture::scale::Scale;
use colours::{INK, PAPER};
use rangelab::math::float::sqrt;

/// The longer edge of the field in pixels.
const EDGE: usize = 640;
const LEFT: usize = 88;
const TOP: usize = 88;
/// Colour bar and its numbers.
const RIGHT: usize = 152;
/// Numbers and name of the axis, and the legend.
const BOTTOM: usize = 92;
/// Room for the lines of the title.
const LEAST_WIDTH: usize = 800;

/// The picture as a PNG file; the chunk `Scenario` (iTXt) holds the scenario as JSON.
pub fn png(grid: &Grid) -> Result<Vec<u8>, Failure> {
    let texts = [("Title", grid.title()), ("Scenario", grid.scenario.to_json())];
    draw(grid).png(&texts).map_err(unwritten)
}

fn draw(grid: &Grid) -> Canvas {
    let [across, up] = [grid.layout.u, grid.layout.v].map(|edge| length(&edge));
    let pixels = |edge: f64| cell(edge / across.max(up), EDGE) + 1;
    let frame = Frame { left: LEFT, top: TOP, width: pixels(across), height: pixels(up) };
    let mut canvas =
        Canvas::new((frame.right() + RIGHT).max(LEAST_WIDTH), frame.bottom() + bottom(grid), PAPER);
    canvas.text([12, 12], &grid.title(), INK);
    canvas.text([12, 34], &grid.subtitle(), INK);
    let scale = Scale::of(grid.values.iter().copied().flatten());
    landscape::paint(&mut canvas, frame, grid, scale);
    if let Some(scale) = scale {
        landscape::contours(&mut canvas, frame, grid, scale);
        bar::draw(&mut canvas, frame, grid.unit(), scale);
    }
    obstacles::draw(&mut canvas, frame, grid);
    marks::draw(&mut canvas, frame, grid);
    axes::draw(&mut canvas, frame, grid);
    legend::draw(&mut canvas, frame, grid);
    canvas
}

/// Room below the field.
fn bottom(grid: &Grid) -> usize {
    BOTTOM + if legend::has_second_line(grid) { legend::LINE_HEIGHT } else { 0 }
}

/// Parts of both edges at which a point is seen along the normal of the plane.
fn place(grid: &Grid, point: [f64; 3]) -> [f64; 2] {
    let from_corner = core::array::from_fn(|i| point[i] - grid.layout.corner[i]);
    [grid.layout.u, grid.layout.v].map(|edge| dot(&from_corner, &edge) / dot(&edge, &edge))
}

fn unwritten(error: impl Display) -> Failure {
    Failure::Other(format!("the picture cannot be made: {error}"))
}

fn length(edge: &[f64; 3]) -> f64 {
    sqrt(dot(edge, edge))
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
