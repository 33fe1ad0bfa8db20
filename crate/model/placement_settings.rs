//! What a good placement of anchors is, and where anchors may stand.

use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::document::check::Check;

/// What the placement adviser makes small, and its limits. Form of the ranges and headings are those of the field.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields, default)]
pub struct PlacementSettings {
    /// Which number of the bound counts.
    pub criterion: Criterion,
    /// The bound of what.
    pub target: Target,
    /// How several places of the body count together.
    pub over: Over,
    /// Where the body may be; null: where it starts.
    pub region: Option<Region>,
    /// Where anchors may stand; null: within the box of the anchors.
    pub limits: Option<Region>,
    /// Where they may not.
    pub keep_out: Vec<Region>,
    /// Numbers of the anchors that stay where they are, from 0, increasing.
    pub fixed: Vec<usize>,
}

/// A box along the axes, m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// Least coordinates.
    pub low: Vec<f64>,
    /// Largest coordinates.
    pub high: Vec<f64>,
}

/// The optimality of a design, as a standard deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Criterion {
    /// Root of the trace.
    #[default]
    A,
    /// Geometric mean of the standard deviations along the axes of the ellipsoid, `det^(1/(2k))`.
    D,
    /// Largest standard deviation: the root of the largest eigenvalue.
    E,
}

/// The bound of what.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Target {
    /// The position, m.
    #[default]
    Position,
    /// The orientation, rad.
    Orientation,
    /// Both, angles times the size of the body: m at the sensors.
    Pose,
}

/// How several places count together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Over {
    /// Root mean square.
    #[default]
    Mean,
    /// The worst of them.
    Worst,
}

/// Most keep-out zones.
const MAX_ZONES: usize = 100;

impl PlacementSettings {
    pub(super) fn check(&self, check: &mut Check, anchors: usize, dimension: Option<usize>) {
        let mut region = |path: &str, region: &Option<Region>| {
            if let Some(Region { low, high }) = region {
                check.region(path, low, high, dimension);
            }
        };
        region("placement.region", &self.region);
        region("placement.limits", &self.limits);
        check.count("placement.keep_out", self.keep_out.len(), 0, MAX_ZONES);
        for (i, Region { low, high }) in self.keep_out.iter().enumerate() {
            check.region(format_args!("placement.keep_out[{i}]"), low, high, dimension);
        }
        for (i, &fixed) in self.fixed.iter().enumerate() {
            if fixed >= anchors || i > 0 && self.fixed[i - 1] >= fixed {
                let limit = format_args!("increasing numbers from 0 to {}", anchors.saturating_sub(1));
                check.problem(format_args!("placement.fixed[{i}]"), fixed, limit);
            }
        }
    }
}
