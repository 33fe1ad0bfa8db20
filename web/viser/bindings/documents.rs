//! Scenarios of the labs Track, Localize and Explore.

use pyo3::prelude::*;
use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::recording::RecordingDocument;
use rangelab::study::track_run::run_scenario;

use crate::compute::compute;
use crate::recording::{Recording, Typed};
use crate::run::Run;

/// The JSON of a document of the crate; numbers, names and sentences always have one.
pub fn json<T: serde::Serialize + ?Sized>(value: &T) -> String {
    serde_json::to_string(value).expect("numbers, names and sentences always have a JSON form")
}

/// The presets: JSON `[{name, title, summary}]`.
#[pyfunction]
pub fn presets() -> String {
    json(&PRESETS)
}

/// The named bodies of a dimension: JSON `[{name, title, sensors}]`.
#[pyfunction]
pub fn topologies(dimension: usize) -> String {
    json(&rangelab::model::topologies::topologies(dimension))
}

/// A valid scenario.
#[pyclass(frozen, module = "rangelab._core")]
pub struct Scenario(pub rangelab::model::scenario::Scenario);

#[pymethods]
impl Scenario {
    #[new]
    fn new(py: Python<'_>, text: &str) -> PyResult<Self> {
        compute(py, || rangelab::model::scenario::Scenario::from_json(text).map(Self))
    }

    #[staticmethod]
    fn preset(py: Python<'_>, name: &str) -> PyResult<Self> {
        compute(py, || preset(name).map(Self))
    }

    fn to_json(&self) -> String {
        self.0.to_json()
    }

    fn simulate(&self, py: Python<'_>, trial: u64) -> PyResult<Recording> {
        let typed = compute(py, || Typed::simulated(&self.0, trial))?;
        let name = &self.0.name;
        let document = match &typed {
            Typed::Plane(recording) => RecordingDocument::new(name, recording),
            Typed::Space(recording) => RecordingDocument::new(name, recording),
        };
        Ok(Recording { document, typed })
    }

    fn run(&self, py: Python<'_>, trial: u64) -> PyResult<Run> {
        compute(py, || run_scenario(&self.0, trial).map(Run))
    }
}
