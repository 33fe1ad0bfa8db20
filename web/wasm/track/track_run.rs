//! A run as typed arrays for drawing and plotting.

use rangelab::math::float::sqrt;
use rangelab::math::rotation::rotation_angles;
use rangelab::model::document::entries::PoseEntries;
use rangelab::model::run::{BoundRecord, BoundRun, EstimatorRun, Run, StepRecord};
use rangelab_wasm_shared::{Named, json, padded};
use wasm_bindgen::prelude::*;

/// What the estimators and bounds made of one recording: K steps, D dimensions, matrices row by row. Estimators and
/// bounds are numbered as in [`TrackRun::estimators`] and [`TrackRun::bounds`]. NaN stands where there is no number:
/// steps after a failure, errors without truth, bounds that do not exist.
#[wasm_bindgen]
pub struct TrackRun(Run);

impl From<Run> for TrackRun {
    fn from(run: Run) -> Self {
        Self(run)
    }
}

#[wasm_bindgen]
impl TrackRun {
    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        self.0.dimension
    }

    /// Number of steps K.
    pub fn steps(&self) -> usize {
        self.0.times.len()
    }

    /// Time of each step, s: K.
    pub fn times(&self) -> Vec<f64> {
        self.0.times.clone()
    }

    /// The anchors that were used, m: M x D.
    pub fn anchors(&self) -> Vec<f64> {
        self.0.anchors.concat()
    }

    /// 1 where a range was measured, else 0: K x M x N.
    pub fn present(&self) -> Vec<u8> {
        let (anchors, sensors) = (self.0.anchors.len(), self.0.sensors.len());
        let mut present = vec![1; self.steps() * anchors * sensors];
        for (k, pairs) in self.0.missing.iter().enumerate() {
            for (m, n) in pairs {
                present[(k * anchors + m) * sensors + n] = 0;
            }
        }
        present
    }

    /// How anchors and sensors lie: the JSON of the crate's `Geometry`.
    pub fn geometry(&self) -> String {
        json(&self.0.geometry)
    }

    /// True orientations: K x D x D.
    pub fn truth_orientations(&self) -> Vec<f64> {
        self.truth(self.0.dimension * self.0.dimension, |pose, to| {
            to.extend(pose.orientation.iter().flatten());
        })
    }

    /// True positions, m: K x D.
    pub fn truth_positions(&self) -> Vec<f64> {
        self.truth(self.0.dimension, |pose, to| to.extend(&pose.position))
    }

    /// The estimators: JSON `[{name, label}]`.
    pub fn estimators(&self) -> String {
        let names = self.0.estimators.iter();
        json(&names.map(|each| Named { name: each.name.name(), label: &each.label }).collect::<Vec<_>>())
    }

    /// Orientations of an estimator: K x D x D.
    pub fn orientations(&self, estimator: usize) -> Vec<f64> {
        self.steps_of(estimator, self.0.dimension * self.0.dimension, |step, to| {
            to.extend(step.posterior.orientation.iter().flatten());
        })
    }

    /// Positions of an estimator, m: K x D.
    pub fn positions(&self, estimator: usize) -> Vec<f64> {
        self.steps_of(estimator, self.0.dimension, |step, to| to.extend(&step.posterior.position))
    }

    /// Geodesic angles to the truth, rad: K.
    pub fn orientation_errors(&self, estimator: usize) -> Vec<f64> {
        self.number(estimator, |step| step.errors.map(|errors| errors.angle))
    }

    /// Distances to the truth, m: K.
    pub fn position_errors(&self, estimator: usize) -> Vec<f64> {
        self.number(estimator, |step| step.errors.map(|errors| errors.position))
    }

    /// `||Q^T Q - I||_F` before any projection: K.
    pub fn defects(&self, estimator: usize) -> Vec<f64> {
        self.number(estimator, |step| Some(step.defect))
    }

    /// 1 where `Q` was projected, else 0: K.
    pub fn events(&self, estimator: usize) -> Vec<u8> {
        let mut events: Vec<u8> =
            self.estimator(estimator).steps.iter().map(|step| u8::from(step.event)).collect();
        events.resize(self.steps(), 0);
        events
    }

    /// Normalized estimation errors squared: K.
    pub fn nees(&self, estimator: usize) -> Vec<f64> {
        self.number(estimator, |step| step.nees.map(|nees| nees.value))
    }

    /// Normalized innovations squared: K.
    pub fn nis(&self, estimator: usize) -> Vec<f64> {
        self.number(estimator, |record| Some(record.nis.value))
    }

    /// Degrees of freedom of the NIS: K. Missing ranges lower them; 0 without ranges and after a failure.
    pub fn nis_degrees_of_freedom(&self, estimator: usize) -> Vec<u32> {
        let degrees = |record: &StepRecord| u32::try_from(record.nis.degrees_of_freedom).unwrap_or(u32::MAX);
        let mut all: Vec<u32> = self.estimator(estimator).steps.iter().map(degrees).collect();
        all.resize(self.steps(), 0);
        all
    }

    /// Degrees of freedom of the NEES; 0 where there is none.
    pub fn nees_degrees_of_freedom(&self, estimator: usize) -> usize {
        let nees = self.estimator(estimator).steps.iter().find_map(|step| step.nees);
        nees.map_or(0, |nees| nees.degrees_of_freedom)
    }

    /// Covariances of the error's rotation vector in the world frame, rad^2: K x A x A, A = 3 in space, 1 in the plane.
    pub fn rotation_covariances(&self, estimator: usize) -> Vec<f64> {
        self.steps_of(estimator, self.angles() * self.angles(), |step, to| {
            to.extend(step.rotation_covariance.iter().flatten().flatten());
        })
    }

    /// Covariances of the position, m^2: K x D x D.
    pub fn position_covariances(&self, estimator: usize) -> Vec<f64> {
        self.steps_of(estimator, self.0.dimension * self.0.dimension, |step, to| {
            to.extend(step.position_covariance.iter().flatten());
        })
    }

    /// The step at which an estimator failed, or -1.
    pub fn failed_at(&self, estimator: usize) -> i32 {
        let failure = self.estimator(estimator).failure.as_ref();
        failure.map_or(-1, |failure| i32::try_from(failure.step).unwrap_or(i32::MAX))
    }

    /// Why it failed, or nothing.
    pub fn failure(&self, estimator: usize) -> String {
        let failure = self.estimator(estimator).failure.as_ref();
        failure.map(|failure| failure.message.clone()).unwrap_or_default()
    }

    /// The bounds: JSON `[{name, label}]`.
    pub fn bounds(&self) -> String {
        let names = self.0.bounds.iter();
        json(&names.map(|BoundRun { name, label, .. }| Named { name, label }).collect::<Vec<_>>())
    }

    /// A bound on the root mean square rotation angle, rad: K.
    pub fn orientation_bounds(&self, bound: usize) -> Vec<f64> {
        self.bounds_of(bound, 1, |record, to| to.push(record.angle_variance.map_or(f64::NAN, sqrt)))
    }

    /// A bound on the root mean square error of the position, m: K.
    pub fn position_bounds(&self, bound: usize) -> Vec<f64> {
        self.bounds_of(bound, 1, |record, to| to.push(sqrt(record.position_trace)))
    }

    /// A bound on the covariance of the position, m^2: K x D x D.
    pub fn position_bound_covariances(&self, bound: usize) -> Vec<f64> {
        self.bounds_of(bound, self.0.dimension * self.0.dimension, |record, to| {
            to.extend(record.position_covariance.iter().flatten());
        })
    }

    /// A bound on the covariance of the error's rotation vector in the world frame, rad^2: K x A x A.
    pub fn rotation_bound_covariances(&self, bound: usize) -> Vec<f64> {
        self.bounds_of(bound, self.angles() * self.angles(), |record, to| {
            to.extend(record.rotation_covariance.iter().flatten().flatten());
        })
    }
}

impl TrackRun {
    /// The run that the arrays are read from.
    pub fn document(&self) -> &Run {
        &self.0
    }

    fn angles(&self) -> usize {
        rotation_angles(self.0.dimension)
    }

    fn estimator(&self, index: usize) -> &EstimatorRun {
        &self.0.estimators[index]
    }

    fn truth(&self, width: usize, write: impl Fn(&PoseEntries, &mut Vec<f64>)) -> Vec<f64> {
        padded(self.steps(), width, self.0.truth.iter().map(Option::as_ref), write)
    }

    fn steps_of(
        &self,
        estimator: usize,
        width: usize,
        write: impl Fn(&StepRecord, &mut Vec<f64>),
    ) -> Vec<f64> {
        padded(self.steps(), width, self.estimator(estimator).steps.iter().map(Some), write)
    }

    fn number(&self, estimator: usize, read: impl Fn(&StepRecord) -> Option<f64>) -> Vec<f64> {
        self.steps_of(estimator, 1, |step, to| to.push(read(step).unwrap_or(f64::NAN)))
    }

    fn bounds_of(&self, bound: usize, width: usize, write: impl Fn(&BoundRecord, &mut Vec<f64>)) -> Vec<f64> {
        padded(self.steps(), width, self.0.bounds[bound].steps.iter().map(Option::as_ref), write)
    }
}
