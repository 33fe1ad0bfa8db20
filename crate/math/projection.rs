//! Projection of `Q` onto SO(D) or O(D) in any metric: the step in which constrained estimators differ.

use nalgebra::SMatrix;

use super::block::BlockMatrix;
use super::newton::newton;
use super::quadratic::distance;
use super::rotation::{Manifold, Rotation};
use super::secular::plane_minimum;
use crate::error::Result;

/// `arg min (q - q_hat)^T W (q - q_hat)` over the manifold, `q = vec(Q)`.
///
/// `metric` holds `W` in its blocks of `Q`; what it says of `t` is not read. In the plane the minimum is global, from the secular equation of a quadratic
/// on the circle. In space it is a safeguarded Newton iteration from the better of two polar factors (of `Q_hat` and of
/// `W q_hat`; the second is already the answer where `W = I (x) W_row`), run until its steps stop shrinking. Over O(D) both
/// components are searched and the cheaper answer is taken.
///
/// # Errors
/// [`crate::Error::NoConvergence`].
///
/// ```
/// use nalgebra::Matrix3;
/// use rangelab::math::{block::BlockMatrix, rotation::{Manifold, Rotation}};
/// use rangelab::math::projection::project_in_metric;
/// let q = Matrix3::new(1.1, 0.2, 0.0, -0.1, 0.9, 0.0, 0.0, 0.1, 1.0);
/// let identity = BlockMatrix::isotropic(1.0, 0.0);
/// let nearest = project_in_metric(&q, &identity, Manifold::So)?;
/// assert!((nearest.matrix() - Rotation::project(&q, Manifold::So).matrix()).norm() < 1e-15);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn project_in_metric<const D: usize>(
    q: &SMatrix<f64, D, D>,
    metric: &BlockMatrix<D>,
    manifold: Manifold,
) -> Result<Rotation<D>> {
    let rotation = minimum(q, metric)?;
    if manifold == Manifold::So {
        return Ok(rotation);
    }
    // O(D) has a second component, {R J : R in SO(D)} with J mirroring the last axis of the body.
    let mirrored = minimum(&mirror(q), &mirror_metric(metric))?;
    let reflection = Rotation::from_matrix_unchecked(mirror(mirrored.matrix()));
    Ok(if distance(&reflection, q, metric) < distance(&rotation, q, metric) { reflection } else { rotation })
}

fn minimum<const D: usize>(q: &SMatrix<f64, D, D>, metric: &BlockMatrix<D>) -> Result<Rotation<D>> {
    let weighted = metric.times_orientation(q);
    if D == 2 {
        return Ok(plane_minimum(metric, &weighted));
    }
    let starts = [&weighted, q].map(|matrix| Rotation::project(matrix, Manifold::So));
    let better = usize::from(distance(&starts[1], q, metric) < distance(&starts[0], q, metric));
    newton(starts[better], q, metric)
}

fn mirror<const D: usize>(q: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    let mut result = *q;
    for i in 0..D {
        result[(i, D - 1)] = -result[(i, D - 1)];
    }
    result
}

fn mirror_metric<const D: usize>(metric: &BlockMatrix<D>) -> BlockMatrix<D> {
    let mut result = *metric;
    for j in 0..D - 1 {
        result.set_block(D - 1, j, &-metric.block(D - 1, j));
    }
    result
}
