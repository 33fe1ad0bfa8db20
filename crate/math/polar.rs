//! The polar factor by Newton's iteration: the short road for matrices that are nearly orthogonal.

use nalgebra::SMatrix;

use super::float::sqrt;
use super::rotation::determinant;

/// Scaled to `||X||_F = sqrt(D)`, the determinant is 1 for orthogonal matrices and falls with the condition. Above this the
/// iteration settles within a few steps and keeps all digits.
const WELL_CONDITIONED: f64 = 0.1;

/// Squared step after which the next error is below rounding: convergence is quadratic.
const SETTLED: f64 = 1e-17;

const MAX_ITERATIONS: usize = 20;

/// The polar factor of a well-conditioned matrix with positive determinant, by `X <- (X + X^-T)/2` (Higham); `None` for
/// other matrices.
pub(super) fn polar_factor<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Option<SMatrix<f64, D, D>> {
    let length = sqrt(matrix.norm_squared());
    let mut x = matrix * (sqrt(D as f64) / length);
    // At most 1 but for rounding; NaN and infinity, from lengths that under- or overflow, are refused too.
    if !(WELL_CONDITIONED..1.5).contains(&determinant(&x)) {
        return None;
    }
    for _ in 0..MAX_ITERATIONS {
        let half_step = (cofactors(&x) * (1.0 / determinant(&x)) - x) * 0.5;
        x += half_step;
        if half_step.norm_squared() <= SETTLED {
            break;
        }
    }
    Some(x)
}

/// `det(X) X^-T`.
#[inline]
fn cofactors<const D: usize>(x: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    if D == 2 {
        return SMatrix::from_fn(|i, j| if i == j { x[(1 - i, 1 - j)] } else { -x[(1 - i, 1 - j)] });
    }
    SMatrix::from_fn(|i, j| {
        let (a, b) = ((i + 1) % 3, (i + 2) % 3);
        let (c, d) = ((j + 1) % 3, (j + 2) % 3);
        x[(a, c)] * x[(b, d)] - x[(a, d)] * x[(b, c)]
    })
}
