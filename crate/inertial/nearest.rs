//! The nearest positive definite matrix, for a covariance that lost it.

use super::bilinear::StateMatrix;
use super::filter::not_positive;
use crate::error::Result;
use crate::math::cholesky::Cholesky;

/// Least eigenvalue left, as a part of the largest: well above what the Cholesky factorization refuses.
const FLOOR: f64 = 1e-12;

/// The matrix nearest in the Frobenius norm to the symmetric part of `p` among those whose eigenvalues are at least a
/// 1e-12th of its largest (Higham 1988; \[I\] uses `nearestSPD`), with its Cholesky factor.
///
/// # Errors
/// [`crate::Error::NotPositiveDefinite`] where `p` is not finite or has no positive eigenvalue.
pub fn nearest_positive_definite(p: &StateMatrix) -> Result<(StateMatrix, Cholesky<15>)> {
    let symmetric = (p + p.transpose()) * 0.5;
    if symmetric.iter().any(|x| !x.is_finite()) {
        return Err(not_positive(f64::NAN));
    }
    let mut decomposition = symmetric.symmetric_eigen();
    let largest = decomposition.eigenvalues.iter().fold(0.0_f64, |largest, x| largest.max(*x));
    for value in decomposition.eigenvalues.iter_mut() {
        *value = value.max(FLOOR * largest);
    }
    let repaired = decomposition.recompose();
    let repaired = (repaired + repaired.transpose()) * 0.5;
    let factor = Cholesky::new(&repaired).map_err(not_positive)?;
    Ok((repaired, factor))
}
