//! Where Newton's method starts.

use nalgebra::SMatrix;

use super::reduced::{ENTRIES, Reduced, ReducedMetric, padded};
use super::snapshot::Snapshot;
use crate::math::float::sqrt;
use crate::math::rotation::{Manifold, Rotation};
use crate::math::secular::sphere_minimum;
use crate::math::singular::singular;

/// The paper's start: the matrix of least cost with `||Q||_F = sqrt(D)` (\[L\] eq. 55), then its polar factor (eq. 56).
pub(super) fn start<const D: usize>(
    snapshot: &Snapshot<D>,
    reduced: &Reduced<D>,
    manifold: Manifold,
) -> Rotation<D> {
    let relaxed = match &reduced.metric {
        ReducedMetric::Shared(metric) => {
            // The eigenvectors of a Kronecker product are those of its factors.
            let anchors = singular(&metric.anchors);
            let sensors = &snapshot.moments;
            let turned = anchors.right.transpose() * reduced.weighted * sensors.right;
            let value = |i: usize, j: usize| anchors.values[i] * sensors.values[j];
            let y = on_sphere::<D>(|k| (value(k % D, k / D), turned[(k % D, k / D)]));
            let y = SMatrix::<f64, D, D>::from_fn(|i, j| y[j * D + i]);
            anchors.right * y * sensors.right.transpose()
        }
        ReducedMetric::Full(metric) => {
            let s = singular(&padded(metric));
            let unused = ENTRIES - D * D;
            let axis = |k: usize| SMatrix::<f64, D, D>::from_fn(|i, j| s.right[(j * D + i, unused + k)]);
            let y = on_sphere::<D>(|k| (s.values[unused + k], axis(k).dot(&reduced.weighted)));
            (0..D * D).fold(SMatrix::zeros(), |sum, k| sum + axis(k) * y[k])
        }
    };
    Rotation::project(&relaxed, manifold)
}

/// The minimum of a quadratic given along its axes by values and slopes.
fn on_sphere<const D: usize>(along: impl Fn(usize) -> (f64, f64)) -> [f64; ENTRIES] {
    let (mut values, mut slopes) = ([f64::INFINITY; ENTRIES], [0.0; ENTRIES]);
    for k in 0..D * D {
        (values[k], slopes[k]) = along(k);
    }
    sphere_minimum(&values, &slopes, sqrt(D as f64))
}

/// The 24 rotations that take a cube to itself; no rotation is farther than 63 degrees from one of them. In the plane the 4.
pub(super) fn cube_rotations<const D: usize>() -> impl Iterator<Item = Rotation<D>> {
    let permutations: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let signed = permutations.into_iter().flat_map(|columns| (0..8_u8).map(move |signs| (columns, signs)));
    signed.filter_map(|(columns, signs)| {
        let sign = |i: usize| if signs & (1 << i) == 0 { 1.0 } else { -1.0 };
        let full = SMatrix::<f64, 3, 3>::from_fn(|i, j| if columns[i] == j { sign(i) } else { 0.0 });
        let inside = D == 3 || (columns[2] == 2 && signs & 4 == 0);
        let rotation = crate::math::rotation::determinant(&full) > 0.0;
        (inside && rotation).then(|| Rotation::from_matrix_unchecked(SMatrix::from_fn(|i, j| full[(i, j)])))
    })
}
