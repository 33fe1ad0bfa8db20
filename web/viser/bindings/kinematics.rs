//! The Anchorless lab: its scenarios, their trials, and the bound on their motion.

use pyo3::prelude::*;
use rangelab::bounds::kinematics::{Alignment, KinematicsBound as Inner, KinematicsDesign};
use rangelab::model::kinematics;
use rangelab::model::kinematics::presets::{KINEMATICS_PRESETS, kinematics_preset};
use rangelab::simulate::kinematics::simulate_kinematics;
use rangelab::study::kinematics::errors::Yardstick;
use rangelab::study::kinematics::run::run_kinematics;
use rangelab::study::kinematics::spectrum::gram_spectrum;

use crate::array::{Numbers, array};
use crate::compute::compute;
use crate::distances::DistanceRecord;
use crate::documents::json;
use crate::motion::{RelativeKinematics, by_rows};

/// The presets: JSON `[{name, title, summary}]`.
#[pyfunction]
pub fn kinematics_presets() -> String {
    json(&KINEMATICS_PRESETS)
}

/// A valid kinematics scenario.
#[pyclass(frozen, module = "rangelab._core")]
pub struct KinematicsScenario(pub kinematics::KinematicsScenario);

#[pymethods]
impl KinematicsScenario {
    #[new]
    fn new(py: Python<'_>, text: &str) -> PyResult<Self> {
        compute(py, || kinematics::KinematicsScenario::from_json(text).map(Self))
    }

    #[staticmethod]
    fn preset(py: Python<'_>, name: &str) -> PyResult<Self> {
        compute(py, || kinematics_preset(name).map(Self))
    }

    fn to_json(&self) -> String {
        self.0.to_json()
    }

    /// The run as JSON.
    fn run(&self, py: Python<'_>, trial: u64) -> PyResult<String> {
        compute(py, || run_kinematics(&self.0, trial).map(|run| run.to_json()))
    }

    /// The eigenvalues of the Gram matrices of a trial: the JSON of the crate's `GramSpectrum`.
    fn gram_spectrum(&self, py: Python<'_>, trial: u64) -> PyResult<String> {
        compute(py, || gram_spectrum(&self.0, trial).map(|spectrum| json(&spectrum)))
    }

    /// What was measured, the centred truth, and the turn from its frame to that of the accelerometers.
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        trial: u64,
    ) -> PyResult<(DistanceRecord, RelativeKinematics, Bound<'py, PyAny>)> {
        let drawn = compute(py, || simulate_kinematics(&self.0, trial))?;
        let turn = by_rows(py, &drawn.sensor_from_world)?;
        Ok((DistanceRecord(drawn.record), RelativeKinematics(drawn.truth), turn))
    }

    /// At the true motion, from distances alone or with accelerations, of as many coefficients as a study compares.
    fn bound(&self, py: Python<'_>, accelerations: bool) -> PyResult<KinematicsBound> {
        let noise = &self.0.noise;
        compute(py, || {
            let setup = self.0.setup()?;
            let design = if accelerations {
                KinematicsDesign::with_accelerometers(&setup.stamps, noise)
            } else {
                KinematicsDesign::distances(&setup.stamps, noise)
            };
            Inner::new(Yardstick::new(&self.0, &setup).motion(), &design).map(KinematicsBound)
        })
    }
}

/// The Cramér-Rao bound of a motion.
#[pyclass(frozen, module = "rangelab._core")]
pub struct KinematicsBound(Inner);

fn alignment(at_each: bool) -> Alignment {
    if at_each { Alignment::AtEach } else { Alignment::AtZero }
}

#[pymethods]
impl KinematicsBound {
    fn coefficient_rmse(&self, py: Python<'_>, order: usize) -> PyResult<f64> {
        compute(py, || self.0.coefficient_rmse(order))
    }

    fn coefficient_covariance<'py>(&self, py: Python<'py>, order: usize) -> PyResult<Bound<'py, PyAny>> {
        by_rows(py, &compute(py, || self.0.coefficient_covariance(order))?)
    }

    fn gram_rmse(&self, py: Python<'_>, order: usize) -> PyResult<f64> {
        compute(py, || self.0.gram_rmse(order))
    }

    /// A number for each time.
    fn position_rmse<'py>(
        &self,
        py: Python<'py>,
        times: Numbers,
        at_each: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let [at_zero, each] = compute(py, || self.0.position_rmses(&times.entries))?;
        let found = if at_each { each } else { at_zero };
        array(py, &[found.len()], found)
    }

    fn position_covariance<'py>(
        &self,
        py: Python<'py>,
        time: f64,
        at_each: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        by_rows(py, &compute(py, || self.0.position_covariance(time, alignment(at_each)))?)
    }
}
