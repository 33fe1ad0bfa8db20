//! Factorials.

/// `n! = 1 2 ... n`, exact up to 22!.
///
/// ```
/// use rangelab::math::factorial::factorial;
/// assert_eq!([0, 1, 4, 22].map(factorial), [1.0, 1.0, 24.0, 1_124_000_727_777_607_680_000.0]);
/// ```
pub fn factorial(n: usize) -> f64 {
    (2..=n).fold(1.0, |product, i| product * i as f64)
}
