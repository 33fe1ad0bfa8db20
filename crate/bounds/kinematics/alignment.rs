//! What is compared: a derivative of the motion at an instant, centred, after an alignment.

use nalgebra::{DMatrix, DVector};

use super::{KinematicsBound, WHAT};
use crate::error::{Error, Result};
use crate::math::definite::definite_factor;
use crate::model::kinematics::coefficients::centred_columns;
use crate::model::kinematics::gauge_directions::turn_fields;
use crate::with_dimension;

/// A derivative of the motion at an instant: its value, and how its error follows from the noise.
pub struct ReadOut {
    dimension: usize,
    /// D N numbers, node by node.
    value: DVector<f64>,
    /// (D N) x unknowns, by independent normal numbers of variance 1.
    noise: DMatrix<f64>,
}

impl ReadOut {
    /// The derivative of some order at an instant (s); its value is exact, for the motion is known.
    pub fn new(bound: &KinematicsBound, derivative: usize, time: f64) -> Self {
        let KinematicsBound { motion, scale, root } = bound;
        let (dimension, block) = (motion.dimension(), motion.coefficient(0).len());
        let s = scale.scaled(time);
        let mut noise = DMatrix::zeros(block, root.ncols());
        for power in derivative..=motion.degree() {
            // d^r s^p/dt^r = p (p - 1) ... (p - r + 1) s^(p - r)/half^r.
            let falling = (0..derivative).fold(1.0, |product, i| product * (power - i) as f64 / scale.half);
            let weight = (derivative..power).fold(falling, |product, _| product * s);
            for (mut sum, column) in noise.column_iter_mut().zip(root.column_iter()) {
                let part = &column.as_slice()[power * block..(power + 1) * block];
                add(sum.as_mut_slice(), weight, part);
            }
        }
        let value =
            DVector::from_column_slice(centred_columns(&motion.derivative(derivative, time)).as_slice());
        Self { dimension, value, noise }
    }

    /// How its error follows from the noise.
    pub fn into_noise(self) -> DMatrix<f64> {
        self.noise
    }

    /// This and `factor` times another.
    pub fn plus(self, factor: f64, other: &Self) -> Self {
        let Self { dimension, value, noise } = self;
        Self { dimension, value: value + &other.value * factor, noise: noise + &other.noise * factor }
    }

    /// How the turn follows from the noise that aligns it: angles of `Omega` skew with the least `||e + Omega x||`, the first
    /// order of Procrustes' rotation.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where a turn leaves it as it is.
    pub fn angles(&self) -> Result<DMatrix<f64>> {
        let turns = self.turns()?;
        let factor = definite_factor(&turns.tr_mul(&turns)).map_err(|value| {
            let reason =
                "The positions that are aligned lie on a line or in a point, and a turn leaves them as they are.";
            Error::Degenerate { what: WHAT, value, reason }
        })?;
        Ok(factor.solve(&turns.tr_mul(&self.noise)))
    }

    /// How its error follows from the noise after the turn by [`ReadOut::angles`] of a reference, `e + Omega x`.
    ///
    /// # Errors
    /// [`Error::Number`] for a dimension other than 2 or 3.
    pub fn turned(&self, angles: &DMatrix<f64>) -> Result<DMatrix<f64>> {
        let (turns, mut turned) = (self.turns()?, self.noise.clone());
        for (mut column, angles) in turned.column_iter_mut().zip(angles.column_iter()) {
            for (turn, &angle) in turns.column_iter().zip(angles.as_slice()) {
                add(column.as_mut_slice(), -angle, turn.as_slice());
            }
        }
        Ok(turned)
    }

    /// What small turns change, a column for each plane.
    fn turns(&self) -> Result<DMatrix<f64>> {
        let fields =
            with_dimension!(self.dimension, D => Ok::<_, Error>(turn_fields::<D>(self.value.as_slice())))?;
        Ok(DMatrix::from_columns(&fields))
    }
}

/// Adds `factor` times other numbers. As slices: these loops are what a bound over time takes its time for.
fn add(to: &mut [f64], factor: f64, numbers: &[f64]) {
    to.iter_mut().zip(numbers).for_each(|(to, number)| *to += factor * number);
}
