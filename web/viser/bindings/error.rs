//! The crate's errors as exceptions.

use pyo3::exceptions::{PyException, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;
use pyo3::{create_exception, intern};

create_exception!(
    rangelab,
    Error,
    PyValueError,
    "What was wrong with the data, in a sentence with the numbers in it; all others derive from it."
);
create_exception!(
    rangelab,
    InvalidDocument,
    Error,
    "A scenario or recording breaks its rules: `problems` lists each as (path, value, limit)."
);
create_exception!(rangelab, Unobservable, Error, "Some motion of the body cannot be seen from the ranges.");
create_exception!(rangelab, NoConvergence, Error, "An iteration did not settle.");
create_exception!(rangelab, UnknownName, Error, "No such preset, figure or estimator.");
create_exception!(rangelab, Cancelled, PyException, "The computation was called off before it had a result.");
create_exception!(rangelab, InternalError, PyRuntimeError, "A mistake in rangelab itself.");

/// The exception of an error.
pub fn raised(py: Python<'_>, error: &rangelab::Error) -> PyErr {
    let message = error.to_string();
    match error {
        rangelab::Error::Invalid { problems, .. } => {
            let exception = InvalidDocument::new_err(message);
            let triples = problems.iter().map(|each| (&each.path, &each.value, &each.limit));
            let listed = PyList::new(py, triples)
                .and_then(|list| exception.value(py).setattr(intern!(py, "problems"), list));
            listed.err().unwrap_or(exception)
        }
        rangelab::Error::Unobservable { .. } => Unobservable::new_err(message),
        rangelab::Error::NoConvergence { .. } => NoConvergence::new_err(message),
        rangelab::Error::UnknownName { .. } => UnknownName::new_err(message),
        _ => Error::new_err(message),
    }
}
