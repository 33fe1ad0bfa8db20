//! All bounds at each step of a recording whose truth is known.

use alloc::vec::Vec;

use super::constrained::{crb, unitary_crb_on};
use super::fisher::{FisherInformation, information_of};
use super::kinds::{Bound, BoundKind};
use super::posterior::PosteriorBound;
use crate::error::{Error, Result};
use crate::math::block::BlockMatrix;
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::Rotation;
use crate::math::tangent::TangentMatrix;
use crate::model::accumulate::RangeBuffer;
use crate::model::covariance::Covariance;
use crate::model::epoch::{Epoch, Recording};
use crate::model::motion::ProcessNoise;
use crate::model::normal_equations::Information;
use crate::model::ranging::{RangeForm, RangeModel, Weighting};

/// The bounds at one step.
#[derive(Clone, Debug, PartialEq)]
pub struct StepBounds<const D: usize>([Option<Result<Bound<D>>>; BoundKind::ALL.len()]);

impl<const D: usize> StepBounds<D> {
    /// One bound: `None` where the truth it needs is not known, an error where it does not exist.
    pub fn get(&self, kind: BoundKind) -> Option<&Result<Bound<D>>> {
        self.0[kind as usize].as_ref()
    }
}

/// Bounds along the true trajectory, one entry an epoch.
///
/// The noise is that of the recording, **pair by pair** ([`Weighting::PerPair`]), whatever weights its estimators are
/// told to use: a ruler does not take over the simplification of what it measures. Only ranges that were measured count.
///
/// Without truth at a step, the bounds of that step alone are `None`. The linear posterior bound needs the pose only
/// for its weights and goes on with those of the epoch (then it is the covariance of a Kalman filter). The posterior
/// bounds on the manifold are `None` from the first step on whose ranges have no truth: leaving the ranges out would
/// give a number above what is possible. A step that cannot be seen is an error of the bounds of that step alone.
///
/// # Errors
/// [`Error::Number`] for noise that is not positive.
pub fn bounds_along<const D: usize>(recording: &Recording<D>) -> Result<Vec<StepBounds<D>>> {
    let mut bounds = Vec::with_capacity(recording.epochs.len());
    visit_bounds(recording, |step| bounds.push(step))?;
    Ok(bounds)
}

/// [`bounds_along`] for someone who looks at one epoch after the other and keeps none.
///
/// # Errors
/// [`Error::Number`] for noise that is not positive.
pub fn visit_bounds<const D: usize>(
    recording: &Recording<D>,
    mut visit: impl FnMut(StepBounds<D>),
) -> Result<()> {
    let (model, variance) = (&recording.model, recording.initial.variance);
    let model = RangeModel::new(
        model.anchors().clone(),
        model.topology().clone(),
        *model.noise(),
        Weighting::PerPair,
    )?;
    let mut buffer = model.range_buffer();
    let mut recursion = Recursion::new(variance);
    for (k, epoch) in recording.epochs.iter().enumerate() {
        let truth = recording.truth.get(k).copied().flatten();
        let seen = Seen::new(&model, epoch, truth, &mut buffer);
        recursion.step(epoch, &recording.process, &seen);
        visit(bounds_of(&seen, &recursion));
    }
    Ok(())
}

/// The information of one epoch's ranges, on `[Q | t]` and on the tangent space.
struct AtTruth<'a, const D: usize> {
    information: FisherInformation<'a, D>,
    on_tangent_space: TangentMatrix<D>,
}

/// What the ranges of one epoch say.
struct Seen<'a, const D: usize> {
    rotation: Option<Rotation<D>>,
    projected: Option<Result<AtTruth<'a, D>>>,
    raw: Option<Result<AtTruth<'a, D>>>,
    /// The projected information about all of `[Q | t]`, from the truth or else from the weights of the epoch.
    linear: Result<BlockMatrix<D>>,
}

impl<'a, const D: usize> Seen<'a, D> {
    fn new(
        model: &'a RangeModel<D>,
        epoch: &Epoch<D>,
        truth: Option<Pose<D>>,
        buffer: &mut RangeBuffer<D>,
    ) -> Self {
        let exact = truth.map(|pose| (pose, model.exact_ranges(&Theta::from(pose))));
        let mut at_truth = |form| {
            let (pose, exact) = exact.as_ref()?;
            let ranges = exact.as_ref().map_err(Error::clone);
            Some(ranges.and_then(|exact| {
                let information = information_of(model, pose, &epoch.ranges, exact, form, buffer)?;
                Ok(AtTruth { on_tangent_space: information.on_tangent_space(), information })
            }))
        };
        let (projected, raw) = (at_truth(RangeForm::Projected), at_truth(RangeForm::Raw));
        let linear = match &projected {
            Some(seen) => seen.as_ref().map(|seen| seen.information.matrix).map_err(Error::clone),
            // The projected information does not depend on the reference.
            None => model
                .normal_equations(
                    &epoch.ranges,
                    epoch.weight_ranges(),
                    &Theta::zeros(),
                    RangeForm::Projected,
                    buffer,
                )
                .map(|equations| equations.information.to_blocks()),
        };
        Self { rotation: truth.map(|pose| pose.rotation), projected, raw, linear }
    }
}

/// The three recursions; one that fails keeps its error, one that loses the truth stays lost.
struct Recursion<const D: usize> {
    linear: Result<Covariance<D>>,
    projected: Option<Result<PosteriorBound<D>>>,
    raw: Option<Result<PosteriorBound<D>>>,
}

impl<const D: usize> Recursion<D> {
    fn new(variance: f64) -> Self {
        let start = Some(Ok(PosteriorBound::new(variance)));
        Self {
            linear: Ok(Covariance::Full(BlockMatrix::isotropic(variance, variance))),
            projected: start.clone(),
            raw: start,
        }
    }

    fn step(&mut self, epoch: &Epoch<D>, noise: &ProcessNoise, seen: &Seen<D>) {
        let turned = epoch.motion.rotation();
        advance(&mut self.linear, |covariance| {
            covariance.predict(turned.matrix(), noise);
            covariance.update(&Information::Full(seen.linear.clone()?))
        });
        let no_ranges = epoch.ranges.missing() == epoch.ranges.anchors() * epoch.ranges.sensors();
        for (bound, information) in [(&mut self.projected, &seen.projected), (&mut self.raw, &seen.raw)] {
            if information.is_none() && !no_ranges {
                *bound = None;
            }
            let Some(bound) = bound else { continue };
            advance(bound, |bound| {
                bound.predict(noise);
                information.as_ref().map_or(Ok(()), |seen| {
                    bound.update_on(&seen.as_ref().map_err(Error::clone)?.on_tangent_space)
                })
            });
        }
    }
}

fn advance<T>(state: &mut Result<T>, step: impl FnOnce(&mut T) -> Result<()>) {
    let failure = state.as_mut().ok().and_then(|value| step(value).err());
    if let Some(error) = failure {
        *state = Err(error);
    }
}

fn bounds_of<const D: usize>(seen: &Seen<D>, recursion: &Recursion<D>) -> StepBounds<D> {
    let rotation = seen.rotation.as_ref();
    let unitary = |seen: &Result<AtTruth<D>>| {
        let AtTruth { information, on_tangent_space } = seen.as_ref().map_err(Error::clone)?;
        unitary_crb_on(information, on_tangent_space).map(Bound::tangent)
    };
    let posterior = |bound: &Result<PosteriorBound<D>>| {
        bound.as_ref().map(|bound| Bound::tangent(*bound.covariance())).map_err(Error::clone)
    };
    StepBounds(BoundKind::ALL.map(|kind| {
        match kind {
            BoundKind::Crb => seen.projected.as_ref().map(|seen| {
                let matrix = crb(&seen.as_ref().map_err(Error::clone)?.information)?;
                Ok(Bound::linear(matrix, rotation))
            }),
            BoundKind::UnitaryCrb => seen.projected.as_ref().map(unitary),
            BoundKind::UnitaryCrbRaw => seen.raw.as_ref().map(unitary),
            BoundKind::LinearPosteriorCrb => Some(
                recursion
                    .linear
                    .as_ref()
                    .map(|covariance| Bound::linear(covariance.to_blocks(), rotation))
                    .map_err(Error::clone),
            ),
            BoundKind::PosteriorCrb => recursion.projected.as_ref().map(posterior),
            BoundKind::PosteriorCrbRaw => recursion.raw.as_ref().map(posterior),
        }
    }))
}
