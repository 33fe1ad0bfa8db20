//! The bounds of one snapshot.

use nalgebra::SMatrix;

use super::tally::BoundFigures;
use crate::bounds::perturbed::{perturbed_information, sensor_information_traces};
use crate::bounds::sensors::sensor_trace;
use crate::bounds::{Bound, constrained::image, crb, unitary_crb};
use crate::error::Result;
use crate::math::pose::Pose;
use crate::model::ranges::Ranges;
use crate::model::ranging::{RangeForm, RangeModel};

/// What bounds a snapshot estimator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SnapshotBound {
    /// The positions of the sensors, each by itself.
    Classical,
    /// Any matrix `[Q | t]`.
    Crb,
    /// A pose.
    UnitaryCrb,
    /// A pose, from the squared ranges as they are.
    UnitaryCrbRaw,
}

impl SnapshotBound {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 4] = [Self::Classical, Self::Crb, Self::UnitaryCrb, Self::UnitaryCrbRaw];

    /// The name in documents; it stays.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Classical => "classical_crb",
            Self::Crb => "crb",
            Self::UnitaryCrb => "uc_crb",
            Self::UnitaryCrbRaw => "uc_crb_raw",
        }
    }

    /// The name for people.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Classical => "CRB, each sensor by itself",
            Self::Crb => "CRB, any matrix Q",
            Self::UnitaryCrb => "UC-CRB, rotations",
            Self::UnitaryCrbRaw => "UC-CRB, rotations, unprojected ranges",
        }
    }
}

/// The figures of each bound at the truth; `None` where it does not exist.
pub(super) fn figures<const D: usize>(
    model: &RangeModel<D>,
    pose: &Pose<D>,
    measured: &Ranges,
    mounting_sigma: f64,
) -> Result<[Option<BoundFigures>; 4]> {
    let topology = model.topology();
    let projected = perturbed_information(model, pose, measured, RangeForm::Projected, mounting_sigma)?;
    let raw = perturbed_information(model, pose, measured, RangeForm::Raw, mounting_sigma)?;
    let linear = crb(&projected).ok().map(|matrix| {
        BoundFigures::new(&Bound::linear(matrix, Some(&pose.rotation)), sensor_trace(&matrix, topology))
    });
    let unitary = |information| {
        let matrix = unitary_crb::<D>(information).ok()?;
        let sensors = sensor_trace(&image(&matrix, &pose.rotation), topology);
        Some(BoundFigures::new(&Bound::tangent(matrix), sensors))
    };
    let classical = sensor_information_traces(model, pose, measured, mounting_sigma)?;
    let classical = classical.map(|(sensors, mean): (f64, SMatrix<f64, D, D>)| BoundFigures {
        orientation: None,
        angle: None,
        position: Some(mean.trace()),
        sensors,
    });
    Ok([classical, linear, unitary(&projected), unitary(&raw)])
}
