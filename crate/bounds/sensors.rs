//! What a bound on `[Q | t]` says of the positions of the sensors.

use crate::math::block::BlockMatrix;
use crate::model::topology::Topology;

/// The trace of `(C_e^T (x) I) C (C_e (x) I)` (\[L\] eq. 51), the least sum over the sensors of `E ||s_hat - s||^2`, m^2.
///
/// `covariance` is that of `vec([Q | t])`: a Cramér-Rao bound as it is, a constrained one through
/// [`image`](super::constrained::image).
pub fn sensor_trace<const D: usize>(covariance: &BlockMatrix<D>, topology: &Topology<D>) -> f64 {
    let mut trace = 0.0;
    for j in 0..=D {
        for i in 0..=D {
            let block = (0..D).map(|k| covariance.entry(i * D + k, j * D + k)).sum::<f64>();
            trace += topology.extended_gram(i, j) * block;
        }
    }
    trace
}
