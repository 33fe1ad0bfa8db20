//! Recordings: what estimators are given, from a file, from arrays or simulated.

use pyo3::prelude::*;
use rangelab::Error;
use rangelab::model::document::entries::PoseEntries;
use rangelab::model::epoch;
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::recording::{EpochDocument, RecordingDocument};
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;
use rangelab::study::track_run::run_document;

use crate::array::{Numbers, array};
use crate::compute::compute;
use crate::run::Run;
use crate::tracker::{Track, track};

/// A recording with its dimension known to the compiler.
pub enum Typed {
    Plane(epoch::Recording<2>),
    Space(epoch::Recording<3>),
}

impl Typed {
    pub fn simulated(scenario: &Scenario, trial: u64) -> rangelab::Result<Self> {
        match scenario.dimension {
            2 => simulate::<2>(scenario, trial).map(Self::Plane),
            _ => simulate::<3>(scenario, trial).map(Self::Space),
        }
    }

    fn of(document: &RecordingDocument) -> rangelab::Result<Self> {
        match document.dimension {
            2 => document.recording::<2>().map(Self::Plane),
            _ => document.recording::<3>().map(Self::Space),
        }
    }
}

/// A valid recording.
#[pyclass(frozen, module = "rangelab._core")]
pub struct Recording {
    pub document: RecordingDocument,
    pub typed: Typed,
}

#[pymethods]
impl Recording {
    #[new]
    fn new(py: Python<'_>, text: &str) -> PyResult<Self> {
        compute(py, || Self::of(RecordingDocument::from_json(text)?))
    }

    /// A recording whose document (JSON) is complete but for its ranges, with these squared ranges, m^2: K x M x N, NaN where
    /// missing.
    #[staticmethod]
    fn with_squared_ranges(py: Python<'_>, text: &str, squared_ranges: Numbers) -> PyResult<Self> {
        let syntax =
            |error: serde_json::Error| Error::Syntax { document: "recording", message: error.to_string() };
        let mut document: RecordingDocument = compute(py, || serde_json::from_str(text).map_err(syntax))?;
        let (anchors, sensors) = (document.anchors.len(), document.sensors.len());
        let shape = [document.epochs.len(), anchors, sensors];
        let entries = squared_ranges.shaped("squared_ranges", &shape)?;
        let mut tables = entries.chunks((anchors * sensors).max(1));
        compute(py, || {
            for epoch in &mut document.epochs {
                let rows = tables.next().unwrap_or_default().chunks(sensors.max(1));
                let known = |row: &[f64]| row.iter().map(|&d| (!d.is_nan()).then_some(d)).collect();
                epoch.squared_ranges = Some(rows.map(known).collect());
            }
            Self::of(document)
        })
    }

    fn to_json(&self) -> String {
        self.document.to_json()
    }

    fn run(&self, py: Python<'_>, settings: &str) -> PyResult<Run> {
        compute(py, || run_document(&self.document, &EstimatorSettings::from_json(settings)?).map(Run))
    }

    /// One estimator alone: neither bounds nor errors.
    fn track(&self, py: Python<'_>, name: &str, settings: &str) -> PyResult<Track> {
        compute(py, || {
            let (name, settings) = (estimator_name(name)?, EstimatorSettings::from_json(settings)?);
            Ok(match &self.typed {
                Typed::Plane(recording) => track(recording, name, &settings),
                Typed::Space(recording) => track(recording, name, &settings),
            })
        })
    }

    #[getter]
    fn dimension(&self) -> usize {
        self.document.dimension
    }

    #[getter]
    fn epochs(&self) -> usize {
        self.document.epochs.len()
    }

    fn anchors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let anchors = &self.document.anchors;
        array(py, &[anchors.len(), self.document.dimension], anchors.iter().flatten().copied())
    }

    fn sensors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let sensors = &self.document.sensors;
        array(py, &[sensors.len(), self.document.dimension], sensors.iter().flatten().copied())
    }

    fn intervals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, &[self.epochs()], self.document.epochs.iter().map(|epoch| epoch.interval))
    }

    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let numbers = self.document.epochs.iter().flat_map(|epoch| epoch.velocity.iter().copied());
        array(py, &[self.epochs(), self.document.dimension], numbers)
    }

    fn angular_velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let axes = rangelab::math::rotation::rotation_angles(self.document.dimension);
        let numbers = self.document.epochs.iter().flat_map(|epoch| epoch.angular_velocity.iter().copied());
        array(py, &[self.epochs(), axes], numbers)
    }

    fn squared_ranges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (anchors, sensors) = (self.document.anchors.len(), self.document.sensors.len());
        let shape = [self.epochs(), anchors, sensors];
        let entry = |k: usize, m: usize, n: usize| match &self.typed {
            Typed::Plane(recording) => recording.epochs[k].ranges.get(m, n),
            Typed::Space(recording) => recording.epochs[k].ranges.get(m, n),
        };
        let numbers = (0..shape.iter().product())
            .map(|i| entry(i / (anchors * sensors), i / sensors % anchors, i % sensors).unwrap_or(f64::NAN));
        array(py, &shape, numbers)
    }

    fn truth_orientations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let d = self.document.dimension;
        let flat = |pose: &PoseEntries| pose.orientation.concat();
        array(py, &[self.epochs(), d, d], self.truth(d * d, flat))
    }

    fn truth_positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let d = self.document.dimension;
        array(py, &[self.epochs(), d], self.truth(d, |pose| pose.position.clone()))
    }
}

impl Recording {
    fn of(document: RecordingDocument) -> rangelab::Result<Self> {
        let typed = Typed::of(&document)?;
        Ok(Self { document, typed })
    }

    /// NaN where the truth is not known.
    fn truth(&self, width: usize, read: impl Fn(&PoseEntries) -> Vec<f64>) -> impl Iterator<Item = f64> {
        let row =
            move |epoch: &EpochDocument| epoch.truth.as_ref().map_or_else(|| vec![f64::NAN; width], &read);
        self.document.epochs.iter().flat_map(row)
    }
}

/// The estimator of a name.
pub fn estimator_name(name: &str) -> rangelab::Result<EstimatorName> {
    let known = || EstimatorName::ALL.map(EstimatorName::name).join(", ");
    EstimatorName::ALL.into_iter().find(|each| each.name() == name).ok_or_else(|| Error::UnknownName {
        what: "estimator",
        name: name.to_owned(),
        known: known(),
    })
}
