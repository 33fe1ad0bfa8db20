//! Unitarily constrained least squares in closed form: the orthogonal Procrustes problem.

use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};

use super::reduced::ReducedMetric;
use super::snapshot::Snapshot;
use super::{Estimate, Optimum};
use crate::error::{Error, Result};
use crate::math::rotation::{Manifold, Rotation};
use crate::model::lack::Parameters;
use crate::model::ranging::RangeForm;
use crate::model::spread::Spread;

/// SUC-LS, and SUC-TLS, which is the same (\[L\] Theorems 1 and 2): the orthogonal matrix that takes the body nearest to the
/// classical positions of its sensors, all weighted alike. Sensors whose own ranges do not show them are left out.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause.
pub fn simplified<const D: usize>(snapshot: &Snapshot<D>, manifold: Manifold) -> Result<Estimate<D>> {
    let (mut count, mut place, mut lever) = (0.0, SVector::<f64, D>::zeros(), SVector::<f64, D>::zeros());
    let mut moment = SMatrix::<f64, D, D>::zeros();
    for (n, c) in snapshot.levers.iter().enumerate() {
        if let Some(s) = snapshot.sensor_position(n) {
            let s = s - snapshot.place;
            count += 1.0;
            place += s;
            lever += c;
            moment += s * c.transpose();
        }
    }
    let fits = count > 0.0 && snapshot.sensor_rank() + 1 >= D;
    if !fits || (count < snapshot.levers.len() as f64 && !spans(snapshot)) {
        return Err(unseen(snapshot, "SUC-LS"));
    }
    let (place, lever) = (place / count, lever / count);
    moment -= place * lever.transpose() * count;
    let orientation = *Rotation::project(&moment, manifold).matrix();
    let centroid = snapshot.place + place - orientation * lever;
    Ok(Estimate::new(snapshot.in_body_frame(orientation, centroid), 0, Optimum::Formula))
}

/// Weighted SUC-LS: the polar factor of `R Q_LS`, the nearest orthogonal matrix in the metric of the anchors.
///
/// The SUC-LS is the polar factor of `Q_LS C C^T`. Each is the OUC-LS, `arg min tr(R (Q - Q_LS) C C^T (Q - Q_LS)^T)`, with one of
/// its two weights left out: exact for a body of equal moments, `C C^T ~ I`, as the SUC-LS is where the anchors see all
/// directions alike, `R ~ I`. Both are right without noise; with both weights, as the polar factor of `R Q_LS C C^T`, it would
/// not be. Where sensors do not share `R`, their sum weighted by the distances from the centroid takes its place.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause.
pub fn weighted<const D: usize>(snapshot: &Snapshot<D>, manifold: Manifold) -> Result<Estimate<D>> {
    let what = "weighted SUC-LS";
    let reduced = snapshot.reduced(what, 0.0)?;
    if snapshot.sensor_rank() + 1 < D {
        return Err(unseen(snapshot, what));
    }
    let anchors = match &reduced.metric {
        ReducedMetric::Shared(metric) => metric.anchors,
        ReducedMetric::Full(metric) => (0..D).fold(SMatrix::zeros(), |sum, j| sum + metric.block(j, j)),
    };
    let orientation = *Rotation::project(&(anchors * reduced.target), manifold).matrix();
    let centroid = reduced.centroid(&orientation);
    Ok(Estimate::new(snapshot.in_body_frame(orientation, centroid), 0, Optimum::Formula))
}

/// Whether the sensors that are seen by themselves show every turn.
fn spans<const D: usize>(snapshot: &Snapshot<D>) -> bool {
    let seen = (0..snapshot.levers.len()).filter(|&n| snapshot.sensor_position(n).is_some());
    let sensors: Vec<_> = seen.map(|n| snapshot.levers[n]).collect();
    !sensors.is_empty() && Spread::of(&sensors).rank() + 1 >= D
}

fn unseen<const D: usize>(snapshot: &Snapshot<D>, what: &'static str) -> Error {
    snapshot.unobservable(what, RangeForm::Projected, Parameters::Pose)
}
