//! Which ranges can be measured at all: anchors reach only so far, and walls and boxes block lines of sight.

use alloc::vec::Vec;

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use super::document::check::{Check, Limit};
use super::document::entries::vector;
use crate::math::number::Number;

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

    /// Whether the line between two points passes through.
    pub fn blocks(&self, a: &[f64; 3], b: &[f64; 3]) -> bool {
        !line_is_free(&self.map(|x| x), *a, *b)
    }

    /// Its numbers as another kind of number: middle, heading, half edges.
    pub(crate) fn map<N>(&self, constant: impl Fn(f64) -> N) -> BlockNumbers<N> {
        BlockNumbers {
            centre: self.centre.map(&constant),
            heading: self.heading.map(&constant),
            half: self.half.map(&constant),
        }
    }
}

/// A [`Block`] in the numbers of a kernel.
#[derive(Clone, Copy)]
pub(crate) struct BlockNumbers<N> {
    pub(crate) centre: [N; 3],
    pub(crate) heading: [N; 2],
    pub(crate) half: [N; 3],
}

/// Whether the line from `a` to `b` passes beside the block: the separating axes of a line and a box, without a division,
/// so that lines along an axis need no care.
#[inline]
pub(crate) fn line_is_free<N: Number>(block: &BlockNumbers<N>, a: [N; 3], b: [N; 3]) -> N::Truth {
    let half = a[0].constant(0.5);
    let along = |v: [N; 3]| {
        let [x, y] = block.heading;
        [x * v[0] + y * v[1], x * v[1] - y * v[0], v[2]]
    };
    let d = along(core::array::from_fn(|i| half * (b[i] - a[i])));
    let c = along(core::array::from_fn(|i| half * (a[i] + b[i]) - block.centre[i]));
    let h = block.half;
    let grown = half.constant(1.0 + TOUCH);
    // How far it stays clear of the block along each axis of that, and along each that is normal to one and to the line;
    // the clearest decides.
    let mut beside = grown * c[0].abs() - (h[0] + d[0].abs());
    let mut askew = half.constant(0.0);
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        beside = beside.larger(grown * c[i].abs() - (h[i] + d[i].abs()));
        let lever = (c[j] * d[k] - c[k] * d[j]).abs();
        askew = askew.larger(grown * lever - (h[j] * d[k].abs() + h[k] * d[j].abs()));
    }
    // To touch a face is to be free; lines along an axis say nothing askew, 0.
    let zero = half.constant(0.0);
    N::not(N::both(zero.above(beside), N::not(askew.above(zero))))
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
    check.count("availability.obstacles", settings.obstacles.len(), 0, MAX_OBSTACLES);
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
