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
            noise.zip_apply(&root.rows(power * block, block), |sum, value| *sum += weight * value);
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

    /// How its error follows from the noise once a reference is aligned: `e + Omega x`, `Omega` skew with the least
    /// `||e_reference + Omega x_reference||`, the first order of Procrustes' rotation.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where a turn leaves the reference as it is.
    pub fn aligned(&self, reference: &Self) -> Result<DMatrix<f64>> {
        let (turned, of_reference) = (self.turns()?, reference.turns()?);
        let factor = definite_factor(&of_reference.tr_mul(&of_reference)).map_err(|value| {
            let reason =
                "The positions that are aligned lie on a line or in a point, and a turn leaves them as they are.";
            Error::Degenerate { what: WHAT, value, reason }
        })?;
        let angles = factor.solve(&of_reference.tr_mul(&reference.noise));
        Ok(&self.noise - turned * angles)
    }

    /// What small turns change, a column for each plane.
    fn turns(&self) -> Result<DMatrix<f64>> {
        let fields =
            with_dimension!(self.dimension, D => Ok::<_, Error>(turn_fields::<D>(self.value.as_slice())))?;
        Ok(DMatrix::from_columns(&fields))
    }
}
