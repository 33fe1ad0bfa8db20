//! The papers' figures: their jobs, the sum of those, and the report.

use std::sync::{Arc, Mutex, PoisonError};

use pyo3::prelude::*;
use rangelab::study::figures::plan::{FigurePlan as Inner, FigureSum};
use rangelab::study::figures::{FIGURES, figure};

use crate::array::{Numbers, array};
use crate::compute::compute;
use crate::documents::json;

/// The figures: JSON of the crate's `Figure`, in the order in which they are listed.
#[pyfunction]
pub fn figures() -> String {
    json(&FIGURES)
}

/// A figure of a number of trials, and the sum of its jobs so far.
#[pyclass(frozen, module = "rangelab._core")]
pub struct FigurePlan {
    plan: Arc<Inner>,
    sum: Mutex<FigureSum>,
}

#[pymethods]
impl FigurePlan {
    #[new]
    fn new(py: Python<'_>, name: &str, trials: usize, seed: u64) -> PyResult<Self> {
        compute(py, || {
            let plan = Inner::new(figure(name)?, trials, seed)?;
            let sum = Mutex::new(plan.start());
            Ok(Self { plan: Arc::new(plan), sum })
        })
    }

    /// How many jobs there are; each takes about as long.
    #[getter]
    fn jobs(&self) -> usize {
        self.plan.jobs()
    }

    /// The sums of job `index`, from 0.
    fn job<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let numbers = compute(py, || Ok(self.plan.to_numbers(&self.plan.job(index)?)))?;
        array(py, &[numbers.len()], numbers)
    }

    /// Joins what `job` gave for the job that comes next.
    fn push(&self, py: Python<'_>, numbers: Numbers) -> PyResult<()> {
        compute(py, || {
            let next = self.plan.from_numbers(&numbers.entries)?;
            self.sum.lock().unwrap_or_else(PoisonError::into_inner).merge(&next)
        })
    }

    /// The report (JSON) and its table (CSV) of the jobs so far, the texts of the command line.
    fn report(&self, py: Python<'_>) -> PyResult<(String, String)> {
        compute(py, || {
            let report = self.plan.report(&self.sum.lock().unwrap_or_else(PoisonError::into_inner))?;
            Ok((report.to_json(), report.to_csv()))
        })
    }
}
