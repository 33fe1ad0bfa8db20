//! Orthogonal matrices of a dimension known only when the program runs.

use nalgebra::{DMatrix, SMatrix};

use super::rotation::determinant;
use super::singular::singular;
use crate::error::{Error, Result};

/// The element of O(D) nearest to a D x D matrix, `U V^T`; reflections too.
///
/// # Errors
/// [`Error::Number`] for a dimension other than 2 or 3.
///
/// ```
/// use nalgebra::dmatrix;
/// use rangelab::math::orthogonal::nearest_orthogonal;
/// let mirror = nearest_orthogonal(&dmatrix![0.0, 2.0; 5.0, 0.0])?;
/// assert_eq!(mirror, dmatrix![0.0, 1.0; 1.0, 0.0]);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn nearest_orthogonal(matrix: &DMatrix<f64>) -> Result<DMatrix<f64>> {
    match matrix.nrows() {
        2 => Ok(nearest::<2>(matrix, false)),
        3 => Ok(nearest::<3>(matrix, false)),
        other => Err(unknown(other)),
    }
}

/// The element of SO(D) nearest to a D x D matrix.
///
/// # Errors
/// [`Error::Number`] for a dimension other than 2 or 3.
pub fn nearest_rotation(matrix: &DMatrix<f64>) -> Result<DMatrix<f64>> {
    match matrix.nrows() {
        2 => Ok(nearest::<2>(matrix, true)),
        3 => Ok(nearest::<3>(matrix, true)),
        other => Err(unknown(other)),
    }
}

fn unknown(dimension: usize) -> Error {
    Error::Number { what: "the dimension", value: dimension as f64, limit: "2 or 3" }
}

fn nearest<const D: usize>(matrix: &DMatrix<f64>, proper: bool) -> DMatrix<f64> {
    let s = singular(&SMatrix::<f64, D, D>::from_fn(|i, j| matrix[(i, j)]));
    let mut left = s.left;
    if proper && determinant(&(left * s.right.transpose())) < 0.0 {
        // The least singular value pays for the sign.
        left.column_mut(D - 1).neg_mut();
    }
    let nearest = left * s.right.transpose();
    DMatrix::from_fn(D, D, |i, j| nearest[(i, j)])
}
