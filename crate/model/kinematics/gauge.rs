//! What distances cannot show, taken away: one element of O(D) brings an estimate next to the truth.

use nalgebra::DMatrix;

use super::coefficients::RelativeKinematics;
use crate::error::{Error, Result};
use crate::math::orthogonal::nearest_orthogonal;

/// The `Q` in O(D) with the least `||Q from - to||_F` (orthogonal Procrustes), D x N matrices with centred columns.
///
/// # Errors
/// [`Error::Number`] for a dimension other than 2 or 3.
pub fn procrustes(from: &DMatrix<f64>, to: &DMatrix<f64>) -> Result<DMatrix<f64>> {
    nearest_orthogonal(&(to * from.transpose()))
}

impl RelativeKinematics {
    /// The estimate in the frame of `truth`: **one** element of O(D), from `Y_0`, for all coefficients, both centred.
    ///
    /// Aligning each coefficient by itself would hide a wrong rotation of accelerations against positions.
    ///
    /// # Errors
    /// [`Error::Size`] where the truth has another number of nodes or coordinates, [`Error::Number`] for a dimension other than
    /// 2 or 3.
    ///
    /// ```
    /// use nalgebra::dmatrix;
    /// use rangelab::model::kinematics::coefficients::RelativeKinematics;
    /// let truth = RelativeKinematics::new(vec![dmatrix![-3.0, 3.0, 0.0; 1.0, 1.0, -2.0], dmatrix![1.0, -1.0, 0.0; 2.0, 0.0, -2.0]])?;
    /// let mirrored = truth.rotated(&dmatrix![0.0, 1.0; 1.0, 0.0]);
    /// let aligned = mirrored.aligned_to(&truth)?;
    /// assert!((aligned.coefficient(1) - truth.coefficient(1)).norm() < 1e-12);
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn aligned_to(&self, truth: &Self) -> Result<Self> {
        for (what, found, expected) in [
            ("coordinates of a node", self.dimension(), truth.dimension()),
            ("nodes", self.nodes(), truth.nodes()),
        ] {
            if found != expected {
                return Err(Error::Size { what, found, expected });
            }
        }
        let (estimate, truth) = (self.centred(), truth.centred());
        let q = procrustes(estimate.coefficient(0), truth.coefficient(0))?;
        Ok(estimate.rotated(&q))
    }
}
