//! From squared distances to the Gram matrix of centred positions.

use nalgebra::DMatrix;

use crate::model::kinematics::distance_record::pairs;

/// `G = -1/2 C D C` (\[A\] eq. 5) of squared distances `D`, or of anything linear in them, in the order of
/// [`pairs`]; `C = I - 1 1^T/N`.
///
/// ```
/// use nalgebra::dmatrix;
/// use rangelab::anchorless::distance_matrix::gram_matrix;
/// // Two nodes, 2 m apart: they stand at -1 and 1.
/// assert_eq!(gram_matrix(2, [4.0]), dmatrix![1.0, -1.0; -1.0, 1.0]);
/// ```
pub fn gram_matrix(nodes: usize, squared_distances: impl IntoIterator<Item = f64>) -> DMatrix<f64> {
    let mut gram = DMatrix::zeros(nodes, nodes);
    for ((i, j), squared) in pairs(nodes).zip(squared_distances) {
        gram[(i, j)] = -0.5 * squared;
        gram[(j, i)] = -0.5 * squared;
    }
    let mean = gram.column_sum() / nodes as f64;
    let all = mean.sum() / nodes as f64;
    for j in 0..nodes {
        for i in 0..nodes {
            // Written so that the matrix stays exactly symmetric.
            gram[(i, j)] += all - (mean[i] + mean[j]);
        }
    }
    gram
}
