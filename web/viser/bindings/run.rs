//! A run: what estimators and bounds made of a recording, as arrays.

use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use rangelab::math::rotation::rotation_angles;
use rangelab::model::document::entries::PoseEntries;
use rangelab::model::run::{BoundRecord, Failure, StepRecord};

use crate::array::{array, flags};
use crate::compute::compute;
use crate::documents::json;

/// A run; estimators and bounds are numbered as in its document.
#[pyclass(frozen, module = "rangelab._core")]
pub struct Run(pub rangelab::model::run::Run);

/// Name, label, the step at which it stopped or first does not exist, why.
pub type Part<'a> = (&'a str, &'a str, Option<usize>, Option<&'a str>);

fn part<'a>(name: &'a str, label: &'a str, failure: Option<&'a Failure>) -> Part<'a> {
    let (step, message) = failure.map(|failure| (failure.step, failure.message.as_str())).unzip();
    (name, label, step, message)
}

/// A number of a step, by name; NaN where there is none.
fn number_of(step: &StepRecord, name: &str) -> Option<f64> {
    let errors = step.errors;
    match name {
        "orientation_error" => errors.map(|errors| errors.angle),
        "orientation_error_frobenius" => errors.map(|errors| errors.orientation_frobenius),
        "position_error" => errors.map(|errors| errors.position),
        "nees" => step.nees.map(|nees| nees.value),
        "nees_degrees_of_freedom" => step.nees.map(|nees| nees.degrees_of_freedom as f64),
        "nis" => Some(step.nis.value),
        "nis_degrees_of_freedom" => Some(step.nis.degrees_of_freedom as f64),
        "defect" => Some(step.defect),
        "orientation_covariance_trace" => Some(step.covariance_trace.orientation),
        "position_covariance_trace" => Some(step.covariance_trace.position),
        _ => None,
    }
}

/// A pose of a step, by name.
fn pose_of<'a>(step: &'a StepRecord, name: &str) -> &'a PoseEntries {
    match name {
        "prior" => &step.prior,
        "innovation" => &step.innovation,
        _ => &step.posterior,
    }
}

#[pymethods]
impl Run {
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        compute(py, || rangelab::model::run::Run::from_json(text).map(Self))
    }

    fn to_json(&self) -> String {
        self.0.to_json()
    }

    fn to_csv(&self) -> String {
        self.0.to_csv()
    }

    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    #[getter]
    fn dimension(&self) -> usize {
        self.0.dimension
    }

    /// How thin anchors and sensors lie, as JSON.
    fn geometry(&self) -> String {
        json(&self.0.geometry)
    }

    /// Why complete ranges do not show the whole pose, in a sentence.
    #[getter]
    fn unseen(&self) -> Option<&str> {
        self.0.geometry.unseen.as_deref()
    }

    /// The estimators.
    fn estimators(&self) -> Vec<Part<'_>> {
        let parts = self.0.estimators.iter();
        parts.map(|run| part(run.name.name(), &run.label, run.failure.as_ref())).collect()
    }

    /// The bounds.
    fn bounds(&self) -> Vec<Part<'_>> {
        self.0.bounds.iter().map(|run| part(&run.name, &run.label, run.failure.as_ref())).collect()
    }

    fn times<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        array(py, &[self.steps()], self.0.times.iter().copied())
    }

    fn anchors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let anchors = &self.0.anchors;
        array(py, &[anchors.len(), self.0.dimension], anchors.iter().flatten().copied())
    }

    fn sensors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let sensors = &self.0.sensors;
        array(py, &[sensors.len(), self.0.dimension], sensors.iter().flatten().copied())
    }

    /// True where a range was measured: K x M x N.
    fn present<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let shape = [self.steps(), self.0.anchors.len(), self.0.sensors.len()];
        let mut present = vec![true; shape.iter().product()];
        for (k, pairs) in self.0.missing.iter().enumerate() {
            for (m, n) in pairs {
                present[(k * shape[1] + m) * shape[2] + n] = false;
            }
        }
        flags(py, &shape, present)
    }

    fn truth_orientations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let d = self.0.dimension;
        let rows = self.0.truth.iter().map(|pose| pose.as_ref().map(|pose| pose.orientation.concat()));
        padded(py, &[self.steps(), d, d], rows)
    }

    fn truth_positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let rows = self.0.truth.iter().map(|pose| pose.as_ref().map(|pose| pose.position.clone()));
        padded(py, &[self.steps(), self.0.dimension], rows)
    }

    /// `Q` of "prior", "innovation" or "posterior": K x D x D.
    fn orientations<'py>(&self, py: Python<'py>, estimator: usize, of: &str) -> PyResult<Bound<'py, PyAny>> {
        let (d, steps) = (self.0.dimension, self.steps_of(estimator)?);
        padded(py, &[self.steps(), d, d], steps.map(|step| Some(pose_of(step, of).orientation.concat())))
    }

    /// `t` in the same way: K x D.
    fn positions<'py>(&self, py: Python<'py>, estimator: usize, of: &str) -> PyResult<Bound<'py, PyAny>> {
        let (d, steps) = (self.0.dimension, self.steps_of(estimator)?);
        padded(py, &[self.steps(), d], steps.map(|step| Some(pose_of(step, of).position.clone())))
    }

    fn position_covariances<'py>(&self, py: Python<'py>, estimator: usize) -> PyResult<Bound<'py, PyAny>> {
        let (d, steps) = (self.0.dimension, self.steps_of(estimator)?);
        padded(py, &[self.steps(), d, d], steps.map(|step| Some(step.position_covariance.concat())))
    }

    fn rotation_covariances<'py>(&self, py: Python<'py>, estimator: usize) -> PyResult<Bound<'py, PyAny>> {
        let (a, steps) = (rotation_angles(self.0.dimension), self.steps_of(estimator)?);
        let rows = steps.map(|step| step.rotation_covariance.as_ref().map(|rows| rows.concat()));
        padded(py, &[self.steps(), a, a], rows)
    }

    /// A number a step: K, NaN where there is none.
    fn numbers<'py>(&self, py: Python<'py>, estimator: usize, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let numbers = self.steps_of(estimator)?.map(|step| number_of(step, name).unwrap_or(f64::NAN));
        array(py, &[self.steps()], numbers)
    }

    /// Where `Q` was projected: K.
    fn events<'py>(&self, py: Python<'py>, estimator: usize) -> PyResult<Bound<'py, PyAny>> {
        flags(py, &[self.steps()], self.steps_of(estimator)?.map(|step| step.event))
    }

    /// A number a step of a bound: K, NaN where it does not exist.
    fn bound_numbers<'py>(&self, py: Python<'py>, bound: usize, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let read = |record: &BoundRecord| match name {
            "angle_variance" => record.angle_variance.unwrap_or(f64::NAN),
            "orientation_trace" => record.orientation_trace,
            _ => record.position_trace,
        };
        let records = self.records_of(bound)?;
        array(py, &[self.steps()], records.map(|record| record.map_or(f64::NAN, read)))
    }

    fn bound_position_covariances<'py>(&self, py: Python<'py>, bound: usize) -> PyResult<Bound<'py, PyAny>> {
        let d = self.0.dimension;
        let rows =
            self.records_of(bound)?.map(|record| record.map(|record| record.position_covariance.concat()));
        padded(py, &[self.steps(), d, d], rows)
    }

    fn bound_rotation_covariances<'py>(&self, py: Python<'py>, bound: usize) -> PyResult<Bound<'py, PyAny>> {
        let a = rotation_angles(self.0.dimension);
        let rows = self.records_of(bound)?;
        let rows = rows.map(|record| Some(record?.rotation_covariance.as_ref()?.concat()));
        padded(py, &[self.steps(), a, a], rows)
    }
}

impl Run {
    fn steps(&self) -> usize {
        self.0.times.len()
    }

    fn steps_of(&self, estimator: usize) -> PyResult<impl Iterator<Item = &StepRecord>> {
        let run =
            self.0.estimators.get(estimator).ok_or_else(|| PyIndexError::new_err("no such estimator"))?;
        Ok(run.steps.iter())
    }

    fn records_of(&self, bound: usize) -> PyResult<impl Iterator<Item = Option<&BoundRecord>>> {
        let run = self.0.bounds.get(bound).ok_or_else(|| PyIndexError::new_err("no such bound"))?;
        Ok(run.steps.iter().map(Option::as_ref))
    }
}

/// One row of numbers a step; NaN for a row that is missing.
pub fn padded<'py>(
    py: Python<'py>,
    shape: &[usize],
    rows: impl Iterator<Item = Option<Vec<f64>>>,
) -> PyResult<Bound<'py, PyAny>> {
    let width: usize = shape[1..].iter().product();
    array(py, shape, rows.flat_map(|row| row.unwrap_or_else(|| vec![f64::NAN; width])))
}
