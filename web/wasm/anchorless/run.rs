//! A run as typed arrays for drawing and plotting.

use nalgebra::DMatrix;
use rangelab::Result;
use rangelab::model::kinematics::coefficients::RelativeKinematics;
use rangelab::model::kinematics::run::{KinematicsEstimatorRun, KinematicsRun, Points};
use rangelab_wasm_shared::json;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// What the estimators made of one trial: K instants, N nodes, D coordinates, node by node. Estimators are numbered as in
/// [`AnchorlessTrial::estimators`].
#[wasm_bindgen]
pub struct AnchorlessTrial {
    run: KinematicsRun,
    truth: RelativeKinematics,
    /// Of each estimator, less the truth; `None` where it finds no motion.
    errors: Vec<Option<RelativeKinematics>>,
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
        self.over_time(&self.truth)
    }

    /// The positions that an estimator found less the truth, after its one alignment at time 0, m: K x N x D; empty where it
    /// finds no motion.
    pub fn errors(&self, estimator: usize) -> Vec<f64> {
        self.errors[estimator].as_ref().map(|errors| self.over_time(errors)).unwrap_or_default()
    }

    /// `Y_l` as an estimator found it less the truth, after its one alignment, m/s^l: N x D; empty where there is none.
    pub fn coefficient_error(&self, estimator: usize, l: usize) -> Vec<f64> {
        let errors = self.errors[estimator].as_ref().and_then(|errors| errors.coefficients().get(l));
        errors.map(|error| error.iter().copied().collect()).unwrap_or_default()
    }

    /// What an estimator of one epoch at a time found less the truth, each aligned by itself: stamps x N x D, NaN where a
    /// distance is missing; empty for others.
    pub fn snapshot_errors(&self, estimator: usize) -> Vec<f64> {
        let size = self.truth.nodes() * self.truth.dimension();
        let snapshots = self.run.estimators[estimator].snapshots.iter().zip(&self.run.stamps);
        let error = |(snapshot, &time): (&Option<Points>, &f64)| match snapshot {
            Some(points) => (matrix(points) - self.truth.positions(time)).iter().copied().collect(),
            None => vec![f64::NAN; size],
        };
        snapshots.flat_map(error).collect()
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
        let truth = motion(&run.truth)?;
        let error = |each: &KinematicsEstimatorRun| {
            if each.coefficients.is_empty() {
                return Ok(None);
            }
            let found = motion(&each.coefficients)?;
            let degree = found.degree().max(truth.degree());
            let (found, truth) = (found.with_degree(degree), truth.with_degree(degree));
            let pairs = found.coefficients().iter().zip(truth.coefficients());
            RelativeKinematics::new(pairs.map(|(found, truth)| found - truth).collect()).map(Some)
        };
        let errors = run.estimators.iter().map(error).collect::<Result<_>>()?;
        Ok(Self { run, truth, errors })
    }

    /// The run that the arrays are read from.
    pub fn document(&self) -> &KinematicsRun {
        &self.run
    }

    fn over_time(&self, motion: &RelativeKinematics) -> Vec<f64> {
        let at = |&time: &f64| -> Vec<f64> { motion.positions(time).data.into() };
        self.run.instants.iter().flat_map(at).collect()
    }
}

fn motion(coefficients: &[Points]) -> Result<RelativeKinematics> {
    RelativeKinematics::new(coefficients.iter().map(matrix).collect())
}

/// Points as columns.
fn matrix(points: &Points) -> DMatrix<f64> {
    DMatrix::from_fn(points[0].len(), points.len(), |i, node| points[node][i])
}
