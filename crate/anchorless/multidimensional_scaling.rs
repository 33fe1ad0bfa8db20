//! Classical multidimensional scaling: positions from a Gram matrix.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::distance_matrix::gram_matrix;
use crate::error::{Error, Result};
use crate::math::float::sqrt;
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::estimate::KinematicsEstimate;

/// Positions whose Gram matrix is nearest to a given one, and its eigenvalues.
#[derive(Clone, Debug, PartialEq)]
pub struct Scaling {
    /// `Lambda^(1/2) V^T`, D x N, up to one element of O(D).
    pub positions: DMatrix<f64>,
    /// All N eigenvalues, decreasing, negative ones too: those after the first D are noise.
    pub values: Vec<f64>,
}

impl Scaling {
    /// The least eigenvalue kept over the most negative one: below 1 the smallest dimension drowns in noise.
    pub fn margin(&self) -> f64 {
        let kept = self.values[self.positions.nrows() - 1].max(0.0);
        let noise = -self.values[self.values.len() - 1];
        if noise > 0.0 { kept / noise } else { f64::INFINITY }
    }
}

/// The D algebraically **largest** eigenvalues, negative ones clipped at zero (\[A\] eq. 1, which says "non-zero"): by
/// magnitude a negative one of noise would win at times. `N >= D` is for the caller to see to.
///
/// ```
/// use nalgebra::dmatrix;
/// use rangelab::anchorless::multidimensional_scaling::classical_scaling;
/// let scaling = classical_scaling(&dmatrix![1.0, 0.0, 0.0; 0.0, -9.0, 0.0; 0.0, 0.0, 4.0], 2);
/// assert_eq!(scaling.values, [4.0, 1.0, -9.0]);
/// assert_eq!(scaling.positions.row(0).norm(), 2.0);
/// ```
pub fn classical_scaling(gram: &DMatrix<f64>, dimension: usize) -> Scaling {
    let eigen = gram.clone().symmetric_eigen();
    let mut order: Vec<usize> = (0..gram.nrows()).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let values: Vec<f64> = order.iter().map(|&index| eigen.eigenvalues[index]).collect();
    let positions = DMatrix::from_fn(dimension, gram.nrows(), |i, node| {
        sqrt(values[i].max(0.0)) * eigen.eigenvectors[(node, order[i])]
    });
    Scaling { positions, values }
}

/// Classical scaling of each epoch alone; an epoch with a missing distance has no positions.
///
/// # Errors
/// [`Error::TooFew`] for fewer than D + 1 nodes, or where every epoch misses a distance; [`Error::Number`] for distances above
/// 1e30 m.
pub fn snapshots(record: &DistanceRecord) -> Result<KinematicsEstimate> {
    let (nodes, dimension, what) = (record.nodes(), record.dimension(), "scaling of each epoch");
    super::at_least_nodes(what, nodes, dimension + 1, "Fewer do not span the space.")?;
    super::small_enough(record)?;
    let of_stamp = |k: usize| {
        let distances: Option<Vec<f64>> = record.distances(k).iter().copied().collect();
        let gram = gram_matrix(nodes, distances?.iter().map(|distance| distance * distance));
        Some(classical_scaling(&gram, dimension).positions)
    };
    let snapshots: Vec<Option<DMatrix<f64>>> = (0..record.stamps().len()).map(of_stamp).collect();
    if snapshots.iter().all(Option::is_none) {
        let (counted, reason) =
            ("complete epochs", "Where a distance is missing, positions are not scaled from the others.");
        return Err(Error::TooFew { what, counted, found: 0, needed: 1, reason });
    }
    Ok(KinematicsEstimate { snapshots, ..KinematicsEstimate::default() })
}
