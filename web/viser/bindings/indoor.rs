//! The Indoor lab: an IMU and three transmitters on a body, beacons in a room.

use pyo3::prelude::*;
use rangelab::model::indoor;
use rangelab::model::indoor::TRANSMITTERS;
use rangelab::model::indoor::presets::{INDOOR_PRESETS, indoor_preset};
use rangelab::simulate::indoor::simulate_indoor;
use rangelab::study::indoor::run::run_indoor_recording;

use crate::array::{array, flags};
use crate::compute::compute;
use crate::documents::json;
use crate::run::{Part, padded};

/// The presets: JSON `[{name, title, summary}]`.
#[pyfunction]
pub fn indoor_presets() -> String {
    json(&INDOOR_PRESETS)
}

/// A valid indoor scenario.
#[pyclass(frozen, module = "rangelab._core")]
pub struct IndoorScenario(pub indoor::IndoorScenario);

#[pymethods]
impl IndoorScenario {
    #[new]
    fn new(py: Python<'_>, text: &str) -> PyResult<Self> {
        compute(py, || indoor::IndoorScenario::from_json(text).map(Self))
    }

    #[staticmethod]
    fn preset(py: Python<'_>, name: &str) -> PyResult<Self> {
        compute(py, || indoor_preset(name).map(Self))
    }

    fn to_json(&self) -> String {
        self.0.to_json()
    }

    fn run(&self, py: Python<'_>, trial: u64) -> PyResult<IndoorRun> {
        compute(py, || {
            let recording = simulate_indoor(&self.0, trial)?;
            let run = run_indoor_recording(&self.0.name, &recording, &self.0.filters);
            let beacons = run.beacons.len();
            let present = recording.epochs.iter().flat_map(|epoch| epoch.present(beacons)).collect();
            Ok(IndoorRun { run, present })
        })
    }
}

/// A run of the filters; they are numbered as in its document.
#[pyclass(frozen, module = "rangelab._core")]
pub struct IndoorRun {
    run: indoor::run::IndoorRun,
    present: Vec<bool>,
}

/// A number of a step, by name; NaN where there is none.
fn number_of(step: &indoor::run::IndoorStepRecord, name: &str) -> f64 {
    match name {
        "orientation_error" => step.angle_error,
        "position_error" => step.position_error,
        "nees" => step.nees,
        "nis" => step.nis.unwrap_or(f64::NAN),
        _ => f64::NAN,
    }
}

#[pymethods]
impl IndoorRun {
    fn to_json(&self) -> String {
        self.run.to_json()
    }

    #[getter]
    fn name(&self) -> &str {
        &self.run.name
    }

    /// The filters.
    fn filters(&self) -> Vec<Part<'_>> {
        let filters = self.run.filters.iter();
        filters
            .map(|run| {
                let (step, message) = run.failure.as_ref().map(|f| (f.step, f.message.as_str())).unzip();
                (run.name.name(), run.label.as_str(), step, message)
            })
            .collect()
    }

    fn beacons<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.run.beacons.iter().map(|beacon| Some(beacon.clone()));
        padded(py, &[self.run.beacons.len(), 3], rows)
    }

    fn transmitters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.run.transmitters.iter().map(|transmitter| Some(transmitter.clone()));
        padded(py, &[self.run.transmitters.len(), 3], rows)
    }

    fn times<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, &[self.run.times.len()], self.run.times.iter().copied())
    }

    fn fixes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        flags(py, &[self.run.times.len()], self.run.fixes.iter().copied())
    }

    /// True where a range was measured: K x M x 3.
    fn present<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let shape = [self.run.times.len(), self.run.beacons.len(), TRANSMITTERS];
        flags(py, &shape, self.present.iter().copied())
    }

    fn truth_positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.run.truth.iter().map(|pose| Some(pose.position.clone()));
        padded(py, &[self.run.times.len(), 3], rows)
    }

    fn truth_orientations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.run.truth.iter().map(|pose| Some(pose.orientation.concat()));
        padded(py, &[self.run.times.len(), 3, 3], rows)
    }

    fn positions<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.steps(index).map(|step| Some(step.pose.position.clone()));
        padded(py, &[self.run.times.len(), 3], rows)
    }

    fn orientations<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.steps(index).map(|step| Some(step.pose.orientation.concat()));
        padded(py, &[self.run.times.len(), 3, 3], rows)
    }

    fn position_covariances<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.steps(index).map(|step| Some(step.position_covariance.concat()));
        padded(py, &[self.run.times.len(), 3, 3], rows)
    }

    fn rotation_covariances<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.steps(index).map(|step| Some(step.rotation_covariance.concat()));
        padded(py, &[self.run.times.len(), 3, 3], rows)
    }

    /// The singular values of `R`, largest first.
    fn singular_values<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.steps(index).map(|step| Some(step.singular_values.to_vec()));
        padded(py, &[self.run.times.len(), 3], rows)
    }

    fn numbers<'py>(&self, py: Python<'py>, index: usize, name: &str) -> PyResult<Bound<'py, PyAny>> {
        array(py, &[self.run.times.len()], self.steps(index).map(|step| number_of(step, name)))
    }
}

impl IndoorRun {
    fn steps(&self, index: usize) -> impl Iterator<Item = &indoor::run::IndoorStepRecord> {
        self.run.filters.get(index).into_iter().flat_map(|run| &run.steps)
    }
}
