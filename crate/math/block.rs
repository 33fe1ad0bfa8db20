//! Symmetric matrices on `theta = vec([Q | t])`, addressed by blocks, inverted entry by entry, on the stack.

use nalgebra::{SMatrix, SVector};

use super::linalg::checked_inverse;
use super::pose::Theta;

/// Columns of `[Q | t]` for D = 3.
pub const MAX_BLOCKS: usize = 4;

/// Entries of `theta` for D = 3; for D = 2 the first 6 are used.
const MAX_ENTRIES: usize = 12;

/// A symmetric matrix on `theta`: block `(i, j)` belongs to columns `i` and `j` of `[Q | t]`, block `D` to `t`.
///
/// Inverses go entry by entry: by blocks they would lose digits with the square of the condition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockMatrix<const D: usize> {
    rows: [[f64; MAX_ENTRIES]; MAX_ENTRIES],
}

impl<const D: usize> BlockMatrix<D> {
    const ENTRIES: usize = D * (D + 1);

    /// All zeros.
    #[inline]
    pub fn zeros() -> Self {
        Self { rows: [[0.0; MAX_ENTRIES]; MAX_ENTRIES] }
    }

    /// `orientation I` on the columns of `Q` and `position I` on `t`, zero elsewhere.
    pub fn isotropic(orientation: f64, position: f64) -> Self {
        let mut result = Self::zeros();
        result.add_isotropic(orientation, position);
        result
    }

    /// Adds `orientation I` to each diagonal block of `Q` and `position I` to that of `t`.
    #[inline]
    pub fn add_isotropic(&mut self, orientation: f64, position: f64) {
        for i in 0..Self::ENTRIES {
            self.rows[i][i] += if i < D * D { orientation } else { position };
        }
    }

    /// Block `(i, j)`.
    #[inline]
    pub fn block(&self, i: usize, j: usize) -> SMatrix<f64, D, D> {
        SMatrix::from_fn(|row, column| self.rows[i * D + row][j * D + column])
    }

    /// Sets block `(i, j)`, and `(j, i)` to its transpose. A diagonal block must be symmetric.
    #[inline]
    pub fn set_block(&mut self, i: usize, j: usize, block: &SMatrix<f64, D, D>) {
        for row in 0..D {
            for column in 0..D {
                self.rows[i * D + row][j * D + column] = block[(row, column)];
                self.rows[j * D + column][i * D + row] = block[(row, column)];
            }
        }
    }

    /// Entry `(i, j)` on `vec([Q | t])`.
    #[inline]
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        self.rows[i][j]
    }

    /// Adds `weights (x) gram` for a symmetric (D+1) x (D+1) matrix of weights, given entry by entry.
    #[inline]
    pub fn add_kronecker(&mut self, weight: impl Fn(usize, usize) -> f64, gram: &SMatrix<f64, D, D>) {
        for i in 0..=D {
            for j in 0..=D {
                let scale = weight(i, j);
                for row in 0..D {
                    for column in 0..D {
                        self.rows[i * D + row][j * D + column] += gram[(row, column)] * scale;
                    }
                }
            }
        }
    }

    /// `self + other`.
    #[inline]
    pub fn add(&mut self, other: &Self) {
        for (mine, theirs) in self.rows.iter_mut().zip(&other.rows) {
            for (x, y) in mine.iter_mut().zip(theirs) {
                *x += y;
            }
        }
    }

    /// Inverse of a positive definite matrix by the sweep operator; exactly symmetric.
    ///
    /// # Errors
    /// The offending pivot, when it is not positive definite within double precision.
    pub fn inverse(&self) -> Result<Self, f64> {
        let mut result = *self;
        result.invert().map(|()| result)
    }

    /// [`BlockMatrix::inverse`] in place; after an error the matrix is meaningless.
    ///
    /// # Errors
    /// The offending pivot.
    pub fn invert(&mut self) -> Result<(), f64> {
        self.sweep(Self::ENTRIES)?;
        for i in 0..Self::ENTRIES {
            for j in 0..i {
                self.rows[i][j] = -self.rows[i][j];
                self.rows[j][i] = self.rows[i][j];
            }
            self.rows[i][i] = -self.rows[i][i];
        }
        Ok(())
    }

    /// `x^T A^-1 x` for `x = vec(theta)` and a positive definite `A`, by elimination: no inverse is formed.
    ///
    /// # Errors
    /// The offending pivot.
    pub fn inverse_quadratic_form(&self, theta: &Theta<D>) -> Result<f64, f64> {
        let (mut rows, mut x, mut sum) = (self.rows, [0.0; MAX_ENTRIES], 0.0);
        x.iter_mut().zip(theta.orientation.iter().chain(theta.position.iter())).for_each(|(x, y)| *x = *y);
        for k in 0..Self::ENTRIES {
            let inverse = checked_inverse(rows[k][k], self.rows[k][k])?;
            sum += x[k] * x[k] * inverse;
            let pivot_row = rows[k];
            for i in k + 1..Self::ENTRIES {
                let factor = pivot_row[i] * inverse;
                x[i] -= factor * x[k];
                for (entry, pivot) in rows[i].iter_mut().zip(&pivot_row) {
                    *entry -= factor * pivot;
                }
            }
        }
        Ok(sum)
    }

    /// Sweeps the lower triangle on the first `pivots` entries; what is above the diagonal is then meaningless.
    fn sweep(&mut self, pivots: usize) -> Result<(), f64> {
        let original: [f64; MAX_ENTRIES] = core::array::from_fn(|k| self.rows[k][k]);
        for k in 0..pivots {
            let inverse = checked_inverse(self.rows[k][k], original[k])?;
            self.sweep_pivot(k, inverse);
        }
        Ok(())
    }

    #[inline]
    fn sweep_pivot(&mut self, k: usize, inverse: f64) {
        let mut column = self.rows[k];
        for i in k + 1..Self::ENTRIES {
            column[i] = self.rows[i][k];
        }
        // Pieces of a register's width reach beyond the diagonal, where nothing is kept. Row k is set below.
        subtract_rows::<4>(&mut self.rows[..4], 0, inverse, &column);
        subtract_rows::<8>(&mut self.rows[4..8], 4, inverse, &column);
        if D == 3 {
            subtract_rows::<MAX_ENTRIES>(&mut self.rows[8..], 8, inverse, &column);
        }
        for i in 0..k {
            self.rows[k][i] = column[i] * inverse;
        }
        for i in k + 1..Self::ENTRIES {
            self.rows[i][k] = column[i] * inverse;
        }
        self.rows[k][k] = -inverse;
    }

    /// The product with `vec(theta)`.
    #[inline]
    pub fn times(&self, theta: &Theta<D>) -> Theta<D> {
        let mut sums = [0.0; MAX_ENTRIES];
        let entries = theta.orientation.iter().chain(theta.position.iter());
        for (row, &x) in self.rows.iter().zip(entries) {
            for (sum, &a) in sums.iter_mut().zip(row) {
                *sum += a * x;
            }
        }
        Theta {
            orientation: SMatrix::from_fn(|i, j| sums[j * D + i]),
            position: SVector::from_fn(|i, _| sums[D * D + i]),
        }
    }

    /// The product of the blocks of `Q` alone with `vec(q)`.
    #[inline]
    pub fn times_orientation(&self, q: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
        let mut sums = SMatrix::<f64, D, D>::zeros();
        for (row, &x) in self.rows.iter().zip(q.iter()) {
            for (sum, &a) in sums.iter_mut().zip(row) {
                *sum += a * x;
            }
        }
        sums
    }

    /// Trace over the blocks of `Q`.
    pub fn orientation_trace(&self) -> f64 {
        (0..D * D).map(|i| self.rows[i][i]).sum()
    }

    /// The block of `t`.
    pub fn position_block(&self) -> SMatrix<f64, D, D> {
        self.block(D, D)
    }

    /// Whether the blocks of `Q` are positive definite within double precision.
    pub fn is_positive_on_orientation(&self) -> bool {
        self.clone().sweep(D * D).is_ok()
    }

    /// Given a covariance: the metric of `Q` with `t` left free, and what moves `t` when `Q` is moved.
    ///
    /// # Errors
    /// The offending pivot.
    pub fn orientation_metric(&self) -> Result<OrientationMetric<D>, f64> {
        let mut swept = *self;
        swept.sweep(D * D)?;
        let mut metric = Self::zeros();
        for i in 0..D * D {
            for j in 0..=i {
                metric.rows[i][j] = -swept.rows[i][j];
                metric.rows[j][i] = metric.rows[i][j];
            }
        }
        let position_gain = core::array::from_fn(|j| swept.block(D, j));
        Ok(OrientationMetric { metric, position_gain })
    }
}

/// Subtracts `(inverse x_i) x^T` from the first `WIDTH` entries of rows `i = first..`.
#[inline]
fn subtract_rows<const WIDTH: usize>(
    rows: &mut [[f64; MAX_ENTRIES]],
    first: usize,
    inverse: f64,
    x: &[f64; MAX_ENTRIES],
) {
    let mut piece = [0.0; WIDTH];
    piece.copy_from_slice(&x[..WIDTH]);
    for (row, &entry) in rows.iter_mut().zip(&x[first..]) {
        let scale = inverse * entry;
        for (y, x) in row[..WIDTH].iter_mut().zip(&piece) {
            *y -= scale * x;
        }
    }
}

/// What a covariance of `[Q | t]` says about moving `Q`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientationMetric<const D: usize> {
    /// `P_q^-1` on `vec(Q)`; zero for `t`.
    pub metric: BlockMatrix<D>,
    /// The D blocks of `P_tq P_q^-1`: `t` moves by their products with the columns of the change of `Q`.
    pub position_gain: [SMatrix<f64, D, D>; D],
}
