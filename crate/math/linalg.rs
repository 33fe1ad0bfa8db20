//! Symmetric positive definite matrices of fixed small size, without heap and without trait bounds in signatures.

use nalgebra::{SMatrix, SVector};

/// A pivot smaller than this part of its diagonal entry carries no correct digit.
const PIVOT_FLOOR: f64 = 1e-14;

/// The inverse of a pivot that carries digits, held against its diagonal entry before elimination; else the pivot.
#[inline]
pub(crate) fn checked_inverse(pivot: f64, original: f64) -> Result<f64, f64> {
    let inverse = 1.0 / pivot;
    // Written so that NaN fails too, and a pivot whose inverse overflows.
    if pivot > PIVOT_FLOOR * original && pivot.is_finite() && inverse.is_finite() {
        Ok(inverse)
    } else {
        Err(pivot)
    }
}

/// Inverse of a symmetric positive definite matrix by the sweep operator.
///
/// Only the lower triangle is read; the result is exactly symmetric.
///
/// # Errors
/// The offending pivot, when the matrix is not positive definite within double precision.
///
/// ```
/// use nalgebra::Matrix2;
/// let inverse = rangelab::math::linalg::spd_inverse(&Matrix2::new(2.0, 0.0, 0.0, 4.0)).unwrap();
/// assert_eq!(inverse, Matrix2::new(0.5, 0.0, 0.0, 0.25));
/// assert!(rangelab::math::linalg::spd_inverse(&Matrix2::new(1.0, 1.0, 1.0, 1.0)).is_err());
/// ```
#[inline]
pub fn spd_inverse<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Result<SMatrix<f64, D, D>, f64> {
    spd_inverse_within(matrix, matrix)
}

/// Inverse of what elimination left of a diagonal block: pivots are held against the diagonal of the block as it was,
/// `original`, so that a rank lost to other blocks is seen.
#[inline]
pub(crate) fn spd_inverse_within<const D: usize>(
    block: &SMatrix<f64, D, D>,
    original: &SMatrix<f64, D, D>,
) -> Result<SMatrix<f64, D, D>, f64> {
    let mut a = *block;
    for k in 0..D {
        let inverse = checked_inverse(a[(k, k)], original[(k, k)])?;
        sweep(&mut a, k, inverse);
    }
    for j in 0..D {
        for i in 0..j {
            a[(i, j)] = -a[(j, i)];
            a[(j, i)] = -a[(j, i)];
        }
        a[(j, j)] = -a[(j, j)];
    }
    Ok(a)
}

/// One sweep of the lower triangle on pivot `k`.
#[inline]
fn sweep<const D: usize>(a: &mut SMatrix<f64, D, D>, k: usize, inverse: f64) {
    let mut row = [0.0; D];
    for (i, entry) in row.iter_mut().enumerate() {
        *entry = if i < k { a[(k, i)] } else { a[(i, k)] };
    }
    for j in 0..D {
        if j == k {
            continue;
        }
        let scaled = row[j] * inverse;
        for i in j..D {
            if i != k {
                a[(i, j)] -= row[i] * scaled;
            }
        }
    }
    for i in 0..D {
        let entry = if i == k { -inverse } else { row[i] * inverse };
        if i < k {
            a[(k, i)] = entry;
        } else {
            a[(i, k)] = entry;
        }
    }
}

/// Adds the weighted outer product `weight x y^T` to `a`.
#[inline]
pub fn add_outer<const D: usize>(
    a: &mut SMatrix<f64, D, D>,
    weight: f64,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
) {
    for j in 0..D {
        let scaled = weight * y[j];
        for i in 0..D {
            a[(i, j)] += x[i] * scaled;
        }
    }
}

/// Inverse of a 3 x 3 matrix that is known not to be singular, by cofactors.
pub fn general_inverse(a: &SMatrix<f64, 3, 3>) -> SMatrix<f64, 3, 3> {
    let minor = |i: usize, j: usize| {
        let (p, q) = ((i + 1) % 3, (i + 2) % 3);
        let (r, s) = ((j + 1) % 3, (j + 2) % 3);
        a[(p, r)] * a[(q, s)] - a[(p, s)] * a[(q, r)]
    };
    let determinant = a[(0, 0)] * minor(0, 0) + a[(0, 1)] * minor(0, 1) + a[(0, 2)] * minor(0, 2);
    SMatrix::<f64, 3, 3>::from_fn(|i, j| minor(j, i) / determinant)
}
