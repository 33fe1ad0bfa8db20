//! Numbers of an independent program, `tests/reference/bounds.py`.

use rangelab::bounds::{Bound, BoundKind, bounds_along, crb, unitary_crb};
use rangelab::model::ranging::{RangeForm, Weighting};
use serde_json::Value;

use crate::scenes::{LOCALIZATION_ANCHORS, localization, tracking};

/// The numbers that the program wrote.
pub fn reference() -> Value {
    serde_json::from_str(include_str!("../reference/bounds.json")).expect("the reference is JSON")
}

fn compare(name: &str, bound: &Bound<3>, expected: &Value) {
    for (what, ours) in [("orientation", bound.orientation_trace), ("position", bound.position_trace)] {
        let theirs = expected[what].as_f64().unwrap_or_else(|| panic!("{name}: no {what} in the reference"));
        assert!((ours / theirs - 1.0).abs() < 1e-9, "{name}, {what}: {ours:e} against {theirs:e}");
    }
}

#[test]
fn the_bounds_of_one_epoch() {
    let (scene, reference) = (localization(&LOCALIZATION_ANCHORS, Weighting::PerPair), reference());
    let (projected, raw) = (scene.information(RangeForm::Projected), scene.information(RangeForm::Raw));
    let bounds = [
        ("crb", Bound::linear(crb(&projected).unwrap(), None)),
        ("uc_crb", Bound::tangent(unitary_crb(&projected).unwrap())),
        ("uc_crb_raw", Bound::tangent(unitary_crb(&raw).unwrap())),
    ];
    for (name, bound) in bounds {
        compare(name, &bound, &reference["localization"][name]);
    }
}

#[test]
fn the_posterior_bounds_of_the_tracking_paper() {
    let (steps, reference) = (bounds_along(&tracking(Weighting::PerPair)).unwrap(), reference());
    for kind in [BoundKind::LinearPosteriorCrb, BoundKind::PosteriorCrb, BoundKind::PosteriorCrbRaw] {
        for (i, k) in [0, 4, 19].into_iter().enumerate() {
            let bound = steps[k].get(kind).unwrap().as_ref().unwrap();
            compare(kind.name(), bound, &reference["tracking_steps_0_4_19"][kind.name()][i]);
        }
    }
}
