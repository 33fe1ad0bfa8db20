//! What the accelerations of all nodes cost.

use nalgebra::{DMatrix, DVector};

use crate::error::{Error, Result};
use crate::math::orthogonal::nearest_orthogonal;
use crate::model::kinematics::coefficients::centred_columns;
use crate::model::kinematics::distance_record::DistanceRecord;

/// How many times better exact readings are taken to be than those that are not.
const EXACT: f64 = 1e4;

/// Half the sum of the squares of the accelerations, compressed to as many numbers as the motion has accelerations:
/// `1/2 ||factor c - target||^2` for the coefficients `c_2, ..., c_L` of powers of scaled time, the same factor for each
/// coordinate of each node.
///
/// Readings are centred: a common acceleration, gravity for one, says nothing about the relative motion.
#[derive(Clone, Debug)]
pub struct AccelerationCost {
    /// At most (L - 1) x (L - 1).
    factor: DMatrix<f64>,
    /// A column for each coordinate of each node.
    target: DMatrix<f64>,
}

impl AccelerationCost {
    /// The readings of a record and a motion of some degree.
    ///
    /// # Errors
    /// [`Error::TooFew`] where there are none, [`Error::Number`] for a degree below 2.
    pub fn new(record: &DistanceRecord, degree: usize) -> Result<Self> {
        let accelerometers = record.needed_accelerometers(super::WHAT)?;
        if degree < 2 {
            let (what, limit) = ("the degree of the motion", "at least 2 where accelerations are read");
            return Err(Error::Number { what, value: degree as f64, limit });
        }
        let scale = record.time_scale();
        let squared = scale.half * scale.half;
        let weight = 1.0 / sigma(record.sigma(), accelerometers.sigma * squared);
        let (stamps, size) = (record.stamps(), record.dimension() * record.nodes());
        // half^2 d^2 s^l/dt^2 = l (l - 1) s^(l-2).
        let mut design = DMatrix::zeros(stamps.len(), degree - 1);
        let mut readings = DMatrix::zeros(stamps.len(), size);
        for (k, &time) in stamps.iter().enumerate() {
            let mut power = weight;
            for l in 2..=degree {
                design[(k, l - 2)] = power * (l * (l - 1)) as f64;
                power *= scale.scaled(time);
            }
            let centred = centred_columns(&accelerometers.readings[k]);
            readings.row_mut(k).iter_mut().zip(&centred).for_each(|(to, from)| *to = weight * squared * from);
        }
        let qr = design.qr();
        Ok(Self { target: qr.q().tr_mul(&readings), factor: qr.r() })
    }

    fn residual(&self, unknowns: &DVector<f64>) -> DMatrix<f64> {
        &self.factor * self.accelerations(unknowns) - &self.target
    }

    /// `c_2, ..., c_L`, a row each.
    fn accelerations(&self, unknowns: &DVector<f64>) -> DMatrix<f64> {
        let size = self.target.ncols();
        DMatrix::from_row_slice(self.factor.ncols(), size, &unknowns.as_slice()[2 * size..])
    }

    /// The cost.
    pub fn cost(&self, unknowns: &DVector<f64>) -> f64 {
        0.5 * self.residual(unknowns).norm_squared()
    }

    /// Adds slope and curvature, and returns the cost.
    pub fn expand(
        &self,
        unknowns: &DVector<f64>,
        gradient: &mut DVector<f64>,
        hessian: &mut DMatrix<f64>,
    ) -> f64 {
        let residual = self.residual(unknowns);
        let slopes = self.factor.tr_mul(&residual);
        let gram = self.factor.tr_mul(&self.factor);
        let size = self.target.ncols();
        for l in 0..gram.nrows() {
            for coordinate in 0..size {
                let row = (l + 2) * size + coordinate;
                gradient[row] += slopes[(l, coordinate)];
                for m in 0..gram.nrows() {
                    hessian[(row, (m + 2) * size + coordinate)] += gram[(l, m)];
                }
            }
        }
        0.5 * residual.norm_squared()
    }

    /// The element of O(D) that brings the accelerations of a motion nearest to the readings.
    ///
    /// # Errors
    /// [`Error::Number`] for a dimension other than 2 or 3.
    pub fn frame(&self, dimension: usize, unknowns: &DVector<f64>) -> Result<DMatrix<f64>> {
        let modelled = &self.factor * self.accelerations(unknowns);
        let mut moment = DMatrix::zeros(dimension, dimension);
        for row in 0..modelled.nrows() {
            for first in (0..modelled.ncols()).step_by(dimension) {
                let read = self.target.view((row, first), (1, dimension));
                moment += read.transpose() * modelled.view((row, first), (1, dimension));
            }
        }
        nearest_orthogonal(&moment)
    }
}

/// The standard deviation of an acceleration times the square of half the interval, m, beside distances of standard
/// deviation `distance`, which counts as 1 m where it is 0. Exact readings are [`EXACT`] times better than the others.
fn sigma(distance: f64, acceleration: f64) -> f64 {
    match (distance > 0.0, acceleration > 0.0) {
        (true, true) => acceleration,
        (true, false) => distance / EXACT,
        (false, true) => EXACT,
        (false, false) => 1.0,
    }
}
