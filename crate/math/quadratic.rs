//! Quadratic costs of an orientation, `(q - q_hat)^T W (q - q_hat)`, in the two forms that their metric takes.

use nalgebra::SMatrix;

use super::block::BlockMatrix;
use super::rotation::Rotation;

/// A symmetric positive semidefinite `W` on `q = vec(Q)`.
pub trait Metric<const D: usize> {
    /// `W vec(X)` in the shape of `X`.
    fn apply(&self, x: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D>;
}

impl<const D: usize> Metric<D> for BlockMatrix<D> {
    /// What the matrix says of `t` is not read.
    #[inline]
    fn apply(&self, x: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
        self.times_orientation(x)
    }
}

/// `W = sensors (x) anchors`, which takes `X` to `anchors X sensors`: all sensors are seen by the same anchors equally well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kronecker<const D: usize> {
    /// The information of the anchors about one sensor, `R`.
    pub anchors: SMatrix<f64, D, D>,
    /// Second moments of the sensors, `C C^T`.
    pub sensors: SMatrix<f64, D, D>,
}

impl<const D: usize> Metric<D> for Kronecker<D> {
    #[inline]
    fn apply(&self, x: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
        self.anchors * x * self.sensors
    }
}

/// `(q - q_hat)^T W (q - q_hat)` at an orthogonal matrix.
pub fn distance<const D: usize>(
    rotation: &Rotation<D>,
    q: &SMatrix<f64, D, D>,
    metric: &impl Metric<D>,
) -> f64 {
    let difference = rotation.matrix() - q;
    difference.dot(&metric.apply(&difference))
}
