//! How every computation runs: without the interpreter's lock, and so that a panic is an exception.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::prelude::*;

use crate::error::{InternalError, raised};

/// Runs a computation while other Python threads run.
///
/// # Errors
/// The crate's errors as exceptions; a panic, which is a mistake of rangelab, as `InternalError`.
pub fn compute<T: Send>(py: Python<'_>, work: impl FnOnce() -> rangelab::Result<T> + Send) -> PyResult<T> {
    match py.detach(|| catch_unwind(AssertUnwindSafe(work))) {
        Ok(Ok(value)) => Ok(value),
        Ok(Err(error)) => Err(raised(py, &error)),
        Err(panic) => {
            let message = said(&*panic);
            Err(InternalError::new_err(format!("a mistake in rangelab, please report it: {message}")))
        }
    }
}

fn said(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("no message")
}

/// Panics, so that a test sees what becomes of it.
#[pyfunction(name = "_panic_on_purpose")]
pub fn panic_on_purpose(py: Python<'_>) -> PyResult<()> {
    compute(py, || panic!("on purpose"))
}
