//! Snapshot estimators: the pose from one epoch alone.

use pyo3::prelude::*;
use rangelab::Error;
use rangelab::localize::{Estimate, Snapshot};
use rangelab::math::pose::Theta;
use rangelab::model::epoch;
use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName};
use rangelab::study::localization::run;

use crate::array::array;
use crate::compute::compute;
use crate::documents::{Scenario, json};
use crate::recording::{Recording, Typed};

/// What a scenario's localizers make of the first epoch of a trial: JSON of the crate's `SnapshotRun`.
#[pyfunction]
pub fn localize(py: Python<'_>, scenario: &Scenario, trial: u64) -> PyResult<String> {
    compute(py, || Ok(json(&run::localize_trial(&scenario.0, trial)?)))
}

/// The estimates of trials `first..first + trials`: trials x localizers x (3 + D (D + 1)).
#[pyfunction]
pub fn localization_cloud<'py>(
    py: Python<'py>,
    scenario: &Scenario,
    first: u64,
    trials: u64,
) -> PyResult<Bound<'py, PyAny>> {
    let cloud = compute(py, || run::localization_cloud(&scenario.0, first, trials))?;
    let width = run::cloud_stride(scenario.0.dimension);
    let localizers = scenario.0.localize.enabled.len();
    array(py, &[cloud.len() / (width * localizers).max(1), localizers, width], cloud)
}

/// Orientation and position, iterations, whether the body is mirrored, what is known of the optimum.
type Found<T> = (Option<(T, T)>, usize, bool, &'static str);

/// One localizer on one epoch of a recording, with the choices of a scenario.
#[pyfunction]
pub fn localize_recording<'py>(
    py: Python<'py>,
    recording: &Recording,
    epoch: usize,
    name: &str,
    scenario: &Scenario,
) -> PyResult<Found<Bound<'py, PyAny>>> {
    let (settings, mounting_sigma) = (&scenario.0.localize, scenario.0.mounting_sigma);
    let (pose, iterations, reflected, optimum) = compute(py, || {
        let name = localizer_name(name)?;
        match &recording.typed {
            Typed::Plane(recording) => found(recording, epoch, name, settings, mounting_sigma),
            Typed::Space(recording) => found(recording, epoch, name, settings, mounting_sigma),
        }
    })?;
    let d = recording.document.dimension;
    let arrays = |(q, t)| PyResult::Ok((array(py, &[d, d], q)?, array(py, &[d], t)?));
    Ok((pose.map(arrays).transpose()?, iterations, reflected, optimum))
}

fn found<const D: usize>(
    recording: &epoch::Recording<D>,
    epoch: usize,
    name: LocalizerName,
    settings: &LocalizeSettings,
    mounting_sigma: f64,
) -> rangelab::Result<Found<Vec<f64>>> {
    let expected = recording.epochs.len();
    let Some(epoch) = recording.epochs.get(epoch) else {
        return Err(Error::Size { what: "is the epoch asked for", found: epoch, expected });
    };
    let snapshot = Snapshot::new(&recording.model, &epoch.ranges, epoch.weight_ranges())?;
    let estimate = rangelab::localize::localize(name, &snapshot, settings, mounting_sigma)?;
    let Estimate { theta, iterations, reflected, optimum } = estimate;
    // Columns of the transpose are rows.
    let entries = |Theta { orientation, position }: Theta<D>| {
        (orientation.transpose().as_slice().to_vec(), position.as_slice().to_vec())
    };
    Ok((theta.map(entries), iterations, reflected, optimum.name()))
}

fn localizer_name(name: &str) -> rangelab::Result<LocalizerName> {
    let known = || LocalizerName::ALL.map(LocalizerName::name).join(", ");
    LocalizerName::ALL.into_iter().find(|each| each.name() == name).ok_or_else(|| Error::UnknownName {
        what: "localizer",
        name: name.to_owned(),
        known: known(),
    })
}
