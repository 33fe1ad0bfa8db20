//! How the anchors and the sensors of a run lie.

use alloc::string::String;
use alloc::vec::Vec;

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use crate::model::ranging::RangeModel;
use crate::model::spread::Spread;

/// How anchors and sensors lie, and what that hides.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct Geometry {
    /// The anchors in the world frame.
    pub anchors: PointCloud,
    /// The sensors in the body frame.
    pub sensors: PointCloud,
    /// What all ranges of one epoch cannot tell apart once the unknown `||s||^2` is projected out of them, in a
    /// sentence; null where they show the whole pose.
    pub unseen: Option<String>,
}

/// How near points lie to one plane and to one line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct PointCloud {
    /// The plane that fits them best; null in the plane, where they all lie in one.
    pub plane: Option<Flat>,
    /// The line that fits them best.
    pub line: Flat,
}

/// A plane or line through the centroid of points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct Flat {
    /// Largest distance of a point from it, m.
    pub thickness: f64,
    /// Unit normal of a plane, unit direction of a line; the sign means nothing.
    pub direction: Vec<f64>,
}

impl Geometry {
    /// Measures the points of a model.
    pub(crate) fn of<const D: usize>(model: &RangeModel<D>, unseen: Option<String>) -> Self {
        Self {
            anchors: PointCloud::of(model.anchors().positions()),
            sensors: PointCloud::of(model.topology().sensors()),
            unseen,
        }
    }
}

impl PointCloud {
    fn of<const D: usize>(points: &[SVector<f64, D>]) -> Self {
        let spread = Spread::of(points);
        let flat = |dimensions: usize, direction: usize| Flat {
            thickness: spread.thickness(points, dimensions),
            direction: spread.directions.column(direction).iter().copied().collect(),
        };
        Self { plane: (D == 3).then(|| flat(2, D - 1)), line: flat(1, 0) }
    }
}
