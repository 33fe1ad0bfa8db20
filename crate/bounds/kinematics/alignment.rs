//! What is compared: a derivative of the motion at an instant, centred, after an alignment.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::WHAT;
use crate::error::{Error, Result};
use crate::math::definite::definite_factor;
use crate::model::kinematics::coefficients::{RelativeKinematics, centred_columns};
use crate::model::kinematics::gauge_directions::turn_fields;
use crate::model::kinematics::time_scale::TimeScale;
use crate::with_dimension;

/// A derivative of the motion at an instant: its value, and how it follows from the unknowns.
pub struct ReadOut {
    dimension: usize,
    /// D N numbers, node by node.
    value: DVector<f64>,
    /// (D N) x unknowns, with the mean over the nodes taken away.
    linear: DMatrix<f64>,
}

impl ReadOut {
    /// How it follows from the unknowns.
    pub fn into_linear(self) -> DMatrix<f64> {
        self.linear
    }
}

/// Weights of the coefficients of powers of scaled time in a derivative by time (s) at an instant.
fn weights(scale: &TimeScale, degree: usize, derivative: usize, time: f64) -> Vec<f64> {
    let s = scale.scaled(time);
    let of_power = |power: usize| {
        if power < derivative {
            return 0.0;
        }
        // d^r s^p/dt^r = p (p - 1) ... (p - r + 1) s^(p - r)/half^r.
        let falling = (0..derivative).fold(1.0, |product, i| product * (power - i) as f64 / scale.half);
        (derivative..power).fold(falling, |product, _| product * s)
    };
    (0..=degree).map(of_power).collect()
}

/// The derivative of some order at an instant (s); its value is exact, for the motion is known.
pub fn read_out(motion: &RelativeKinematics, scale: &TimeScale, derivative: usize, time: f64) -> ReadOut {
    let (dimension, nodes) = (motion.dimension(), motion.nodes());
    let block = dimension * nodes;
    let centring = DMatrix::from_fn(block, block, |i, j| {
        let mean = if i % dimension == j % dimension { 1.0 / nodes as f64 } else { 0.0 };
        if i == j { 1.0 - mean } else { -mean }
    });
    let mut linear = DMatrix::zeros(block, block * (motion.degree() + 1));
    for (l, weight) in weights(scale, motion.degree(), derivative, time).into_iter().enumerate() {
        linear.view_mut((0, l * block), (block, block)).copy_from(&(&centring * weight));
    }
    let value = DVector::from_column_slice(centred_columns(&motion.derivative(derivative, time)).as_slice());
    ReadOut { dimension, value, linear }
}

/// How errors of a read-out follow from those of the unknowns once a reference is aligned: `e + Omega x`, `Omega` skew with
/// the least `||e_reference + Omega x_reference||`, the first order of Procrustes' rotation.
///
/// # Errors
/// [`Error::Degenerate`] where a turn leaves the reference as it is.
pub fn aligned(read: &ReadOut, reference: &ReadOut) -> Result<DMatrix<f64>> {
    let fields = |read: &ReadOut| with_dimension!(read.dimension, D => Ok::<_, Error>(turn_fields::<D>(read.value.as_slice())));
    let (turned, of_reference) =
        (DMatrix::from_columns(&fields(read)?), DMatrix::from_columns(&fields(reference)?));
    let factor = definite_factor(&of_reference.tr_mul(&of_reference)).map_err(|value| {
        let reason =
            "The positions that are aligned lie on a line or in a point, and a turn leaves them as they are.";
        Error::Degenerate { what: WHAT, value, reason }
    })?;
    let angles = factor.solve(&of_reference.tr_mul(&reference.linear));
    Ok(&read.linear - turned * angles)
}
