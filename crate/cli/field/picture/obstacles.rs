//! Walls and boxes that block lines of sight, and zones that no anchor may stand in, where they cross the plane; beside a
//! level plane their outline as seen from above.

use rangelab::bounds::field::FieldLayout;
use rangelab::math::float::atan2;
use rangelab::model::availability::Block;
use rangelab::model::field_settings::FieldPlane;
use rangelab::model::placement_settings::Region;
use rangelab::with_dimension;

use super::{cross, dot, place};
use crate::cli::field::grid::{Grid, lifted};
use crate::cli::picture::canvas::{Canvas, Frame, Stroke};

/// Through the plane, above or below it, and a zone that keeps anchors out.
pub const CROSSING: Stroke = Stroke { half: 1, dash: None };
pub const BESIDE: Stroke = Stroke { half: 1, dash: Some(8) };
pub const KEEP_OUT: Stroke = Stroke { half: 0, dash: Some(4) };

/// A closed line: parts of both edges of the field.
pub struct Outline {
    pub points: Vec<[f64; 2]>,
    pub stroke: Stroke,
}

/// All that is drawn of a field's obstacles, and of the zones that matter to it.
pub fn outlines(grid: &Grid) -> Vec<Outline> {
    let scenario = &grid.scenario;
    let blocks = with_dimension!(scenario.dimension, D => {
        scenario.setup::<D>().map(|setup| setup.availability.blocks().to_vec())
    });
    // The scenario was valid enough for its field.
    let obstacles = blocks.unwrap_or_default();
    let zones = if grid.of_next_anchor() { scenario.placement.keep_out.as_slice() } else { &[] };
    let obstacles = obstacles.iter().filter_map(|block| outline(grid, block, CROSSING));
    let zones = zones.iter().filter_map(|zone| outline(grid, &block_of(zone), KEEP_OUT));
    obstacles.chain(zones).collect()
}

pub fn draw(canvas: &mut Canvas, frame: Frame, grid: &Grid) {
    for Outline { points, stroke } in outlines(grid) {
        for line in points.windows(2) {
            canvas.line(frame, line[0], line[1], stroke);
        }
        if let [first, _, .., last] = points[..] {
            canvas.line(frame, last, first, stroke);
        }
    }
}

/// Where a block crosses the plane; for a level plane else what is seen from above.
fn outline(grid: &Grid, block: &Block, stroke: Stroke) -> Option<Outline> {
    let corners = corners(block);
    let mut points = section(&grid.layout, &corners);
    let mut stroke = stroke;
    if points.is_empty() {
        if !matches!(grid.scenario.field.plane, FieldPlane::Level | FieldPlane::Horizontal { .. }) {
            return None;
        }
        points = corners[..4].to_vec();
        stroke.dash = stroke.dash.or(BESIDE.dash);
    }
    let mut points: Vec<[f64; 2]> = distinct(points).into_iter().map(|point| place(grid, point)).collect();
    let middle: [f64; 2] =
        core::array::from_fn(|i| points.iter().map(|p| p[i]).sum::<f64>() / points.len() as f64);
    let angle = |p: &[f64; 2]| atan2(p[1] - middle[1], p[0] - middle[0]);
    points.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    Some(Outline { points, stroke })
}

/// Without repetitions: a wall has every corner twice.
fn distinct(points: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    let mut seen: Vec<[f64; 3]> = Vec::new();
    for point in points {
        if !seen.contains(&point) {
            seen.push(point);
        }
    }
    seen
}

/// Bits 0, 1 and 2 of a corner's number: far along the heading, across it, upwards.
fn corners(block: &Block) -> [[f64; 3]; 8] {
    let [x, y] = block.heading;
    core::array::from_fn(|corner| {
        let far: [f64; 3] =
            core::array::from_fn(
                |axis| if corner >> axis & 1 == 1 { block.half[axis] } else { -block.half[axis] },
            );
        let [a, b, c] = block.centre;
        [a + x * far[0] - y * far[1], b + y * far[0] + x * far[1], c + far[2]]
    })
}

/// The points where the edges of a block cross the plane.
fn section(layout: &FieldLayout, corners: &[[f64; 3]; 8]) -> Vec<[f64; 3]> {
    let normal = cross(&layout.u, &layout.v);
    let height =
        |point: &[f64; 3]| -> f64 { dot(&core::array::from_fn(|i| point[i] - layout.corner[i]), &normal) };
    let edges = (0..8).flat_map(|from| (0..3).map(move |axis| (from, from | 1 << axis)));
    let crossing = edges.filter(|(from, to)| from != to).filter_map(|(from, to)| {
        let (a, b) = (&corners[from], &corners[to]);
        let (below, above) = (height(a), height(b));
        let part = below / (below - above);
        ((below < 0.0) != (above < 0.0)).then(|| core::array::from_fn(|i| a[i] + part * (b[i] - a[i])))
    });
    crossing.collect()
}

fn block_of(zone: &Region) -> Block {
    let (low, high) = (lifted(&zone.low), lifted(&zone.high));
    let half = core::array::from_fn(|i| 0.5 * (high[i] - low[i]));
    Block { centre: core::array::from_fn(|i| 0.5 * (low[i] + high[i])), heading: [1.0, 0.0], half }
}
