//! Singular values and vectors of a D x D matrix by one-sided Jacobi rotations.
//!
//! Written here because a library's decomposition would put trait bounds on `D` into every generic caller, and because
//! one-sided Jacobi keeps the relative accuracy of small singular values, on which projections of badly seen
//! orientations depend.

use nalgebra::{SMatrix, SVector};

use super::float::sqrt;

/// `A = U diag(values) V^T` with singular values in decreasing order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singular<const D: usize> {
    /// Left singular vectors, orthogonal also where `A` is rank deficient.
    pub left: SMatrix<f64, D, D>,
    /// Singular values, decreasing, non-negative.
    pub values: [f64; D],
    /// Right singular vectors.
    pub right: SMatrix<f64, D, D>,
}

const MAX_SWEEPS: usize = 40;

/// Cosine below which two columns are orthogonal: what rounding leaves of the sums that make it. Half as much would send
/// nearly orthogonal matrices through sweep after sweep.
const ORTHOGONAL: f64 = 4.0 * f64::EPSILON;

/// Decomposes a finite matrix.
///
/// ```
/// use nalgebra::Matrix2;
/// let a = Matrix2::new(0.0, -3.0, 2.0, 0.0);
/// let s = rangelab::math::singular::singular(&a);
/// assert_eq!(s.values, [3.0, 2.0]);
/// ```
pub fn singular<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Singular<D> {
    let scale = power_of_two_below(matrix);
    let mut work = *matrix / scale;
    let mut right = SMatrix::identity();
    for _ in 0..MAX_SWEEPS {
        let mut rotated = false;
        for p in 0..D {
            for q in p + 1..D {
                rotated |= orthogonalize(&mut work, &mut right, p, q);
            }
        }
        if !rotated {
            break;
        }
    }
    sort_columns(&mut work, &mut right);
    let mut values = [0.0; D];
    for j in 0..D {
        values[j] = sqrt(work.column(j).norm_squared());
    }
    let left = orthonormal_columns(&work, &values);
    Singular { left, values: values.map(|value| value * scale), right }
}

/// The power of two at or below the largest entry: scaling by it is exact and keeps squares of entries in range.
fn power_of_two_below<const D: usize>(matrix: &SMatrix<f64, D, D>) -> f64 {
    const EXPONENT_BITS: u64 = 0x7ff0_0000_0000_0000;
    let largest = matrix.iter().fold(f64::MIN_POSITIVE, |largest, x| largest.max(x.abs()));
    f64::from_bits(largest.to_bits() & EXPONENT_BITS)
}

/// Rotates columns `p` and `q` until they are orthogonal; false if they already were.
fn orthogonalize<const D: usize>(
    a: &mut SMatrix<f64, D, D>,
    v: &mut SMatrix<f64, D, D>,
    p: usize,
    q: usize,
) -> bool {
    let alpha = a.column(p).norm_squared();
    let beta = a.column(q).norm_squared();
    let gamma = a.column(p).dot(&a.column(q));
    if gamma == 0.0 || gamma.abs() <= ORTHOGONAL * sqrt(alpha * beta) {
        return false;
    }
    let zeta = (beta - alpha) / (2.0 * gamma);
    let tangent = zeta.signum() / (zeta.abs() + sqrt(1.0 + zeta * zeta));
    let cosine = 1.0 / sqrt(1.0 + tangent * tangent);
    let sine = cosine * tangent;
    for matrix in [a, v] {
        for i in 0..D {
            let (x, y) = (matrix[(i, p)], matrix[(i, q)]);
            matrix[(i, p)] = cosine * x - sine * y;
            matrix[(i, q)] = sine * x + cosine * y;
        }
    }
    true
}

fn sort_columns<const D: usize>(a: &mut SMatrix<f64, D, D>, v: &mut SMatrix<f64, D, D>) {
    for i in 0..D {
        for j in i + 1..D {
            if a.column(j).norm_squared() > a.column(i).norm_squared() {
                a.swap_columns(i, j);
                v.swap_columns(i, j);
            }
        }
    }
}

/// Scales columns to unit length; a vanishing column is replaced by a unit vector orthogonal to those before it.
fn orthonormal_columns<const D: usize>(a: &SMatrix<f64, D, D>, values: &[f64; D]) -> SMatrix<f64, D, D> {
    let mut left = SMatrix::zeros();
    for j in 0..D {
        let column = if values[j] > f64::EPSILON * values[0] && values[j] > f64::MIN_POSITIVE {
            a.column(j) / values[j]
        } else {
            completion(&left, j)
        };
        left.set_column(j, &column);
    }
    left
}

/// A unit vector orthogonal to the first `count` (orthonormal) columns.
fn completion<const D: usize>(columns: &SMatrix<f64, D, D>, count: usize) -> SVector<f64, D> {
    let mut best = SVector::<f64, D>::zeros();
    for axis in 0..D {
        let mut candidate = SVector::<f64, D>::zeros();
        candidate[axis] = 1.0;
        // Twice, so that what rounding left behind goes too.
        for _ in 0..2 {
            for j in 0..count {
                let overlap = columns.column(j).dot(&candidate);
                candidate -= columns.column(j) * overlap;
            }
        }
        if candidate.norm_squared() > best.norm_squared() {
            best = candidate;
        }
    }
    best / best.norm()
}

/// Moore-Penrose inverse of a symmetric positive semidefinite matrix; directions below `1e-12` of the largest
/// singular value count as null.
pub fn psd_pseudo_inverse<const D: usize>(matrix: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    let s = singular(matrix);
    let mut inverse = SMatrix::zeros();
    for k in 0..D {
        if s.values[k] > 1e-12 * s.values[0] {
            let direction = s.right.column(k);
            inverse += direction * direction.transpose() / s.values[k];
        }
    }
    inverse
}
