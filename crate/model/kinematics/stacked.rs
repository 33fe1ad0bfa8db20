//! The unknowns of a fit: coefficients of powers of scaled time, stacked as they lie in memory, coefficient by coefficient,
//! node by node, coordinate by coordinate.

use nalgebra::{DMatrix, DVector};

use super::coefficients::RelativeKinematics;

/// `Z_l/l!` one after the other, from the derivatives `Z_l` by scaled time.
///
/// ```
/// use nalgebra::dmatrix;
/// use rangelab::model::kinematics::coefficients::RelativeKinematics;
/// use rangelab::model::kinematics::stacked::{from_stacked_powers, stacked_powers};
/// let zero = dmatrix![0.0; 0.0];
/// let motion = RelativeKinematics::new(vec![zero.clone(), zero, dmatrix![2.0; 6.0]])?;
/// let stacked = stacked_powers(&motion);
/// assert_eq!(stacked.as_slice(), [0.0, 0.0, 0.0, 0.0, 1.0, 3.0]);
/// assert_eq!(from_stacked_powers(2, 1, stacked.as_slice()), motion);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn stacked_powers(scaled: &RelativeKinematics) -> DVector<f64> {
    let block = scaled.coefficient(0).len();
    let mut stacked = DVector::zeros((scaled.degree() + 1) * block);
    let mut factorial = 1.0;
    for (l, coefficient) in scaled.coefficients().iter().enumerate() {
        factorial *= l.max(1) as f64;
        stacked.rows_mut(l * block, block).copy_from_slice((coefficient / factorial).as_slice());
    }
    stacked
}

/// The derivatives by scaled time from [`stacked_powers`].
pub fn from_stacked_powers(dimension: usize, nodes: usize, stacked: &[f64]) -> RelativeKinematics {
    let mut factorial = 1.0;
    let derivative = |(l, power): (usize, &[f64])| {
        factorial *= l.max(1) as f64;
        DMatrix::from_column_slice(dimension, nodes, power) * factorial
    };
    let coefficients = stacked.chunks_exact(dimension * nodes).enumerate().map(derivative).collect();
    RelativeKinematics::from_coefficients(coefficients)
}
