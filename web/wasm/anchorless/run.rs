//! A run as typed arrays for drawing and plotting.

use rangelab::Result;
use rangelab::model::kinematics::coefficients::RelativeKinematics;
use rangelab::model::kinematics::run::{KinematicsEstimatorRun, KinematicsRun};
use rangelab::study::kinematics::deviations::KinematicsDeviations;
use rangelab_wasm_shared::json;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// What the estimators made of one trial: K instants, N nodes, D coordinates, node by node. Estimators are numbered as in
/// [`AnchorlessTrial::estimators`].
#[wasm_bindgen]
pub struct AnchorlessTrial {
    run: KinematicsRun,
    deviations: KinematicsDeviations,
}

/// What the page reads of an estimator beside its arrays.
#[derive(Serialize)]
struct Told<'a> {
    name: &'a str,
    label: &'a str,
    failure: &'a Option<String>,
    coefficient_errors: &'a [f64],
    gram_errors: &'a [f64],
    acceleration_margin: Option<f64>,
    iterations: usize,
}

impl<'a> Told<'a> {
    fn of(each: &'a KinematicsEstimatorRun) -> Self {
        Self {
            name: each.name.name(),
            label: &each.label,
            failure: &each.failure,
            coefficient_errors: &each.coefficient_errors,
            gram_errors: &each.gram_errors,
            acceleration_margin: each.acceleration_margin,
            iterations: each.iterations,
        }
    }
}

#[wasm_bindgen]
impl AnchorlessTrial {
    /// The instants at which the motion is played, s: K.
    pub fn times(&self) -> Vec<f64> {
        self.run.instants.clone()
    }

    /// How many distances are missing.
    pub fn missing(&self) -> usize {
        self.run.missing
    }

    /// The estimators: JSON `[{name, label, failure, coefficient_errors, gram_errors, acceleration_margin, iterations}]`.
    pub fn estimators(&self) -> String {
        json(&self.run.estimators.iter().map(Told::of).collect::<Vec<_>>())
    }

    /// The true positions, centred, m: K x N x D.
    pub fn truth(&self) -> Vec<f64> {
        self.over_time(&self.deviations.truth)
    }

    /// The positions that an estimator found less the truth, after its one alignment at time 0, m: K x N x D; empty where it
    /// finds no motion.
    pub fn errors(&self, estimator: usize) -> Vec<f64> {
        self.motion(estimator).map(|errors| self.over_time(errors)).unwrap_or_default()
    }

    /// `Y_l` as an estimator found it less the truth, after its one alignment, m/s^l: N x D; empty where there is none.
    pub fn coefficient_error(&self, estimator: usize, l: usize) -> Vec<f64> {
        let error = self.motion(estimator).and_then(|errors| errors.coefficients().get(l));
        error.map(|error| error.iter().copied().collect()).unwrap_or_default()
    }

    /// What an estimator of one epoch at a time found less the truth, each aligned by itself: stamps x N x D, NaN where a
    /// distance is missing; empty for others.
    pub fn snapshot_errors(&self, estimator: usize) -> Vec<f64> {
        let truth = &self.deviations.truth;
        let missing = vec![f64::NAN; truth.nodes() * truth.dimension()];
        let snapshots = self.deviations.estimators[estimator].snapshots.iter();
        snapshots
            .flat_map(|off| off.as_ref().map_or(missing.as_slice(), |off| off.as_slice()))
            .copied()
            .collect()
    }

    /// The stamps, s.
    pub fn stamps(&self) -> Vec<f64> {
        self.run.stamps.clone()
    }

    /// Root mean square error of a coordinate at each instant after one alignment at time 0, m: K, or empty.
    pub fn position_errors(&self, estimator: usize) -> Vec<f64> {
        self.run.estimators[estimator].position_errors.clone()
    }

    /// The same with an alignment at each instant, m: K, or empty.
    pub fn aligned_position_errors(&self, estimator: usize) -> Vec<f64> {
        self.run.estimators[estimator].aligned_position_errors.clone()
    }
}

impl AnchorlessTrial {
    /// The arrays of a run.
    ///
    /// # Errors
    /// Never for a run of the crate.
    pub fn new(run: KinematicsRun) -> Result<Self> {
        Ok(Self { deviations: KinematicsDeviations::of(&run)?, run })
    }

    /// The run that the arrays are read from.
    pub fn document(&self) -> &KinematicsRun {
        &self.run
    }

    fn motion(&self, estimator: usize) -> Option<&RelativeKinematics> {
        self.deviations.estimators[estimator].motion.as_ref()
    }

    fn over_time(&self, motion: &RelativeKinematics) -> Vec<f64> {
        let at = |&time: &f64| -> Vec<f64> { motion.positions(time).data.into() };
        self.run.instants.iter().flat_map(at).collect()
    }
}
