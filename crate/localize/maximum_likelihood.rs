//! Beyond the papers: the pose that makes the measured ranges most likely, nothing squared and nothing projected out.

use nalgebra::{SMatrix, SVector};

use super::range_fit::{Linearized, RangeFit};
use super::simplified::simplified;
use super::snapshot::Snapshot;
use super::{Estimate, Optimum};
use crate::error::Result;
use crate::math::float::sqrt;
use crate::math::linalg::spd_inverse;
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::{Manifold, Rotation};
use crate::math::singular::{psd_pseudo_inverse, singular};
use crate::math::tangent::{MAX_TANGENT, TangentVector, split};
use crate::model::lack::Parameters;
use crate::model::localize_settings::Loss;
use crate::model::noise::RangeNoise;
use crate::model::ranging::RangeForm;

const WHAT: &str = "maximum likelihood";
const MAX_ITERATIONS: usize = 40;

/// A step that promises to lower the cost by less than this part of it (or of one range) is the last.
const SETTLED: f64 = 1e-12;

/// Where knowing nothing of the other coordinates costs more than this factor in the variance of one, it is not seen.
const MAX_INFLATION: f64 = 1e12;

/// One Gauss-Newton step on the ranges from the SUC-LS over SO(D): a formula too, and near the bound of the unprojected ranges
/// wherever the SUC-LS is near the truth.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause.
pub fn gauss_newton<const D: usize>(snapshot: &Snapshot<D>) -> Result<Estimate<D>> {
    let start = centred(snapshot, &simplified(snapshot, Manifold::So)?);
    let linearized = RangeFit::new(snapshot, Loss::Squared).linearized(&start);
    let step = step(&linearized, 0.0).filter(|_| is_seen(&linearized));
    let step =
        step.ok_or_else(|| snapshot.unobservable("the Gauss-Newton step", RangeForm::Raw, Parameters::Pose))?;
    Ok(estimate(snapshot, &moved(&start, &step), 1, Optimum::Formula))
}

/// The least `sum rho((r_mn - y_mn)/sigma_mn)` over SO(D) x R^D, each pair with its own variance.
///
/// Levenberg and Marquardt's method from the SUC-LS; where that does not exist, from both poses that a linear fit leaves on the
/// two sides of the anchors' plane: M = D anchors are enough. Variances that depend on the range are first taken at the
/// measured ranges, then at those of the fit, so that short ranges do not draw the body.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause.
pub fn maximum_likelihood<const D: usize>(snapshot: &Snapshot<D>, loss: Loss) -> Result<Estimate<D>> {
    let starts = match simplified(snapshot, Manifold::So) {
        Ok(estimate) => [Some(centred(snapshot, &estimate)), None],
        Err(_) => both_sides(snapshot),
    };
    let fits = starts.into_iter().flatten().map(|start| fit(snapshot, loss, start));
    let best = fits.reduce(|a, b| if b.cost < a.cost { b } else { a });
    let unseen = || snapshot.unobservable(WHAT, RangeForm::Raw, Parameters::Pose);
    let best = best.filter(|best| best.seen).ok_or_else(unseen)?;
    Ok(estimate(snapshot, &best.pose, best.iterations, Optimum::Local))
}

struct Fit<const D: usize> {
    pose: Pose<D>,
    cost: f64,
    iterations: usize,
    seen: bool,
}

fn fit<const D: usize>(snapshot: &Snapshot<D>, loss: Loss, start: Pose<D>) -> Fit<D> {
    let mut ranges = RangeFit::new(snapshot, loss);
    let (mut pose, mut iterations) = descend(&ranges, start);
    if matches!(snapshot.model.noise(), RangeNoise::Toa { .. }) {
        ranges.reweigh(&pose);
        let (next, more) = descend(&ranges, pose);
        (pose, iterations) = (next, iterations + more);
    }
    let linearized = ranges.linearized(&pose);
    Fit { pose, cost: linearized.cost, iterations, seen: is_seen(&linearized) }
}

/// Levenberg and Marquardt: the damping falls after a step that lowers the cost and rises after one that does not.
fn descend<const D: usize>(ranges: &RangeFit<D>, start: Pose<D>) -> (Pose<D>, usize) {
    let (mut pose, mut damping) = (start, 1e-3);
    let mut linearized = ranges.linearized(&pose);
    for iteration in 1..=MAX_ITERATIONS {
        let Some(step) = step(&linearized, damping) else {
            damping = 10.0 * damping + 1e-9;
            continue;
        };
        let promise = -linearized.slope.dot(&step);
        if !(promise > SETTLED * linearized.cost + f64::MIN_POSITIVE) {
            return (pose, iteration - 1);
        }
        let next = moved(&pose, &step);
        if ranges.cost(&next) < linearized.cost {
            (pose, damping) = (next, 0.1 * damping);
            linearized = ranges.linearized(&pose);
        } else if promise < 1e3 * SETTLED * linearized.cost {
            return (pose, iteration);
        } else {
            damping = 10.0 * damping + 1e-9;
        }
    }
    (pose, MAX_ITERATIONS)
}

fn step(linearized: &Linearized, damping: f64) -> Option<TangentVector> {
    let mut curvature = linearized.curvature;
    for i in 0..MAX_TANGENT {
        curvature[(i, i)] *= 1.0 + damping;
    }
    spd_inverse(&curvature).ok().map(|inverse| -(inverse * linearized.slope))
}

/// Whether the ranges tell every motion of the body.
fn is_seen(linearized: &Linearized) -> bool {
    let curvature = &linearized.curvature;
    spd_inverse(curvature)
        .is_ok_and(|inverse| (0..MAX_TANGENT).all(|i| curvature[(i, i)] * inverse[(i, i)] < MAX_INFLATION))
}

fn moved<const D: usize>(pose: &Pose<D>, step: &TangentVector) -> Pose<D> {
    let (phi, shift) = split(step);
    let Pose { rotation, position } = pose.retract(&phi, &shift);
    Pose { rotation: rotation.renormalized(), position }
}

/// The pose of the sensors' centroid.
fn centred<const D: usize>(snapshot: &Snapshot<D>, estimate: &Estimate<D>) -> Pose<D> {
    let Theta { orientation, position } = estimate.theta.unwrap_or_default();
    let rotation = Rotation::from_matrix_unchecked(orientation);
    Pose { rotation, position: position + orientation * snapshot.centre }
}

fn estimate<const D: usize>(
    snapshot: &Snapshot<D>,
    pose: &Pose<D>,
    iterations: usize,
    optimum: Optimum,
) -> Estimate<D> {
    Estimate::new(snapshot.in_body_frame(*pose.rotation.matrix(), pose.position), iterations, optimum)
}

/// Where the anchors lie in a plane (D = 2: on a line): the linear fit in it, and the height above it on both sides, from what
/// the projection leaves over, `mean e = height^2`.
fn both_sides<const D: usize>(snapshot: &Snapshot<D>) -> [Option<Pose<D>>; 2] {
    let (mut gram, mut moment) = (SMatrix::<f64, D, D>::zeros(), SMatrix::<f64, D, D>::zeros());
    let (mut place, mut squared_height, mut count) = (SVector::<f64, D>::zeros(), 0.0, 0.0);
    for (equations, lever) in snapshot.equations.iter().zip(&snapshot.levers) {
        let own = psd_pseudo_inverse(&equations.gram) * equations.vector;
        gram += equations.gram;
        moment += own * lever.transpose();
        place += own;
        squared_height += equations.offset + 2.0 * equations.centre.dot(&own) - own.norm_squared();
        count += 1.0;
    }
    let place = place / count;
    let normal = singular(&gram).right.column(D - 1).into_owned();
    let height = normal * sqrt((squared_height / count).max(0.0));
    let rotation = Rotation::project(&moment, Manifold::So);
    [1.0, -1.0].map(|side| {
        let position = snapshot.place + place + height * side;
        position.iter().all(|x| x.is_finite()).then_some(Pose { rotation, position })
    })
}
