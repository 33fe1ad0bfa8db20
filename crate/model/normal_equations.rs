//! What a set of ranges says about `theta = vec([Q | t])`: the one small object that every estimator and bound reads.

use nalgebra::SMatrix;

use super::covariance::expand;
use crate::math::block::{BlockMatrix, MAX_BLOCKS};
use crate::math::pose::Theta;
use crate::math::rotation::Rotation;
use crate::math::tangent::TangentMatrix;

/// The information matrix `Lambda = sum_n (c_n c_n^T) (x) R_n` about `theta`, with `c_n` extended by 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Information<const D: usize> {
    /// All sensors share `R` and the topology is centred: `Lambda = (V (x) I) diag(moment_j R) (V (x) I)^T`.
    Decoupled {
        /// Principal axes `V` of the sensors.
        axes: SMatrix<f64, D, D>,
        /// `R = 4 sum_m w_m (a_m - a0)(a_m - a0)^T`, 1/m^2.
        gram: SMatrix<f64, D, D>,
        /// Second moments of the sensors along `axes`, then their number.
        moments: [f64; MAX_BLOCKS],
    },
    /// Any positive semidefinite matrix.
    Full(BlockMatrix<D>),
}

impl<const D: usize> Information<D> {
    /// The full matrix.
    pub fn to_blocks(&self) -> BlockMatrix<D> {
        match self {
            Self::Decoupled { axes, gram, moments } => {
                let mut blocks = [SMatrix::zeros(); MAX_BLOCKS];
                for j in 0..=D {
                    blocks[j] = gram * moments[j];
                }
                expand(axes, &blocks)
            }
            Self::Full(matrix) => *matrix,
        }
    }

    /// `T^T Lambda T`, the information about the tangent coordinates at `rotation`.
    pub fn on_tangent_space(&self, rotation: &Rotation<D>) -> TangentMatrix<D> {
        match self {
            Self::Decoupled { .. } => TangentMatrix::restrict(&self.to_blocks(), rotation),
            Self::Full(matrix) => TangentMatrix::restrict(matrix, rotation),
        }
    }

    /// The product `Lambda vec(theta)`.
    pub fn times(&self, theta: &Theta<D>) -> Theta<D> {
        match self {
            Self::Decoupled { axes, gram, moments } => {
                let mut in_axes = theta.orientation * axes;
                for j in 0..D {
                    let scaled = in_axes.column(j) * moments[j];
                    in_axes.set_column(j, &scaled);
                }
                Theta {
                    orientation: gram * in_axes * axes.transpose(),
                    position: gram * theta.position * moments[D],
                }
            }
            Self::Full(matrix) => matrix.times(theta),
        }
    }
}

/// Normal equations about a reference `theta_0`: `Lambda (theta - theta_0) = innovation`.
///
/// Forming them about the prior keeps the numbers small (squared ranges of 1e6 m^2 would otherwise cancel) and makes
/// the right-hand side the innovation in information form, `H^T Sigma^-1 (d - h(theta_0))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalEquations<const D: usize> {
    /// `Lambda`.
    pub information: Information<D>,
    /// The right-hand side, in the shape of `[Q | t]`.
    pub innovation: Theta<D>,
    /// Weighted sum of squared residuals at the reference, `||d - h(theta_0)||^2` in the metric of the noise.
    pub energy: f64,
    /// Number of ranges used.
    pub ranges: usize,
    /// Number of independent residuals in `energy` (the projected form spends one for each sensor).
    pub residuals: usize,
}

impl<const D: usize> NormalEquations<D> {
    /// No ranges: nothing is known.
    pub fn empty() -> Self {
        Self {
            information: Information::Full(BlockMatrix::zeros()),
            innovation: Theta::zeros(),
            energy: 0.0,
            ranges: 0,
            residuals: 0,
        }
    }
}
