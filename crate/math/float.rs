//! The only door to transcendental functions: `libm`, whose bits are the same natively and in WebAssembly.
//!
//! The crate is `no_std`, so there is no other door: `f64::sin` and the like do not exist in it.

pub use libm::{atan2, cos, exp, floor, lgamma, log, pow, sin};

/// Square root, correctly rounded, so the same bits everywhere.
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
pub use libm::sqrt;

/// Square root by the machine's instruction, which `libm` does not reach on stable WebAssembly; correctly rounded too.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
#[inline]
pub fn sqrt(x: f64) -> f64 {
    use core::arch::wasm32::{f64x2_extract_lane, f64x2_splat, f64x2_sqrt};
    f64x2_extract_lane::<0>(f64x2_sqrt(f64x2_splat(x)))
}

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
