//! Legendre polynomials: powers of time that stay apart on [-1, 1].

use alloc::vec;
use alloc::vec::Vec;

/// `P_0(s), ..., P_degree(s)` by the recurrence `(l + 1) P_(l+1) = (2l + 1) s P_l - l P_(l-1)`.
///
/// ```
/// assert_eq!(rangelab::math::legendre::legendre_values(3, 0.5), [1.0, 0.5, -0.125, -0.4375]);
/// ```
pub fn legendre_values(degree: usize, s: f64) -> Vec<f64> {
    let mut values = vec![1.0; degree + 1];
    if degree > 0 {
        values[1] = s;
    }
    for l in 1..degree {
        let n = l as f64;
        values[l + 1] = ((2.0 * n + 1.0) * s * values[l] - n * values[l - 1]) / (n + 1.0);
    }
    values
}

/// Coefficients of `s^0, s^1, ...` in each of `P_0, ..., P_degree`.
///
/// ```
/// assert_eq!(rangelab::math::legendre::legendre_powers(2), [vec![1.0], vec![0.0, 1.0], vec![-0.5, 0.0, 1.5]]);
/// ```
pub fn legendre_powers(degree: usize) -> Vec<Vec<f64>> {
    let mut rows = vec![vec![1.0], vec![0.0, 1.0]];
    for l in 1..degree {
        let n = l as f64;
        let mut next = vec![0.0; l + 2];
        for (power, value) in rows[l].iter().enumerate() {
            next[power + 1] += (2.0 * n + 1.0) / (n + 1.0) * value;
        }
        for (power, value) in rows[l - 1].iter().enumerate() {
            next[power] -= n / (n + 1.0) * value;
        }
        rows.push(next);
    }
    rows.truncate(degree + 1);
    rows
}
