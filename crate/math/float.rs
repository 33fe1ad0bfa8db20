//! The only door to transcendental functions: `libm`, whose bits are the same natively and in WebAssembly.
//!
//! The crate is `no_std`, so there is no other door: `f64::sin` and the like do not exist in it.

pub use libm::{atan2, cos, exp, lgamma, log, pow, sin, sqrt};

/// Converts decibels to a ratio of powers, `10^(x/10)`.
///
/// ```
/// assert_eq!(rangelab::math::float::ratio_from_db(30.0), 1000.0);
/// ```
pub fn ratio_from_db(decibels: f64) -> f64 {
    pow(10.0, decibels / 10.0)
}

/// Degrees to radians.
pub fn radians(degrees: f64) -> f64 {
    degrees * (core::f64::consts::PI / 180.0)
}

/// Radians to degrees.
pub fn degrees(radians: f64) -> f64 {
    radians * (180.0 / core::f64::consts::PI)
}
