//! The Cholesky factor of a symmetric positive definite matrix of fixed size, on the stack.

use nalgebra::{SMatrix, SVector};

use super::float::sqrt;
use super::linalg::checked_inverse;

/// `A = L L^T` with `L` lower triangular.
///
/// ```
/// use nalgebra::{Matrix2, Vector2};
/// use rangelab::math::cholesky::Cholesky;
/// let factor = Cholesky::new(&Matrix2::new(4.0, 2.0, 2.0, 5.0)).unwrap();
/// assert_eq!(*factor.lower(), Matrix2::new(2.0, 0.0, 1.0, 2.0));
/// assert_eq!(factor.inverse_quadratic_form(&Vector2::new(2.0, 1.0)), 1.0);
/// assert!(Cholesky::new(&Matrix2::new(1.0, 2.0, 2.0, 1.0)).is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cholesky<const N: usize> {
    lower: SMatrix<f64, N, N>,
    inverse_diagonal: [f64; N],
}

impl<const N: usize> Cholesky<N> {
    /// Factors a matrix, of which the lower triangle is read.
    ///
    /// # Errors
    /// The offending pivot, when the matrix is not positive definite within double precision.
    pub fn new(matrix: &SMatrix<f64, N, N>) -> Result<Self, f64> {
        let (mut lower, mut inverse_diagonal) = (*matrix, [0.0; N]);
        for j in 0..N {
            let pivot = lower[(j, j)];
            checked_inverse(pivot, matrix[(j, j)])?;
            let root = sqrt(pivot);
            let inverse = 1.0 / root;
            lower[(j, j)] = root;
            inverse_diagonal[j] = inverse;
            for i in 0..N {
                if i > j {
                    lower[(i, j)] *= inverse;
                } else if i < j {
                    lower[(i, j)] = 0.0;
                }
            }
            for k in j + 1..N {
                let factor = lower[(k, j)];
                for i in k..N {
                    lower[(i, k)] -= lower[(i, j)] * factor;
                }
            }
        }
        Ok(Self { lower, inverse_diagonal })
    }

    /// `L`.
    pub fn lower(&self) -> &SMatrix<f64, N, N> {
        &self.lower
    }

    /// `L^-1 B`, column by column.
    #[must_use]
    pub fn whiten<const M: usize>(&self, b: &SMatrix<f64, N, M>) -> SMatrix<f64, N, M> {
        let mut x = *b;
        for column in 0..M {
            for j in 0..N {
                let value = x[(j, column)] * self.inverse_diagonal[j];
                x[(j, column)] = value;
                for i in j + 1..N {
                    x[(i, column)] -= self.lower[(i, j)] * value;
                }
            }
        }
        x
    }

    /// `A^-1 b`.
    #[must_use]
    pub fn solve(&self, b: &SVector<f64, N>) -> SVector<f64, N> {
        let mut x = self.whiten(b);
        for j in (0..N).rev() {
            let mut value = x[j];
            for i in j + 1..N {
                value -= self.lower[(i, j)] * x[i];
            }
            x[j] = value * self.inverse_diagonal[j];
        }
        x
    }

    /// `x^T A^-1 x`.
    #[must_use]
    pub fn inverse_quadratic_form(&self, x: &SVector<f64, N>) -> f64 {
        self.whiten(x).norm_squared()
    }
}
