//! Symmetric matrices on `theta = vec([Q | t])` as (D+1) x (D+1) blocks of D x D, on the stack.

use nalgebra::SMatrix;

use super::linalg::spd_inverse_within;
use super::pose::Theta;

/// Block rows for D = 3; for D = 2 the last one is unused.
pub const MAX_BLOCKS: usize = 4;

/// A symmetric matrix on `theta`: block `(i, j)` belongs to columns `i` and `j` of `[Q | t]`, block `D` to `t`.
///
/// Only blocks with `j <= i` are stored as truth; [`BlockMatrix::block`] transposes for the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockMatrix<const D: usize> {
    lower: [[SMatrix<f64, D, D>; MAX_BLOCKS]; MAX_BLOCKS],
}

impl<const D: usize> BlockMatrix<D> {
    /// All zeros.
    #[inline]
    pub fn zeros() -> Self {
        Self { lower: [[SMatrix::zeros(); MAX_BLOCKS]; MAX_BLOCKS] }
    }

    /// The given block `scale_j I` on the diagonal, zero elsewhere: `orientation` for the columns of `Q`, `position` for `t`.
    pub fn isotropic(orientation: f64, position: f64) -> Self {
        let mut result = Self::zeros();
        result.add_isotropic(orientation, position);
        result
    }

    /// Adds `orientation I` to each diagonal block of `Q` and `position I` to that of `t`.
    #[inline]
    pub fn add_isotropic(&mut self, orientation: f64, position: f64) {
        for j in 0..=D {
            let value = if j < D { orientation } else { position };
            for i in 0..D {
                self.lower[j][j][(i, i)] += value;
            }
        }
    }

    /// Block `(i, j)` of the symmetric matrix.
    #[inline]
    pub fn block(&self, i: usize, j: usize) -> SMatrix<f64, D, D> {
        if j <= i { self.lower[i][j] } else { self.lower[j][i].transpose() }
    }

    /// Stored block `(i, j)`, `j <= i`, to change it.
    #[inline]
    pub fn block_mut(&mut self, i: usize, j: usize) -> &mut SMatrix<f64, D, D> {
        debug_assert!(j <= i, "only the lower blocks are stored");
        &mut self.lower[i][j]
    }

    /// `self + other`.
    #[inline]
    pub fn add(&mut self, other: &Self) {
        for i in 0..=D {
            for j in 0..=i {
                self.lower[i][j] += other.lower[i][j];
            }
        }
    }

    /// Inverse of a positive definite matrix by block sweeps.
    ///
    /// # Errors
    /// The offending pivot, when it is not positive definite within double precision.
    pub fn inverse(&self) -> Result<Self, f64> {
        let mut a = *self;
        for k in 0..=D {
            a.sweep(k, &self.lower[k][k])?;
        }
        for i in 0..=D {
            for j in 0..=i {
                a.lower[i][j] = -a.lower[i][j];
            }
        }
        Ok(a)
    }

    /// One sweep on diagonal block `k`, which was `original` before any sweep.
    #[inline]
    fn sweep(&mut self, k: usize, original: &SMatrix<f64, D, D>) -> Result<(), f64> {
        let inverse = spd_inverse_within(&self.lower[k][k], original)?;
        let mut column = [SMatrix::<f64, D, D>::zeros(); MAX_BLOCKS];
        for (i, entry) in column.iter_mut().enumerate().take(D + 1) {
            if i != k {
                *entry = self.block(i, k);
            }
        }
        for i in 0..=D {
            if i == k {
                continue;
            }
            let scaled = column[i] * inverse;
            for j in 0..=i {
                if j != k {
                    self.lower[i][j] -= scaled * column[j].transpose();
                }
            }
            if i > k {
                self.lower[i][k] = scaled;
            } else {
                self.lower[k][i] = scaled.transpose();
            }
        }
        self.lower[k][k] = -inverse;
        Ok(())
    }

    /// The product with `vec(theta)`.
    #[inline]
    pub fn times(&self, theta: &Theta<D>) -> Theta<D> {
        let mut result = Theta::zeros();
        for i in 0..=D {
            for j in 0..=D {
                let x = theta.column(j);
                let y = if j <= i { self.lower[i][j] * x } else { self.lower[j][i].tr_mul(&x) };
                result.add_to_column(i, &y);
            }
        }
        result
    }

    /// `x^T A x` for `x = vec(theta)`.
    #[inline]
    pub fn quadratic_form(&self, theta: &Theta<D>) -> f64 {
        theta.dot(&self.times(theta))
    }

    /// Trace over the blocks of `Q`.
    pub fn orientation_trace(&self) -> f64 {
        (0..D).map(|j| self.lower[j][j].trace()).sum()
    }

    /// The block of `t`.
    pub fn position_block(&self) -> SMatrix<f64, D, D> {
        self.lower[D][D]
    }

    /// The orientation part of a positive definite matrix with `t` marginalized out of its inverse: given a covariance,
    /// the metric `P_q^-1` on `vec(Q)` (its blocks `i, j < D`).
    ///
    /// # Errors
    /// The offending pivot.
    pub fn orientation_metric(&self) -> Result<Self, f64> {
        let mut a = *self;
        for k in 0..D {
            a.sweep(k, &self.lower[k][k])?;
        }
        let mut metric = Self::zeros();
        for i in 0..D {
            for j in 0..=i {
                metric.lower[i][j] = -a.lower[i][j];
            }
        }
        // After the sweeps the last block row holds P_tq P_q^-1: what moves t when Q is moved.
        for j in 0..D {
            metric.lower[D][j] = a.lower[D][j];
        }
        Ok(metric)
    }
}
