//! The position of one transmitter from its ranges, by itself.

use nalgebra::{Matrix3, Vector3};

use crate::error::{Error, Result};
use crate::math::float::sqrt;
use crate::math::linalg::{add_outer, spd_inverse};

const MAX_ITERATIONS: usize = 50;
/// A step shorter than this is the last (m).
pub(super) const LAST: f64 = 1e-11;
/// Of shorter steps than this (m) the sum of squares tells nothing but rounding: they are taken as they are.
pub(super) const ROUNDING: f64 = 1e-6;
/// Distances below this have no direction (m).
pub(super) const NEAREST: f64 = 1e-6;

/// A position found from ranges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trilateration {
    /// The position, m.
    pub position: Vector3<f64>,
    /// `(J^T J)^-1`, to be multiplied by the variance of a range.
    pub geometry: Matrix3<f64>,
}

/// Least squares on the ranges, `min sum_j (s_j - ||x - b_j||)^2`, by Gauss-Newton from `start`, with steps that are halved
/// where the sum would rise.
///
/// `ranges` gives beacon and range of each range that is there. Beacons in one plane leave two minima; the one on the side
/// of `start` is found.
///
/// # Errors
/// [`Error::Unobservable`] for fewer than three ranges or beacons in a line with the transmitter; [`Error::Number`] where
/// the solution is on a beacon; [`Error::NoConvergence`].
pub fn trilaterate<'a>(
    ranges: &(impl Iterator<Item = (&'a Vector3<f64>, f64)> + Clone),
    start: &Vector3<f64>,
) -> Result<Trilateration> {
    let count = ranges.clone().count();
    let mut best = Evaluation::at(ranges.clone(), start)?;
    let mut scale = 1.0;
    let mut length = f64::INFINITY;
    for _ in 0..MAX_ITERATIONS {
        let inverse = spd_inverse(&best.normal).map_err(|_| unseen(count))?;
        let step = inverse * best.gradient;
        length = sqrt(step.norm_squared());
        if length <= LAST {
            let position = best.position + step;
            return Ok(Trilateration { position, geometry: inverse });
        }
        let candidate = Evaluation::at(ranges.clone(), &(best.position + step * scale))?;
        if candidate.cost <= best.cost || length * scale <= ROUNDING {
            (best, scale) = (candidate, 1.0);
        } else {
            scale *= 0.5;
        }
    }
    Err(Error::NoConvergence { what: "trilateration", iterations: MAX_ITERATIONS, last_step: length })
}

fn unseen(ranges: usize) -> Error {
    let reason = "Beacons and transmitter lie in a plane or a line.".into();
    Error::Unobservable { what: "trilateration", ranges, reason }
}

/// The sum of squares at a position, with its Gauss-Newton model.
struct Evaluation {
    position: Vector3<f64>,
    cost: f64,
    normal: Matrix3<f64>,
    gradient: Vector3<f64>,
}

impl Evaluation {
    fn at<'a>(
        ranges: impl Iterator<Item = (&'a Vector3<f64>, f64)>,
        position: &Vector3<f64>,
    ) -> Result<Self> {
        let mut result =
            Self { position: *position, cost: 0.0, normal: Matrix3::zeros(), gradient: Vector3::zeros() };
        for (beacon, range) in ranges {
            let (distance, direction) = line_of_sight(beacon, position)?;
            let residual = range - distance;
            result.cost += residual * residual;
            result.gradient += direction * residual;
            add_outer(&mut result.normal, 1.0, &direction, &direction);
        }
        Ok(result)
    }
}

/// Distance from a beacon, and the unit vector from it.
///
/// # Errors
/// [`Error::Number`] on the beacon, where a range has no direction.
pub(super) fn line_of_sight(beacon: &Vector3<f64>, position: &Vector3<f64>) -> Result<(f64, Vector3<f64>)> {
    let difference = position - beacon;
    let distance = sqrt(difference.norm_squared());
    if distance > NEAREST {
        return Ok((distance, difference / distance));
    }
    let limit = "above 1e-6 m: on a beacon a range has no direction";
    Err(Error::Number { what: "the distance of a transmitter from a beacon", value: distance, limit })
}
