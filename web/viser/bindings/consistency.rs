//! The bands that NEES and NIS are held against.

use pyo3::prelude::*;

use crate::compute::compute;

/// The interval that chi-square stays in with a probability.
#[pyfunction]
pub fn chi_squared_interval(
    py: Python<'_>,
    degrees_of_freedom: f64,
    probability: f64,
) -> PyResult<(f64, f64)> {
    compute(py, || rangelab::math::chi_squared::chi_squared_interval(degrees_of_freedom, probability))
        .map(|[low, high]| (low, high))
}
