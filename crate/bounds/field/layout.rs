//! Where the cells of a field lie.

use nalgebra::SVector;
use serde::Serialize;

use crate::error::{Error, Result};
use crate::math::float::{cos, floor, sin};
use crate::math::pose::Pose;
use crate::model::anchors::Anchors;
use crate::model::field_settings::FieldPlane;

/// A grid of cells over a rectangle of the world; the bound of a cell is that at its centre.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct FieldLayout {
    /// Where the first cell of the first row has its outer corner, m.
    pub corner: [f64; 3],
    /// The edge along a row, m.
    pub u: [f64; 3],
    /// The edge from row to row, m.
    pub v: [f64; 3],
    /// Cells in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

/// Most cells along an edge.
pub const MAX_RESOLUTION: usize = 1024;
/// Room around anchors and body, as a part of their extent along the larger edge.
const MARGIN: f64 = 0.15;
/// An edge is at least this part of the other.
const LEAST_EDGE: f64 = 0.25;
/// The rectangle begins and ends at multiples of this part of its larger edge (rounded to a power of two), so that it
/// keeps still while something moves a little.
const STEP: f64 = 1.0 / 16.0;

impl FieldLayout {
    /// The grid with `resolution` cells along its longer edge: over the box of the anchors and the body, with a margin.
    ///
    /// # Errors
    /// [`Error::Number`] for a resolution that is 0 or above [`MAX_RESOLUTION`].
    pub fn new<const D: usize>(
        anchors: &Anchors<D>,
        pose: &Pose<D>,
        plane: &FieldPlane,
        resolution: usize,
    ) -> Result<Self> {
        if !(1..=MAX_RESOLUTION).contains(&resolution) {
            let (value, limit) = (resolution as f64, "from 1 to 1024 cells");
            return Err(Error::Number { what: "the resolution of the field", value, limit });
        }
        let (origin, [x, y]) = axes(pose, plane);
        let along = |axis: &[f64; 3]| {
            let points = anchors.positions().iter().chain([&pose.position]);
            let coordinates = points.map(|p| dot(&minus(&lift(p), &origin), axis));
            coordinates.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c| [low.min(c), high.max(c)])
        };
        let [across, up] = rectangle(along(&x), along(&y));
        let at = |axis: &[f64; 3], length: f64| axis.map(|entry| entry * length);
        let corner = plus(&origin, &plus(&at(&x, across[0]), &at(&y, up[0])));
        let (width, height) = (across[1] - across[0], up[1] - up[0]);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0.5 to the resolution and a half"
        )]
        let cells = |edge: f64| ((resolution as f64 * edge / width.max(height) + 0.5) as usize).max(1);
        let (u, v) = (at(&x, width), at(&y, height));
        Ok(Self { corner, u, v, width: cells(width), height: cells(height) })
    }

    /// The middle of a cell, m.
    pub fn centre(&self, column: usize, row: usize) -> [f64; 3] {
        self.at(self.part(column, row))
    }

    /// The middle of a cell as parts of both edges.
    pub fn part(&self, column: usize, row: usize) -> [f64; 2] {
        [(column as f64 + 0.5) / self.width as f64, (row as f64 + 0.5) / self.height as f64]
    }

    /// The point at parts of both edges, m.
    pub fn at(&self, [i, j]: [f64; 2]) -> [f64; 3] {
        core::array::from_fn(|k| self.corner[k] + i * self.u[k] + j * self.v[k])
    }
}

/// The origin of a plane's coordinates and its two axes.
fn axes<const D: usize>(pose: &Pose<D>, plane: &FieldPlane) -> ([f64; 3], [[f64; 3]; 2]) {
    let level = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let position = lift(&pose.position);
    match *plane {
        FieldPlane::Level => ([0.0, 0.0, position[2]], level),
        FieldPlane::Horizontal { height } => ([0.0, 0.0, height], level),
        FieldPlane::Vertical { heading, offset } => {
            let (s, c) = (sin(heading), cos(heading));
            ([-offset * s, offset * c, 0.0], [[c, s, 0.0], [0.0, 0.0, 1.0]])
        }
        FieldPlane::Body => {
            let column = |i: usize| lift(&pose.rotation.matrix().column(i).into_owned());
            (position, [column(0), column(1)])
        }
    }
}

/// Both intervals with their margin, rounded outwards.
fn rectangle(across: [f64; 2], up: [f64; 2]) -> [[f64; 2]; 2] {
    let size = |[low, high]: [f64; 2]| high - low;
    let larger = size(across).max(size(up));
    let larger = if larger > 0.0 { larger } else { 1.0 };
    let mut step = 1.0;
    while step > STEP * larger {
        step *= 0.5;
    }
    while 2.0 * step <= STEP * larger {
        step *= 2.0;
    }
    [across, up].map(|interval| {
        let lacking = (LEAST_EDGE * larger - size(interval)).max(0.0) / 2.0;
        let room = MARGIN * larger + lacking;
        let down = |x: f64| floor(x / step) * step;
        [down(interval[0] - room), -down(-interval[1] - room)]
    })
}

fn lift<const D: usize>(v: &SVector<f64, D>) -> [f64; 3] {
    core::array::from_fn(|i| if i < D { v[i] } else { 0.0 })
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn plus(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| a[i] + b[i])
}

fn minus(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| a[i] - b[i])
}
