//! Unitarily constrained least squares in closed form: the orthogonal Procrustes problem.

use nalgebra::{SMatrix, SVector};

use super::snapshot::Snapshot;
use super::{Estimate, Optimum};
use crate::error::Result;
use crate::math::rotation::{Manifold, Rotation};
use crate::model::lack::Parameters;
use crate::model::ranging::RangeForm;

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

/// Weighted SUC-LS: the polar factor of `B C^T` instead of that of `R^-1 B C^T`.
///
/// Multiplied out, the cost of the OUC-LS is `tr(R Q C C^T Q^T) - 2 tr(Q^T B C^T)`. For a body of equal moments, `C C^T ~ I`,
/// the first term does not depend on `Q` and this is the OUC-LS; the SUC-LS is that where the anchors see all directions
/// alike, `R ~ I`. It needs no position of any single sensor.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause.
pub fn weighted<const D: usize>(snapshot: &Snapshot<D>, manifold: Manifold) -> Result<Estimate<D>> {
    let what = "weighted SUC-LS";
    let reduced = snapshot.reduced(what, 0.0)?;
    if snapshot.sensor_rank() + 1 < D {
        return Err(unseen(snapshot, what));
    }
    let orientation = *Rotation::project(&reduced.weighted, manifold).matrix();
    let centroid = reduced.centroid(&orientation);
    Ok(Estimate::new(snapshot.in_body_frame(orientation, centroid), 0, Optimum::Formula))
}

/// Whether the sensors that are seen by themselves show every turn.
fn spans<const D: usize>(snapshot: &Snapshot<D>) -> bool {
    let seen = (0..snapshot.levers.len()).filter(|&n| snapshot.sensor_position(n).is_some());
    let sensors: alloc::vec::Vec<_> = seen.map(|n| snapshot.levers[n]).collect();
    !sensors.is_empty() && crate::model::spread::Spread::of(&sensors).rank() + 1 >= D
}

fn unseen<const D: usize>(snapshot: &Snapshot<D>, what: &'static str) -> crate::error::Error {
    snapshot.unobservable(what, RangeForm::Projected, Parameters::Pose)
}
