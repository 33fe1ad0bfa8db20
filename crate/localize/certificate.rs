//! A proof that a stationary point is the global minimum.

use nalgebra::SMatrix;

use super::reduced::Reduced;
use crate::math::block::BlockMatrix;
use crate::math::quadratic::Metric;
use crate::math::rotation::Rotation;

/// How the multipliers are shared between `Q^T Q = I` and `Q Q^T = I`.
const SHARES: [f64; 3] = [1.0, 0.0, 0.5];

/// Whether no orthogonal matrix, reflections included, costs less than `rotation`, which must be stationary.
///
/// With multipliers `L` of `Q^T Q = I` and `M` of `Q Q^T = I` the Lagrangian is a quadratic with the matrix
/// `W - L (x) I - I (x) M`; it is stationary at `R` where `W (R - Q_LS) = R L + M R`. Where that matrix is positive definite `R`
/// is its one minimum, and on the manifold the Lagrangian is the cost. `S = R^T W (R - Q_LS)` is symmetric at a stationary
/// point, and `L = s S`, `M = (1 - s) R S R^T` fit for any `s`. Sufficient, not necessary: where residuals are large it may
/// fail at a global minimum.
pub(super) fn certified<const D: usize>(rotation: &Rotation<D>, reduced: &Reduced<D>) -> bool {
    let r = rotation.matrix();
    let s = r.transpose() * reduced.metric.apply(&(r - reduced.target));
    let s = (s + s.transpose()) * 0.5;
    let turned = r * s * r.transpose();
    let metric = reduced.metric.to_blocks();
    SHARES.iter().any(|&share| {
        lagrangian(&metric, &(s * share), &(turned * (1.0 - share))).is_positive_on_orientation()
    })
}

fn lagrangian<const D: usize>(
    metric: &BlockMatrix<D>,
    columns: &SMatrix<f64, D, D>,
    rows: &SMatrix<f64, D, D>,
) -> BlockMatrix<D> {
    let mut result = *metric;
    let of_columns = |i: usize, j: usize| if i < D && j < D { -columns[(i, j)] } else { 0.0 };
    result.add_kronecker(of_columns, &SMatrix::identity());
    result.add_kronecker(|i, j| if i == j && i < D { -1.0 } else { 0.0 }, rows);
    result
}
