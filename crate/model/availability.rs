//! Which ranges can be measured at all: anchors reach only so far, and walls and boxes block lines of sight.

use alloc::vec::Vec;

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use super::document::check::{Check, Limit, MAX_POINTS};
use super::document::entries::vector;

/// What takes ranges away, as it stands in a scenario; by default nothing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct AvailabilitySettings {
    /// Longest range of each anchor, m; null where it has no limit. Empty: none has.
    pub max_ranges: Vec<Option<f64>>,
    /// What blocks lines of sight.
    pub obstacles: Vec<Obstacle>,
}

/// A thing that no range passes through. A range that only touches it is measured: anchors may hang on walls.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Obstacle {
    /// An upright wall without thickness over a straight line on the ground.
    Wall {
        /// x and y of one end, m.
        from: Vec<f64>,
        /// x and y of the other end, m.
        to: Vec<f64>,
        /// Height of its lower edge, m; null reaches down without end. Without meaning in the plane.
        #[serde(default)]
        bottom: Option<f64>,
        /// Height of its upper edge, m; null reaches up without end. Without meaning in the plane.
        #[serde(default)]
        top: Option<f64>,
    },
    /// A box along the axes.
    Box {
        /// Least coordinates, m.
        low: Vec<f64>,
        /// Largest coordinates, m.
        high: Vec<f64>,
    },
}

/// An upright box, turned about the vertical: what every obstacle is to a line of sight. Flat scenes lie at height 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Its middle, m.
    pub centre: [f64; 3],
    /// Unit vector along its first edge, on the ground.
    pub heading: [f64; 2],
    /// Half its length along the heading, across it and upwards, m; 0 for a wall's thickness.
    pub half: [f64; 3],
}

/// The same with its dimension known to the compiler.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Availability<const D: usize> {
    /// Square of the longest range of each anchor, m^2; infinite without a limit. Empty: none has one.
    max_squared_ranges: Vec<f64>,
    blocks: Vec<Block>,
}

/// Most obstacles.
const MAX_OBSTACLES: usize = 100;
/// Half the height of what has no end, m: beyond every coordinate that a scenario may have.
const ENDLESS: f64 = 1e10;
/// Lines that reach this part of their own and the block's size into it still only touch it.
const TOUCH: f64 = 1e-6;

impl<const D: usize> Availability<D> {
    /// Everything is measured.
    pub fn unlimited() -> Self {
        Self { max_squared_ranges: Vec::new(), blocks: Vec::new() }
    }

    /// From settings whose sizes were checked by [`check`].
    pub(crate) fn new(settings: &AvailabilitySettings) -> Self {
        let squared = |range: &Option<f64>| range.map_or(f64::INFINITY, |r| r * r);
        Self {
            max_squared_ranges: settings.max_ranges.iter().map(squared).collect(),
            blocks: settings.obstacles.iter().map(Block::new::<D>).collect(),
        }
    }

    /// Whether nothing is ever missing.
    pub fn is_unlimited(&self) -> bool {
        self.blocks.is_empty() && self.max_squared_ranges.iter().all(|limit| limit.is_infinite())
    }

    /// Square of the longest range of an anchor, m^2.
    pub fn max_squared_range(&self, anchor: usize) -> f64 {
        self.max_squared_ranges.get(anchor).copied().unwrap_or(f64::INFINITY)
    }

    /// What blocks lines of sight.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Whether the anchor with this number, at `from`, measures its range to a sensor at `to` (world frame, m).
    pub fn allows(&self, anchor: usize, from: &SVector<f64, D>, to: &SVector<f64, D>) -> bool {
        let (a, s) = (lift(from.as_slice()), lift(to.as_slice()));
        (from - to).norm_squared() <= self.max_squared_range(anchor)
            && !self.blocks.iter().any(|block| block.blocks(&a, &s))
    }
}

impl Block {
    fn new<const D: usize>(obstacle: &Obstacle) -> Self {
        match obstacle {
            Obstacle::Box { low, high } => {
                let (low, high) = (lift(low), lift(high));
                let half = core::array::from_fn(|i| 0.5 * (high[i] - low[i]));
                let half = if D == 2 { [half[0], half[1], ENDLESS] } else { half };
                Self { centre: core::array::from_fn(|i| 0.5 * (low[i] + high[i])), heading: [1.0, 0.0], half }
            }
            Obstacle::Wall { from, to, bottom, top } => {
                let along = vector::<2>(to) - vector::<2>(from);
                let length = crate::math::float::sqrt(along.norm_squared());
                let (low, high) = (bottom.unwrap_or(-ENDLESS), top.unwrap_or(ENDLESS));
                let (low, high) = if D == 2 { (-ENDLESS, ENDLESS) } else { (low, high) };
                Self {
                    centre: [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 0.5 * (low + high)],
                    heading: [along[0] / length, along[1] / length],
                    half: [0.5 * length, 0.0, 0.5 * (high - low)],
                }
            }
        }
    }

    /// Whether the line from `a` to `b` passes through: the separating axes of a line and a box, no division, so that
    /// lines along an axis need no care.
    pub fn blocks(&self, a: &[f64; 3], b: &[f64; 3]) -> bool {
        let half_line: [f64; 3] = core::array::from_fn(|i| 0.5 * (b[i] - a[i]));
        let middle: [f64; 3] = core::array::from_fn(|i| 0.5 * (a[i] + b[i]) - self.centre[i]);
        let (d, c) = (self.along(&half_line), self.along(&middle));
        let grown = 1.0 + TOUCH;
        let apart = |distance: f64, reach: f64| grown * distance.abs() >= reach;
        let h = &self.half;
        !((0..3).any(|i| apart(c[i], h[i] + d[i].abs()))
            || (0..3).any(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                apart(c[j] * d[k] - c[k] * d[j], h[j] * d[k].abs() + h[k] * d[j].abs())
            }))
    }

    /// A vector in the axes of the block.
    fn along(&self, v: &[f64; 3]) -> [f64; 3] {
        let [x, y] = self.heading;
        [x * v[0] + y * v[1], x * v[1] - y * v[0], v[2]]
    }
}

fn lift(point: &[f64]) -> [f64; 3] {
    core::array::from_fn(|i| point.get(i).copied().unwrap_or(0.0))
}

/// The rules of the settings.
pub(super) fn check(
    check: &mut Check,
    settings: &AvailabilitySettings,
    anchors: usize,
    dimension: Option<usize>,
) {
    let ranges = &settings.max_ranges;
    if !ranges.is_empty() && ranges.len() != anchors {
        let limit = format_args!("none, or one for each of the {anchors} anchors");
        check.problem("availability.max_ranges", format_args!("{} long", ranges.len()), limit);
    }
    for (i, range) in ranges.iter().enumerate() {
        if let Some(range) = range {
            check.number(format_args!("availability.max_ranges[{i}]"), *range, Limit::LENGTH);
        }
    }
    check.count("availability.obstacles", settings.obstacles.len(), 0, MAX_OBSTACLES.min(MAX_POINTS));
    for (i, obstacle) in settings.obstacles.iter().enumerate() {
        check_obstacle(check, i, obstacle, dimension);
    }
}

fn check_obstacle(check: &mut Check, i: usize, obstacle: &Obstacle, dimension: Option<usize>) {
    let path = format_args!("availability.obstacles[{i}]");
    match obstacle {
        Obstacle::Box { low, high } => check.region(path, low, high, dimension),
        Obstacle::Wall { from, to, bottom, top } => {
            check.vector(format_args!("{path}.from"), from, Some(2), Limit::COORDINATE);
            check.vector(format_args!("{path}.to"), to, Some(2), Limit::COORDINATE);
            if from == to {
                check.problem(format_args!("{path}.to"), "where the wall starts", "another point");
            }
            for (name, edge) in [("bottom", bottom), ("top", top)] {
                if let Some(height) = edge {
                    check.number(format_args!("{path}.{name}"), *height, Limit::COORDINATE);
                }
            }
            if let (Some(bottom), Some(top)) = (bottom, top)
                && bottom >= top
            {
                check.problem(format_args!("{path}.top"), top, format_args!("above the bottom, {bottom} m"));
            }
        }
    }
}
