//! The update by a linear measurement, for states of any size.

use nalgebra::{SMatrix, SVector};

use super::filter::not_positive;
use crate::error::Result;
use crate::math::cholesky::Cholesky;

/// What an update by nine numbers does to a state of `N`.
pub(super) struct Update<const N: usize> {
    /// `K r`, to be added to the state.
    pub correction: SVector<f64, N>,
    /// `K S K^T`, to be taken from the covariance.
    pub learned: SMatrix<f64, N, N>,
    /// `r^T S^-1 r`.
    pub nis: f64,
}

impl<const N: usize> Update<N> {
    /// From the covariance `C` of state and measurement, that of the measurement, `S`, and the innovation `r`; the gain is
    /// `K = C S^-1`.
    pub fn new(
        cross: &SMatrix<f64, N, 9>,
        spread: &SMatrix<f64, 9, 9>,
        innovation: &SVector<f64, 9>,
    ) -> Result<Self> {
        let factor = Cholesky::new(spread).map_err(not_positive)?;
        let white_cross = factor.whiten(&cross.transpose());
        let white_innovation = factor.whiten(innovation);
        Ok(Self {
            correction: white_cross.transpose() * white_innovation,
            learned: gram(&white_cross),
            nis: white_innovation.norm_squared(),
        })
    }
}

/// `A^T A`, exactly symmetric.
fn gram<const N: usize>(a: &SMatrix<f64, 9, N>) -> SMatrix<f64, N, N> {
    let mut result = SMatrix::zeros();
    for j in 0..N {
        for i in 0..=j {
            let mut sum = 0.0;
            for k in 0..9 {
                sum += a[(k, i)] * a[(k, j)];
            }
            result[(i, j)] = sum;
            result[(j, i)] = sum;
        }
    }
    result
}
