//! Covariance of the unconstrained state `theta = vec([Q | t])`, in the form that the problem allows.

use nalgebra::SMatrix;

use super::motion::ProcessNoise;
use super::normal_equations::Information;
use super::topology::Topology;
use crate::error::{Error, Result};
use crate::math::block::{BlockMatrix, MAX_BLOCKS, OrientationMetric};
use crate::math::linalg::spd_inverse;
use crate::math::pose::Theta;

/// Covariance of `theta`.
///
/// With a centred topology and an isotropic prior the columns of `[Q V | t]` (`V` the principal axes of the sensors)
/// stay independent of each other: D+1 covariances of size D x D say everything. One epoch that breaks the symmetry (a
/// missing range, weights per pair) turns the covariance into the full form for good.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Covariance<const D: usize> {
    /// `(V (x) I) diag(blocks) (V (x) I)^T` on `vec(Q)`, the last block on `t`.
    Decoupled {
        /// Principal axes `V` of the sensors.
        axes: SMatrix<f64, D, D>,
        /// Covariances of the columns of `Q V`, then of `t`.
        blocks: [SMatrix<f64, D, D>; MAX_BLOCKS],
    },
    /// Any symmetric positive definite matrix.
    Full(BlockMatrix<D>),
}

impl<const D: usize> Covariance<D> {
    /// `variance I` on all of `theta`, decoupled where the topology allows.
    pub fn isotropic(variance: f64, topology: &Topology<D>) -> Self {
        if topology.is_centred() {
            Self::Decoupled { axes: *topology.axes(), blocks: [SMatrix::identity() * variance; MAX_BLOCKS] }
        } else {
            Self::Full(BlockMatrix::isotropic(variance, variance))
        }
    }

    /// Takes over another's value; copies no more than the form needs, which counts in a step of half a microsecond.
    #[inline]
    pub(crate) fn set(&mut self, other: &Self) {
        match (&mut *self, other) {
            (
                Self::Decoupled { axes, blocks },
                Self::Decoupled { axes: other_axes, blocks: other_blocks },
            ) => (*axes, *blocks) = (*other_axes, *other_blocks),
            (Self::Full(matrix), Self::Full(other)) => *matrix = *other,
            _ => *self = *other,
        }
    }

    /// Predicts: `F P F^T + M` with `F = diag(I (x) F_Q, I)`, `M = diag(sigma_q^2 I, sigma_t^2 I)` (\[T\] eq. 17b).
    pub fn predict(&mut self, rotation: &SMatrix<f64, D, D>, noise: &ProcessNoise) {
        let (orientation, position) = (noise.sigma_q * noise.sigma_q, noise.sigma_t * noise.sigma_t);
        match self {
            Self::Decoupled { blocks, .. } => {
                let added = SMatrix::identity() * orientation;
                for block in blocks.iter_mut().take(D) {
                    *block = rotation * *block * rotation.transpose() + added;
                }
                blocks[D] += SMatrix::identity() * position;
            }
            Self::Full(matrix) => {
                for j in 0..D {
                    for i in j..=D {
                        let turned = matrix.block(i, j) * rotation.transpose();
                        matrix.set_block(i, j, &if i < D { rotation * turned } else { turned });
                    }
                }
                matrix.add_isotropic(orientation, position);
            }
        }
    }

    /// Updates in information form: `P <- (P^-1 + Lambda)^-1`. After an error it is meaningless.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] where double precision does not carry the sum.
    pub fn update(&mut self, information: &Information<D>) -> Result<()> {
        let updated = match (&mut *self, information) {
            (Self::Decoupled { blocks, .. }, Information::Decoupled { gram, moments, .. }) => {
                update_blocks(blocks, gram, moments)
            }
            (Self::Full(matrix), _) => update_full(matrix, information),
            (Self::Decoupled { axes, blocks }, Information::Full(_)) => {
                let mut matrix = expand(axes, blocks);
                let updated = update_full(&mut matrix, information);
                *self = Self::Full(matrix);
                updated
            }
        };
        updated.map_err(|pivot| Error::NotPositiveDefinite { what: "the covariance of [Q | t]", pivot })
    }

    /// The product `P vec(theta)`.
    pub fn times(&self, theta: &Theta<D>) -> Theta<D> {
        match self {
            Self::Decoupled { axes, blocks } => {
                let in_axes = theta.orientation * axes;
                let mut turned = SMatrix::<f64, D, D>::zeros();
                for j in 0..D {
                    turned.set_column(j, &(blocks[j] * in_axes.column(j)));
                }
                Theta { orientation: turned * axes.transpose(), position: blocks[D] * theta.position }
            }
            Self::Full(matrix) => matrix.times(theta),
        }
    }

    /// `tr P_q`.
    pub fn orientation_trace(&self) -> f64 {
        match self {
            Self::Decoupled { blocks, .. } => blocks.iter().take(D).map(SMatrix::trace).sum(),
            Self::Full(matrix) => matrix.orientation_trace(),
        }
    }

    /// `P_t`, m^2.
    pub fn position_block(&self) -> SMatrix<f64, D, D> {
        match self {
            Self::Decoupled { blocks, .. } => blocks[D],
            Self::Full(matrix) => matrix.position_block(),
        }
    }

    /// The metric of `Q` with `t` left free, `P_q^-1`, and what moves `t` when `Q` is moved.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`].
    pub fn orientation_metric(&self) -> Result<OrientationMetric<D>> {
        let metric = match self {
            Self::Decoupled { axes, blocks } => invert_orientation_blocks(blocks).map(|inverse| {
                OrientationMetric { metric: expand(axes, &inverse), position_gain: [SMatrix::zeros(); D] }
            }),
            Self::Full(matrix) => matrix.orientation_metric(),
        };
        metric.map_err(|pivot| Error::NotPositiveDefinite { what: "the covariance of Q", pivot })
    }

    /// The full inverse.
    ///
    /// # Errors
    /// The offending pivot.
    pub fn precision(&self) -> core::result::Result<BlockMatrix<D>, f64> {
        match self {
            Self::Decoupled { axes, blocks } => {
                let mut inverse = invert_orientation_blocks(blocks)?;
                inverse[D] = spd_inverse(&blocks[D])?;
                Ok(expand(axes, &inverse))
            }
            Self::Full(matrix) => matrix.inverse(),
        }
    }

    /// `x^T P^-1 x` for `x = vec(theta)`.
    ///
    /// # Errors
    /// The offending pivot.
    pub fn inverse_quadratic_form(&self, theta: &Theta<D>) -> core::result::Result<f64, f64> {
        match self {
            Self::Decoupled { axes, blocks } => {
                let in_axes = theta.orientation * axes;
                let mut sum = 0.0;
                for j in 0..=D {
                    let x = if j < D { in_axes.column(j).into_owned() } else { theta.position };
                    sum += x.dot(&(spd_inverse(&blocks[j])? * x));
                }
                Ok(sum)
            }
            Self::Full(matrix) => matrix.inverse_quadratic_form(theta),
        }
    }

    /// The full matrix.
    pub fn to_blocks(&self) -> BlockMatrix<D> {
        match self {
            Self::Decoupled { axes, blocks } => expand(axes, blocks),
            Self::Full(matrix) => *matrix,
        }
    }
}

fn update_full<const D: usize>(
    matrix: &mut BlockMatrix<D>,
    information: &Information<D>,
) -> core::result::Result<(), f64> {
    matrix.invert()?;
    match information {
        Information::Full(added) => matrix.add(added),
        Information::Decoupled { .. } => matrix.add(&information.to_blocks()),
    }
    matrix.invert()
}

fn update_blocks<const D: usize>(
    blocks: &mut [SMatrix<f64, D, D>; MAX_BLOCKS],
    gram: &SMatrix<f64, D, D>,
    moments: &[f64; MAX_BLOCKS],
) -> core::result::Result<(), f64> {
    for j in 0..=D {
        blocks[j] = spd_inverse(&(spd_inverse(&blocks[j])? + gram * moments[j]))?;
    }
    Ok(())
}

/// Inverses of the blocks of `Q`, zero for `t`.
fn invert_orientation_blocks<const D: usize>(
    blocks: &[SMatrix<f64, D, D>; MAX_BLOCKS],
) -> core::result::Result<[SMatrix<f64, D, D>; MAX_BLOCKS], f64> {
    let mut inverse = [SMatrix::zeros(); MAX_BLOCKS];
    for j in 0..D {
        inverse[j] = spd_inverse(&blocks[j])?;
    }
    Ok(inverse)
}

/// `(V (x) I) diag(blocks) (V (x) I)^T`, block D apart.
pub(super) fn expand<const D: usize>(
    axes: &SMatrix<f64, D, D>,
    blocks: &[SMatrix<f64, D, D>; MAX_BLOCKS],
) -> BlockMatrix<D> {
    let mut result = BlockMatrix::zeros();
    for i in 0..D {
        for j in 0..=i {
            let mut sum = SMatrix::<f64, D, D>::zeros();
            for k in 0..D {
                sum += blocks[k] * (axes[(i, k)] * axes[(j, k)]);
            }
            result.set_block(i, j, &sum);
        }
    }
    result.set_block(D, D, &blocks[D]);
    result
}
