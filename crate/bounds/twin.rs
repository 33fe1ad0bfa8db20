//! The mirror image that ranges cannot tell from the body.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use nalgebra::SVector;

use crate::math::pose::Pose;
use crate::model::lack::{FLAT, describe_flat};
use crate::model::ranging::RangeModel;

/// The body reflected in the plane (D = 2: line) of the anchors: every range is the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Twin<const D: usize> {
    /// Where its sensors are in the world, m.
    pub sensors: Vec<SVector<f64, D>>,
    /// Whether the body itself can stand like that: a flat body can be turned over. Otherwise only an estimator over all
    /// orthogonal matrices, O(D), can mistake one for the other.
    pub proper: bool,
    /// What that means, in a sentence.
    pub sentence: String,
}

/// The twin of a body at a pose; `None` where the anchors fill the space, or where the twin is the body itself.
pub fn mirror_twin<const D: usize>(model: &RangeModel<D>, pose: &Pose<D>) -> Option<Twin<D>> {
    let anchors = model.anchors().spread();
    if anchors.singular_values[D - 1] > FLAT * anchors.singular_values[0] {
        return None;
    }
    let normal = anchors.directions.column(D - 1);
    let places = model.topology().sensors().iter().map(|c| pose.act(c));
    let height = |s: &SVector<f64, D>| (s - anchors.centroid).dot(&normal);
    let moved = places.clone().map(|s| height(&s).abs()).fold(0.0, f64::max);
    if moved <= FLAT * (anchors.singular_values[0] + moved) {
        return None;
    }
    let body = model.topology().spread().singular_values;
    let proper = body[D - 1] <= FLAT * body[0];
    let lie = describe_flat(model.anchors().positions(), &anchors, D - 1);
    let end = if proper {
        "and the body is flat, so it can really stand there: only where it was before tells the two apart"
    } else {
        "but no turn takes the body there: an estimator over rotations, SO(D), is not misled, one over O(D) is"
    };
    Some(Twin {
        sensors: places.map(|s| s - normal * (2.0 * height(&s))).collect(),
        proper,
        sentence: format!("The anchors lie {lie}: the mirror image of the body has the same ranges, {end}."),
    })
}
