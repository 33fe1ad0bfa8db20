//! The two equations that are Lyapunov's but for a rotation between them, \[A\] eq. 13.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::RANK;
use crate::error::{Error, Result};

/// `F^T Y + Y^T F = B` for known `F` (D x N, centred) and symmetric `B` (N x N, `B 1 = 0`), in the singular vectors of
/// `F = U Lambda V^T`.
#[derive(Clone, Debug)]
pub struct Lyapunov {
    /// `F`.
    pub factor: DMatrix<f64>,
    /// `U`, D x D.
    pub left: DMatrix<f64>,
    /// `Lambda`, decreasing.
    pub values: Vec<f64>,
    /// The first D right singular vectors `V`, N x D.
    pub right: DMatrix<f64>,
    /// `V^T B V`, D x D.
    pub inner: DMatrix<f64>,
    /// `Z_2 V_rest^T = Lambda^-1 V^T B (I - V V^T)`, D x N: the part of `U^T Y` that is known (eq. 14).
    pub outer: DMatrix<f64>,
}

impl Lyapunov {
    fn new(factor: &DMatrix<f64>, b: &DMatrix<f64>) -> Self {
        let svd = factor.clone().svd(true, true);
        let values: Vec<f64> = svd.singular_values.iter().copied().collect();
        let left = svd.u.expect("it was asked for");
        let right = svd.v_t.expect("it was asked for").transpose();
        let rows = right.transpose() * b;
        let inner = &rows * &right;
        let beyond = &rows - &inner * right.transpose();
        let outer = DMatrix::from_fn(factor.nrows(), factor.ncols(), |i, node| beyond[(i, node)] / values[i]);
        Self { factor: factor.clone(), left, values, right, inner, outer }
    }

    /// The solution with the least off-diagonal `Z_1`; all others differ by `Omega F`, Omega skew.
    pub fn particular(&self) -> DMatrix<f64> {
        let dimension = self.values.len();
        let z = DMatrix::from_fn(dimension, dimension, |i, j| {
            let (a, b) = (self.values[i], self.values[j]);
            self.inner[(i, j)] * a / (a * a + b * b)
        });
        &self.left * (z * self.right.transpose() + &self.outer)
    }

    /// The known part of a solution: the diagonal of `Z_1` and all of `Z_2`.
    pub fn known(&self) -> DMatrix<f64> {
        let diagonal = DMatrix::from_fn(self.values.len(), self.values.len(), |i, j| {
            if i == j { self.inner[(i, i)] / (2.0 * self.values[i]) } else { 0.0 }
        });
        &self.left * (diagonal * self.right.transpose() + &self.outer)
    }
}

/// Both equations: `Y_0^T Y_1 + Y_1^T Y_0 = B_1`, and the same with `Yh_2` and `2 B_3` for `H^T Y_1`.
#[derive(Clone, Debug)]
pub struct Sides {
    /// That of the positions.
    pub first: Lyapunov,
    /// That of the accelerations.
    pub second: Lyapunov,
}

impl Sides {
    /// From the factors and the right sides.
    pub fn new(first: (&DMatrix<f64>, &DMatrix<f64>), second: (&DMatrix<f64>, &DMatrix<f64>)) -> Self {
        Self { first: Lyapunov::new(first.0, first.1), second: Lyapunov::new(second.0, second.1) }
    }

    /// The same with the accelerations mirrored in their first coordinate.
    pub fn mirrored(&self) -> Self {
        let mut mirrored = self.clone();
        mirrored.second.factor.row_mut(0).neg_mut();
        mirrored.second.left.row_mut(0).neg_mut();
        mirrored
    }

    /// Refuses accelerations that do not span the space.
    ///
    /// # Errors
    /// [`Error::Degenerate`].
    pub fn check_span(&self, what: &'static str) -> Result<()> {
        let values = &self.second.values;
        let value = values[values.len() - 1] / self.first.values[0];
        if value > RANK {
            Ok(())
        } else {
            Err(Error::Degenerate { what, value, reason: super::ACCELERATIONS })
        }
    }
}

/// The `index`-th generator of skew D x D matrices, and how many there are.
pub fn skew(dimension: usize, index: usize) -> DMatrix<f64> {
    let (i, j) = [(0, 1), (0, 2), (1, 2)][index];
    let mut omega = DMatrix::zeros(dimension, dimension);
    omega[(i, j)] = -1.0;
    omega[(j, i)] = 1.0;
    omega
}

/// How many entries a skew D x D matrix has: `D (D - 1)/2`.
pub fn skew_entries(dimension: usize) -> usize {
    dimension * (dimension - 1) / 2
}
