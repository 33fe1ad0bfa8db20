//! How the Gram matrix follows from the coefficients of the motion.

use nalgebra::DMatrix;

use super::alignment::read_out;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::time_scale::TimeScale;

/// Slopes of `vech(B_l)`, `B_l = sum_m Y_m^T Y_(l-m)/(m! (l-m)!)` (\[A\] eq. 7), by the coefficients of powers of scaled time;
/// rows are the entries on and below the diagonal.
///
/// It is blind to the gauge: `B_l` is centred, and a turn leaves it as it is.
pub fn gram_jacobian(motion: &RelativeKinematics, scale: &TimeScale, l: usize) -> DMatrix<f64> {
    let (nodes, dimension, degree) = (motion.nodes(), motion.dimension(), motion.degree());
    let unknowns = dimension * nodes * (degree + 1);
    let mut jacobian = DMatrix::zeros(nodes * (nodes + 1) / 2, unknowns);
    // Y_m/m! of each term that both factors have.
    let factorial = |n: usize| (2..=n).fold(1.0, |product, i| product * i as f64);
    for m in l.saturating_sub(degree)..=l.min(degree) {
        let slopes = read_out(motion, scale, m, 0.0).into_linear() / factorial(m);
        let other = motion.coefficient(l - m) / factorial(l - m);
        let mut row = 0;
        for j in 0..nodes {
            for i in j..nodes {
                // (dA^T B + B^T dA)_ij: over m each product has either of its factors moved once.
                for axis in 0..dimension {
                    let (of_i, of_j) = (slopes.row(i * dimension + axis), slopes.row(j * dimension + axis));
                    let mut entry = jacobian.row_mut(row);
                    entry += of_i * other[(axis, j)] + of_j * other[(axis, i)];
                }
                row += 1;
            }
        }
    }
    jacobian
}
