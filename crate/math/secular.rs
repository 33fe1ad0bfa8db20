//! Global minima of quadratics on spheres, by the secular equation of their multiplier.

use nalgebra::{Matrix2, SMatrix};

use super::block::BlockMatrix;
use super::float::sqrt;
use super::rotation::Rotation;
use super::singular::singular;

/// `arg min q^T W q - 2 q^T (W q_hat)` over SO(2); `weighted` is `W q_hat` in the shape of `Q`.
///
/// With `x = (cos, sin)` this is `x^T A x - 2 b^T x` on the unit circle. Its stationary points are the roots of a
/// quartic in the multiplier; the global minimum is the largest root, the one beyond the least eigenvalue of `-A`, where
/// `||(A + multiplier)^-1 b|| = 1` is monotone.
pub fn plane_minimum<const D: usize>(metric: &BlockMatrix<D>, weighted: &SMatrix<f64, D, D>) -> Rotation<D> {
    let block = |i: usize, j: usize| Matrix2::from_fn(|r, c| metric.block(i, j)[(r, c)]);
    // Column 0 of Q is x, column 1 is J x.
    let turn = Matrix2::new(0.0, -1.0, 1.0, 0.0);
    let mixed = block(0, 1) * turn;
    let a = block(0, 0) + turn.transpose() * block(1, 1) * turn + mixed + mixed.transpose();
    let b = [weighted[(0, 0)] + weighted[(1, 1)], weighted[(1, 0)] - weighted[(0, 1)]];
    let eigen = singular(&a);
    let axis = |k: usize, i: usize| eigen.right[(i, k)];
    let beta = [0, 1].map(|k| axis(k, 0) * b[0] + axis(k, 1) * b[1]);
    let y = circle_minimum(eigen.values[0] - eigen.values[1], beta);
    let x = [0, 1].map(|i| axis(0, i) * y[0] + axis(1, i) * y[1]);
    let length = sqrt(x[0] * x[0] + x[1] * x[1]);
    let (cosine, sine) = (x[0] / length, x[1] / length);
    let mut matrix = SMatrix::identity();
    matrix[(0, 0)] = cosine;
    matrix[(1, 0)] = sine;
    matrix[(0, 1)] = -sine;
    matrix[(1, 1)] = cosine;
    Rotation::from_matrix_unchecked(matrix)
}

/// `arg min gap y_0^2 - 2 beta^T y` on the unit circle, `gap >= 0`.
///
/// `y = (beta_0/(gap + mu), beta_1/mu)` with the one `mu > 0` that gives it unit length; Newton on `1/||y||`, which is
/// concave in `mu`, rises to it from the left and ends when rounding stops it.
fn circle_minimum(gap: f64, beta: [f64; 2]) -> [f64; 2] {
    let mut mu = beta[1].abs().max(beta[0].abs() - gap);
    if mu <= 0.0 {
        // The hard case: both ends of the short axis are equally good; the positive one is taken.
        let first = if gap > 0.0 { beta[0] / gap } else { 0.0 };
        return [first, sqrt(1.0 - first * first)];
    }
    let at = |mu: f64| [beta[0] / (gap + mu), beta[1] / mu];
    loop {
        let y = at(mu);
        let squared = y[0] * y[0] + y[1] * y[1];
        let length = sqrt(squared);
        let slope = (y[0] * y[0] / (gap + mu) + y[1] * y[1] / mu) / squared;
        let next = mu + (length - 1.0) / slope;
        if !(next > mu) {
            return y;
        }
        mu = next;
    }
}

/// `arg min sum_i values_i y_i^2 - 2 beta_i y_i` on the sphere `||y|| = radius`, values non-negative (Gander's LSQE).
///
/// `y_i = beta_i/(values_i + mu)` with the one `mu > -min(values)` that gives it its length; where none does (the hard case)
/// the rest of the length is given to the least value's direction.
pub fn sphere_minimum<const N: usize>(values: &[f64; N], beta: &[f64; N], radius: f64) -> [f64; N] {
    let least = (0..N).fold(0, |best, i| if values[i] < values[best] { i } else { best });
    let gap: [f64; N] = core::array::from_fn(|i| values[i] - values[least]);
    let scale = beta.iter().fold(0.0, |largest: f64, b| largest.max(b.abs()));
    let at = |nu: f64| -> [f64; N] { core::array::from_fn(|i| beta[i] / (gap[i] + nu)) };
    // Each coordinate alone must not be longer than the sphere allows: the root is beyond this.
    let mut nu = (0..N).fold(0.0, |nu: f64, i| nu.max(beta[i].abs() / radius - gap[i]));
    if nu <= f64::EPSILON * scale / radius {
        let mut y: [f64; N] = core::array::from_fn(|i| if gap[i] > 0.0 { beta[i] / gap[i] } else { 0.0 });
        y[least] = 0.0;
        let rest = radius * radius - y.iter().map(|y| y * y).sum::<f64>();
        if rest >= 0.0 {
            y[least] = sqrt(rest).copysign(beta[least]);
            return y;
        }
        nu = f64::EPSILON * scale / radius;
    }
    loop {
        let y = at(nu);
        let squared: f64 = y.iter().map(|y| y * y).sum();
        let slope = (0..N).map(|i| y[i] * y[i] / (gap[i] + nu)).sum::<f64>() / squared;
        let next = nu + (sqrt(squared) / radius - 1.0) / slope;
        if !(next > nu) {
            return y;
        }
        nu = next;
    }
}
