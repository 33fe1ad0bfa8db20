//! How errors of the Gram matrix follow from the noise.

use nalgebra::DMatrix;

use super::KinematicsBound;
use super::alignment::ReadOut;
use crate::math::factorial::factorial;

/// Errors of `vech(B_l)`, `B_l = sum_m Y_m^T Y_(l-m)/(m! (l-m)!)` (\[A\] eq. 7), by independent normal numbers of variance 1;
/// rows are the entries on and below the diagonal.
///
/// They are blind to the gauge: `B_l` is centred, and a turn leaves it as it is.
pub fn gram_noise(bound: &KinematicsBound, l: usize) -> DMatrix<f64> {
    let motion = &bound.motion;
    let (nodes, dimension, degree) = (motion.nodes(), motion.dimension(), motion.degree());
    let mut noise = DMatrix::zeros(nodes * (nodes + 1) / 2, bound.root.ncols());
    // Y_m/m! of each term that both factors have.
    for m in l.saturating_sub(degree)..=l.min(degree) {
        let moved = ReadOut::new(bound, m, 0.0).into_noise() / factorial(m);
        let other = motion.coefficient(l - m) / factorial(l - m);
        let mut row = 0;
        for j in 0..nodes {
            for i in j..nodes {
                // (dA^T B + B^T dA)_ij: over m each product has either of its factors moved once.
                for axis in 0..dimension {
                    let (of_i, of_j) = (moved.row(i * dimension + axis), moved.row(j * dimension + axis));
                    let mut entry = noise.row_mut(row);
                    entry += of_i * other[(axis, j)] + of_j * other[(axis, i)];
                }
                row += 1;
            }
        }
    }
    noise
}
