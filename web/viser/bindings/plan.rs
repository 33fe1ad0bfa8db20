//! Monte-Carlo in numbered jobs: any thread, process or machine computes any of them, and their sum has one value.

use std::sync::{Arc, Mutex, PoisonError};

use pyo3::prelude::*;
use rangelab::model::noise::RangeNoise;
use rangelab::{Error, Result};

use crate::array::{Numbers, array};
use crate::compute::compute;
use crate::documents::Scenario;
use crate::indoor::IndoorScenario;
use crate::kinematics::KinematicsScenario;
use crate::studies::{BudgetStudy, IndoorStudy, KinematicsStudy, LocalizeStudy, Study, Total, TrackStudy};

/// A study: what its jobs are.
#[pyclass(frozen, module = "rangelab._core")]
pub struct Plan(Arc<dyn Study>);

impl Plan {
    fn new(study: impl Study + 'static) -> Self {
        Self(Arc::new(study))
    }
}

#[pymethods]
impl Plan {
    /// Trackers and bounds, step by step.
    #[staticmethod]
    fn track(py: Python<'_>, scenario: &Scenario, trials: usize) -> PyResult<Self> {
        let scenario = scenario.0.clone();
        compute(py, || TrackStudy::new(scenario, trials).map(Self::new))
    }

    /// Snapshot estimators at each noise of a sweep (JSON list).
    #[staticmethod]
    fn localize(py: Python<'_>, scenario: &Scenario, noises: &str, trials: usize) -> PyResult<Self> {
        let scenario = scenario.0.clone();
        compute(py, || LocalizeStudy::new(scenario, noises_of(noises)?, trials).map(Self::new))
    }

    /// The ET-KF at several thresholds.
    #[staticmethod]
    fn budget(py: Python<'_>, scenario: &Scenario, thresholds: Numbers, trials: usize) -> PyResult<Self> {
        let scenario = scenario.0.clone();
        compute(py, || BudgetStudy::new(scenario, thresholds.entries, trials).map(Self::new))
    }

    /// The filters of an indoor scenario.
    #[staticmethod]
    fn indoor(py: Python<'_>, scenario: &IndoorScenario, trials: usize) -> PyResult<Self> {
        let scenario = scenario.0.clone();
        compute(py, || IndoorStudy::new(scenario, trials).map(Self::new))
    }

    /// The estimators of a kinematics scenario.
    #[staticmethod]
    fn kinematics(py: Python<'_>, scenario: &KinematicsScenario, trials: usize) -> PyResult<Self> {
        let scenario = scenario.0.clone();
        compute(py, || KinematicsStudy::new(scenario, trials).map(Self::new))
    }

    /// How many jobs there are.
    #[getter]
    fn jobs(&self) -> usize {
        self.0.jobs()
    }

    /// Trials of each job but the last.
    #[getter]
    fn trials_per_job(&self) -> usize {
        self.0.trials_per_job()
    }

    /// The sums of job `index`, from 0, for `Sum.push`: numbers that mean nothing by themselves.
    fn job<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let numbers = compute(py, || {
            let (what, jobs) = ("is the number of the job; jobs", self.0.jobs());
            if index >= jobs {
                return Err(Error::Size { what, found: index, expected: jobs });
            }
            self.0.job(index)
        })?;
        array(py, &[numbers.len()], numbers)
    }

    /// No jobs yet.
    fn start(&self) -> Sum {
        Sum(Mutex::new(self.0.start()))
    }
}

/// The sum of jobs, joined in their order.
#[pyclass(frozen, module = "rangelab._core")]
pub struct Sum(Mutex<Box<dyn Total>>);

#[pymethods]
impl Sum {
    /// Joins what `Plan.job` gave for the job that comes next.
    fn push(&self, py: Python<'_>, numbers: Numbers) -> PyResult<()> {
        compute(py, || self.0.lock().unwrap_or_else(PoisonError::into_inner).push(&numbers.entries))
    }

    /// Trials so far.
    #[getter]
    fn trials(&self) -> usize {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).trials()
    }

    /// The figures so far as JSON, those of the command line.
    fn report(&self, py: Python<'_>) -> PyResult<String> {
        compute(py, || self.0.lock().unwrap_or_else(PoisonError::into_inner).report())
    }
}

fn noises_of(text: &str) -> Result<Vec<RangeNoise>> {
    serde_json::from_str(text)
        .map_err(|error| Error::Syntax { document: "sweep of noises", message: error.to_string() })
}
