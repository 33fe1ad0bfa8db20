//! Symmetric positive definite matrices of a size known only when the program runs.

use nalgebra::{Cholesky, DMatrix, Dyn};

/// A pivot below this part of its diagonal entry carries no digit that could be trusted.
const PIVOT_FLOOR: f64 = 1e-13;

/// The Cholesky factor of a matrix, of which the lower triangle is read.
///
/// # Errors
/// The least pivot in parts of its diagonal entry, 0 where one is not positive: what is left of the information about one
/// parameter once the others are unknown too.
///
/// ```
/// use nalgebra::dmatrix;
/// use rangelab::math::definite::definite_factor;
/// let factor = definite_factor(&dmatrix![4.0, 2.0; 2.0, 5.0]).unwrap();
/// assert_eq!(factor.l(), dmatrix![2.0, 0.0; 1.0, 2.0]);
/// assert_eq!(definite_factor(&dmatrix![1.0, 1.0; 1.0, 1.0]).unwrap_err(), 0.0);
/// ```
pub fn definite_factor(matrix: &DMatrix<f64>) -> Result<Cholesky<f64, Dyn>, f64> {
    let Some(factor) = matrix.clone().cholesky() else { return Err(0.0) };
    let lower = factor.l_dirty();
    let part = |i: usize| lower[(i, i)] * lower[(i, i)] / matrix[(i, i)];
    // NaN must not pass as a large pivot.
    let least =
        (0..matrix.nrows()).map(part).fold(1.0, |least: f64, part| if part >= least { least } else { part });
    if least > PIVOT_FLOOR { Ok(factor) } else { Err(least) }
}
