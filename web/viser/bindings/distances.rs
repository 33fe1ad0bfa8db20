//! Distances between nodes, and what each estimator of relative kinematics makes of them.

use pyo3::prelude::*;
use rangelab::anchorless::estimate;
use rangelab::model::kinematics::distance_record::{self, Accelerometers, pair_count};
use rangelab::model::kinematics::estimate::KinematicsEstimate as Inner;
use rangelab::model::kinematics::settings::{KinematicsName, KinematicsSettings};

use crate::array::{Numbers, array};
use crate::compute::compute;
use crate::motion::{RelativeKinematics, axes, by_rows, matrices, stack};

/// The estimators of relative kinematics by name, label, and whether they read accelerations.
#[pyfunction]
pub fn kinematics_estimators() -> Vec<(&'static str, &'static str, bool)> {
    KinematicsName::ALL.map(|each| (each.name(), each.label(), each.reads_accelerations())).into()
}

/// Distances and accelerations at some stamps.
#[pyclass(frozen, module = "rangelab._core")]
pub struct DistanceRecord(pub distance_record::DistanceRecord);

#[pymethods]
impl DistanceRecord {
    /// Distances K x P in the order of pairs (0, 1), (0, 2), ..., (1, 2), ..., NaN where missing.
    #[new]
    fn new(
        py: Python<'_>,
        dimension: usize,
        nodes: usize,
        stamps: Numbers,
        distances: Numbers,
        sigma: f64,
    ) -> PyResult<Self> {
        let known = distances.entries.into_iter().map(|d| (!d.is_nan()).then_some(d)).collect();
        compute(py, || {
            distance_record::DistanceRecord::new(dimension, nodes, stamps.entries, known, sigma).map(Self)
        })
    }

    /// The same record with readings K x N x D.
    fn with_accelerometers(&self, py: Python<'_>, readings: Numbers, sigma: f64) -> PyResult<Self> {
        let shape = axes("accelerations", &readings, "K x N x D")?;
        let readings = matrices(&readings.entries, shape);
        let accelerometers = Accelerometers { readings, sigma };
        compute(py, || self.0.clone().with_accelerometers(accelerometers).map(Self))
    }

    fn without_accelerometers(&self) -> Self {
        Self(self.0.without_accelerometers())
    }

    #[getter]
    fn dimension(&self) -> usize {
        self.0.dimension()
    }

    #[getter]
    fn nodes(&self) -> usize {
        self.0.nodes()
    }

    #[getter]
    fn sigma(&self) -> f64 {
        self.0.sigma()
    }

    #[getter]
    fn sigma_acceleration(&self) -> Option<f64> {
        self.0.accelerometers().map(|each| each.sigma)
    }

    fn stamps<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, &[self.0.stamps().len()], self.0.stamps().iter().copied())
    }

    /// K x P, NaN where missing.
    fn distances<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let stamps = self.0.stamps().len();
        let known =
            (0..stamps).flat_map(|k| self.0.distances(k)).map(|distance| distance.unwrap_or(f64::NAN));
        array(py, &[stamps, pair_count(self.0.nodes())], known)
    }

    /// K x N x D.
    fn accelerations<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(Accelerometers { readings, .. }) = self.0.accelerometers() else { return Ok(None) };
        let shape = [readings.len(), self.0.nodes(), self.0.dimension()];
        array(py, &shape, readings.iter().flatten().copied()).map(Some)
    }

    fn estimate(&self, py: Python<'_>, name: &str, settings: &str) -> PyResult<KinematicsEstimate> {
        let found =
            compute(py, || estimate(name.parse()?, &KinematicsSettings::from_json(settings)?, &self.0))?;
        Ok(KinematicsEstimate { found, dimension: self.0.dimension(), nodes: self.0.nodes() })
    }
}

/// What one estimator found.
#[pyclass(frozen, module = "rangelab._core")]
pub struct KinematicsEstimate {
    found: Inner,
    dimension: usize,
    nodes: usize,
}

#[pymethods]
impl KinematicsEstimate {
    fn motion(&self) -> Option<RelativeKinematics> {
        self.found.kinematics.clone().map(RelativeKinematics)
    }

    fn gram<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        stack(py, self.nodes, &self.found.gram)
    }

    /// K x N x D, NaN where there is none; without stamps from other estimators.
    fn snapshots<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (snapshots, size) = (&self.found.snapshots, self.nodes * self.dimension);
        let numbers = snapshots.iter().flat_map(|snapshot| {
            let entry =
                move |index: usize| snapshot.as_ref().map_or(f64::NAN, |found| found.as_slice()[index]);
            (0..size).map(entry)
        });
        array(py, &[snapshots.len(), self.nodes, self.dimension], numbers)
    }

    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.found.rotation.as_ref().map(|rotation| by_rows(py, rotation)).transpose()
    }

    #[getter]
    fn acceleration_margin(&self) -> Option<f64> {
        self.found.acceleration_margin
    }

    #[getter]
    fn cost(&self) -> f64 {
        self.found.cost
    }

    #[getter]
    fn iterations(&self) -> usize {
        self.found.iterations
    }
}
