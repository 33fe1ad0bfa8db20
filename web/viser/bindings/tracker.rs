//! One estimator by itself: over a recording, or step by step with ranges as they come.

use std::sync::{Mutex, PoisonError};

use nalgebra::SVector;
use pyo3::prelude::*;
use rangelab::math::rotation::{AngleMatrix, rotation_angles};
use rangelab::model::epoch::{self, Epoch};
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::motion::Motion;
use rangelab::model::ranges::Ranges;
use rangelab::track::estimator;
use rangelab::track::filter::{Estimator, Step};

use crate::array::{Numbers, array, flags};
use crate::compute::compute;
use crate::recording::{Recording, Typed, estimator_name};

/// Steps of one estimator, flat.
pub struct Track {
    dimension: usize,
    epochs: usize,
    orientations: Vec<f64>,
    positions: Vec<f64>,
    position_covariances: Vec<f64>,
    rotation_covariances: Vec<f64>,
    nis: Vec<f64>,
    events: Vec<bool>,
    failure: Option<(usize, String)>,
}

impl Track {
    fn new(dimension: usize, epochs: usize) -> Self {
        let (coordinates, angles) = (dimension * dimension, rotation_angles(dimension).pow(2));
        Self {
            dimension,
            epochs,
            orientations: Vec::with_capacity(epochs * coordinates),
            positions: Vec::with_capacity(epochs * dimension),
            position_covariances: Vec::with_capacity(epochs * coordinates),
            rotation_covariances: Vec::with_capacity(epochs * angles),
            nis: Vec::with_capacity(epochs),
            events: Vec::with_capacity(epochs),
            failure: None,
        }
    }

    fn push<const D: usize>(&mut self, step: &Step<D>) {
        // Columns of the transpose are rows.
        self.orientations.extend_from_slice(step.posterior.orientation.transpose().as_slice());
        self.positions.extend_from_slice(step.posterior.position.as_slice());
        self.position_covariances.extend_from_slice(step.uncertainty.position_block().transpose().as_slice());
        let covariance = step.rotation_covariance().unwrap_or_else(|_| AngleMatrix::repeat(f64::NAN));
        for row in covariance.row_iter().take(rotation_angles(D)) {
            self.rotation_covariances.extend(row.iter().take(rotation_angles(D)));
        }
        self.nis.push(step.nis.value);
        self.events.push(step.event);
    }
}

/// (orientations, positions, position covariances, rotation covariances, NIS, events, failure).
impl<'py> IntoPyObject<'py> for Track {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Self::Output> {
        let (k, d) = (self.epochs, self.dimension);
        let a = rotation_angles(d);
        let arrays = (
            array(py, &[k, d, d], self.orientations)?,
            array(py, &[k, d], self.positions)?,
            array(py, &[k, d, d], self.position_covariances)?,
            array(py, &[k, a, a], self.rotation_covariances)?,
            array(py, &[k], self.nis)?,
            flags(py, &[k], self.events)?,
            self.failure,
        );
        Ok(arrays.into_pyobject(py)?.into_any())
    }
}

/// An estimator over a recording.
pub fn track<const D: usize>(
    recording: &epoch::Recording<D>,
    name: EstimatorName,
    settings: &EstimatorSettings,
) -> Track {
    let mut filter = estimator(name, settings, recording);
    let mut track = Track::new(D, recording.epochs.len());
    for (k, epoch) in recording.epochs.iter().enumerate() {
        match filter.step(epoch) {
            Ok(step) => track.push(&step),
            Err(error) => {
                track.failure = Some((k, error.to_string()));
                break;
            }
        }
    }
    track
}

enum Filter {
    Plane(Box<dyn Estimator<2> + Send>),
    Space(Box<dyn Estimator<3> + Send>),
}

/// An estimator that waits for the next ranges.
#[pyclass(frozen, module = "rangelab._core")]
pub struct Tracker {
    filter: Mutex<Filter>,
    dimension: usize,
    anchors: usize,
    sensors: usize,
}

#[pymethods]
impl Tracker {
    /// The recording gives anchors, sensors, noise and what is believed before the first epoch; its own epochs are not read.
    #[new]
    fn new(py: Python<'_>, name: &str, settings: &str, recording: &Recording) -> PyResult<Self> {
        let filter = compute(py, || {
            let (name, settings) = (estimator_name(name)?, EstimatorSettings::from_json(settings)?);
            Ok(match &recording.typed {
                Typed::Plane(recording) => Filter::Plane(estimator(name, &settings, recording)),
                Typed::Space(recording) => Filter::Space(estimator(name, &settings, recording)),
            })
        })?;
        let document = &recording.document;
        Ok(Self {
            filter: Mutex::new(filter),
            dimension: document.dimension,
            anchors: document.anchors.len(),
            sensors: document.sensors.len(),
        })
    }

    /// One epoch: squared ranges M x N, NaN where missing; the arrays of a track of one step.
    fn step(
        &self,
        py: Python<'_>,
        interval: f64,
        velocity: Numbers,
        angular_velocity: Numbers,
        squared_ranges: Numbers,
    ) -> PyResult<Track> {
        let axes = rotation_angles(self.dimension);
        let velocity = velocity.shaped("velocity", &[self.dimension])?;
        let turning = angular_velocity.shaped("angular_velocity", &[axes])?;
        let squared = squared_ranges.shaped("squared_ranges", &[self.anchors, self.sensors])?;
        compute(py, || {
            let mut filter = self.filter.lock().unwrap_or_else(PoisonError::into_inner);
            let entry = |m: usize, n: usize| Some(squared[m * self.sensors + n]).filter(|d| !d.is_nan());
            let ranges = Ranges::from_fn(self.anchors, self.sensors, entry)?;
            match &mut *filter {
                Filter::Plane(filter) => advance(&mut **filter, interval, &velocity, &turning, ranges),
                Filter::Space(filter) => advance(&mut **filter, interval, &velocity, &turning, ranges),
            }
        })
    }
}

fn advance<const D: usize>(
    filter: &mut dyn Estimator<D>,
    interval: f64,
    velocity: &[f64],
    turning: &[f64],
    ranges: Ranges,
) -> rangelab::Result<Track> {
    let motion = Motion {
        interval,
        velocity: SVector::from_column_slice(velocity),
        angular_velocity: std::array::from_fn(|i| turning.get(i).copied().unwrap_or(0.0)),
    };
    let mut track = Track::new(D, 1);
    track.push(&filter.step(&Epoch { motion, ranges, true_ranges: None })?);
    Ok(track)
}
