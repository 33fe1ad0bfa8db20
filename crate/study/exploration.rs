//! What a geometry can and cannot see, as a document for the page and the command line.

use alloc::string::String;
use alloc::vec::Vec;

use nalgebra::SVector;
use serde::Serialize;

use crate::bounds::observability::{Motion, observability};
use crate::bounds::twin::{Twin, mirror_twin};
use crate::bounds::{FisherInformation, fisher_information_of, unitary_crb};
use crate::error::Result;
use crate::math::float::sqrt;
use crate::math::pose::Pose;
use crate::math::rotation::rotation_angles;
use crate::math::tangent::TangentMatrix;
use crate::model::document::entries::{PoseEntries, angle_rows, coordinates, rows};
use crate::model::ranging::RangeModel;
use crate::model::scenario::{Scenario, Setup};
use crate::with_dimension;

/// The bound at the pose that the body of a scenario starts from, and what its geometry hides.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Exploration {
    /// The pose.
    pub pose: PoseEntries,
    /// The bound there.
    #[serde(flatten)]
    pub bound: PointBound,
    /// The independent motions of the body, the one that the ranges see least first.
    pub modes: Vec<MotionRecord>,
    /// Why the pose is not seen, by name; null where it is.
    pub cause: Option<&'static str>,
    /// Singular values of the centred anchors, decreasing, m.
    pub anchor_singular_values: Vec<f64>,
    /// Singular values of `[C; 1^T]`, decreasing.
    pub sensor_singular_values: Vec<f64>,
    /// The mirror image with the same ranges; null where there is none.
    pub twin: Option<TwinRecord>,
    /// Which ranges can be measured: anchor by anchor, sensor by sensor.
    pub available: Vec<Vec<bool>>,
}

/// The UC-CRB at one pose; nulls where there is none.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct PointBound {
    /// Root of the trace of the bound on the position, m.
    pub position_sigma: Option<f64>,
    /// Root of the trace of the bound on the angles, rad.
    pub angle_sigma: Option<f64>,
    /// The bound on the covariance of the position, m^2, row by row.
    pub position_covariance: Option<Vec<Vec<f64>>>,
    /// That of the error's rotation vector in the world frame, rad^2, row by row.
    pub rotation_covariance_in_world: Option<Vec<Vec<f64>>>,
    /// What is not seen and why; or, where all is seen, what is seen least.
    pub sentence: String,
}

/// A motion of the body, scaled so that the sensors move by about 1 m.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct MotionRecord {
    /// Rotation vector in the body frame, rad: 3 numbers, 1 in the plane.
    pub rotation: Vec<f64>,
    /// Shift in the world frame, m.
    pub shift: Vec<f64>,
    /// Standard deviation of an estimate along it, m at the sensors; null where it is not seen.
    pub standard_deviation: Option<f64>,
    /// Part of the motion of the sensors that comes from the turn, 0 to 1.
    pub turning: f64,
}

/// The mirror image of the body in the plane of the anchors.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct TwinRecord {
    /// Its sensors in the world frame, m.
    pub sensors: Vec<Vec<f64>>,
    /// Whether the body itself can stand like that.
    pub proper: bool,
    /// What that means.
    pub sentence: String,
}

/// Explores the pose that the body starts from, with the ranges that can be measured there, in the form and with the
/// anchors of the scenario's field.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario, [`crate::Error::Number`] where a range overflows.
pub fn explore(scenario: &Scenario) -> Result<Exploration> {
    with_dimension!(scenario.dimension, D => explore_in::<D>(scenario))
}

/// The bound of a body with the attitude of the scenario's at another point of the world (D coordinates, m).
///
/// # Errors
/// As [`explore`]; [`crate::Error::Size`] for too few or too many coordinates.
pub fn bound_at(scenario: &Scenario, point: &[f64]) -> Result<PointBound> {
    with_dimension!(scenario.dimension, D => {
        if point.len() != D {
            let (what, found, expected) = ("coordinates of the point", point.len(), D);
            return Err(crate::Error::Size { what, found, expected });
        }
        let setup = scenario.setup::<D>()?;
        let pose = Pose { position: SVector::from_fn(|i, _| point[i]), ..setup.start };
        let model = setup.model.per_pair();
        let information = seen_from(scenario, &model, &setup, &pose)?;
        let sentence = observability(&information).sentence;
        Ok(point_bound(&information, sentence))
    })
}

fn explore_in<const D: usize>(scenario: &Scenario) -> Result<Exploration> {
    let setup = scenario.setup::<D>()?;
    let model = setup.model.per_pair();
    let information = seen_from(scenario, &model, &setup, &setup.start)?;
    let facts = observability(&information);
    let measurable = model.measurable(&setup.start, &setup.availability);
    Ok(Exploration {
        pose: setup.start.into(),
        bound: point_bound(&information, facts.sentence),
        modes: facts.motions.iter().map(MotionRecord::from).collect(),
        cause: facts.cause.map(crate::bounds::Cause::name),
        anchor_singular_values: facts.anchor_singular_values.to_vec(),
        sensor_singular_values: facts.sensor_singular_values,
        twin: mirror_twin(&model, &setup.start).map(TwinRecord::from),
        available: measurable.chunks(model.topology().len()).map(<[bool]>::to_vec).collect(),
    })
}

fn seen_from<'a, const D: usize>(
    scenario: &Scenario,
    model: &'a RangeModel<D>,
    setup: &Setup<D>,
    pose: &Pose<D>,
) -> Result<FisherInformation<'a, D>> {
    let measured = model.measurable_ranges(pose, &setup.availability)?;
    fisher_information_of(model, pose, &measured, scenario.field.form, &mut model.range_buffer())
}

fn point_bound<const D: usize>(information: &FisherInformation<D>, sentence: String) -> PointBound {
    let bound = unitary_crb(information).ok();
    let rotation = |bound: &TangentMatrix<D>| bound.rotation_block_in_world(&information.pose.rotation);
    PointBound {
        position_sigma: bound.map(|bound| sqrt(bound.shift_block().trace())),
        angle_sigma: bound.map(|bound| sqrt(bound.angle_trace())),
        position_covariance: bound.map(|bound| rows(&bound.shift_block())),
        rotation_covariance_in_world: bound.map(|bound| angle_rows::<D>(&rotation(&bound))),
        sentence,
    }
}

impl<const D: usize> From<&Motion<D>> for MotionRecord {
    fn from(motion: &Motion<D>) -> Self {
        Self {
            rotation: motion.rotation[..rotation_angles(D)].to_vec(),
            shift: motion.shift.as_slice().to_vec(),
            standard_deviation: motion.standard_deviation,
            turning: motion.turning,
        }
    }
}

impl<const D: usize> From<Twin<D>> for TwinRecord {
    fn from(twin: Twin<D>) -> Self {
        Self { sensors: coordinates(&twin.sensors), proper: twin.proper, sentence: twin.sentence }
    }
}
