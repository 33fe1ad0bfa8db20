//! Numbers to `NumPy` and back.
//!
//! Numbers are written once, into the memory that the array then has.

use pyo3::buffer::PyBuffer;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyByteArray, PyTuple};

use crate::error::Error;

/// A `NumPy` array of doubles in a shape; what `numbers` lacks at its end is NaN, what is beyond the shape is left out.
pub fn array<'py>(
    py: Python<'py>,
    shape: &[usize],
    numbers: impl IntoIterator<Item = f64>,
) -> PyResult<Bound<'py, PyAny>> {
    let count: usize = shape.iter().product();
    let mut numbers = numbers.into_iter();
    let bytes = PyByteArray::new_with(py, 8 * count, |bytes| {
        for cell in bytes.chunks_exact_mut(8) {
            cell.copy_from_slice(&numbers.next().unwrap_or(f64::NAN).to_ne_bytes());
        }
        Ok(())
    })?;
    viewed(py, &bytes, intern!(py, "float64"), shape)
}

/// A `NumPy` array of truth values in a shape.
pub fn flags<'py>(
    py: Python<'py>,
    shape: &[usize],
    flags: impl IntoIterator<Item = bool>,
) -> PyResult<Bound<'py, PyAny>> {
    let mut flags = flags.into_iter();
    let bytes = PyByteArray::new_with(py, shape.iter().product(), |bytes| {
        bytes.fill_with(|| u8::from(flags.next().unwrap_or(false)));
        Ok(())
    })?;
    viewed(py, &bytes, intern!(py, "bool"), shape)
}

fn viewed<'py>(
    py: Python<'py>,
    bytes: &Bound<'py, PyByteArray>,
    kind: &Bound<'py, pyo3::types::PyString>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyAny>> {
    static NDARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let ndarray = NDARRAY.get_or_try_init(py, || {
        Ok::<_, PyErr>(py.import(intern!(py, "numpy"))?.getattr(intern!(py, "ndarray"))?.unbind())
    })?;
    ndarray.bind(py).call1((PyTuple::new(py, shape)?, kind, bytes))
}

/// The doubles of an array, row by row, and its shape.
pub struct Numbers {
    /// The lengths of its axes.
    pub shape: Vec<usize>,
    /// Its entries.
    pub entries: Vec<f64>,
}

impl<'a, 'py> FromPyObject<'a, 'py> for Numbers {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let buffer = PyBuffer::<f64>::get(&object)?;
        Ok(Self { shape: buffer.shape().to_vec(), entries: buffer.to_vec(object.py())? })
    }
}

impl Numbers {
    /// The entries, where they come in this shape.
    ///
    /// # Errors
    /// A sentence with both shapes.
    pub fn shaped(self, what: &str, shape: &[usize]) -> PyResult<Vec<f64>> {
        if self.shape == shape {
            return Ok(self.entries);
        }
        Err(Error::new_err(format!("{what} have the shape {:?} where {shape:?} is needed", self.shape)))
    }
}
