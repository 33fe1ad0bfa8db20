//! A run as typed arrays for drawing and plotting.

use rangelab::model::document::entries::PoseEntries;
use rangelab::model::indoor::epoch::IndoorRecording;
use rangelab::model::indoor::run::{IndoorFailure, IndoorFilterRun, IndoorRun, IndoorStepRecord};
use rangelab_wasm_shared::{Named, json, padded};
use wasm_bindgen::prelude::*;

/// What the filters made of one trial: K steps, M beacons, N = 3 transmitters, matrices row by row. Filters are numbered
/// as in [`IndoorTrial::filters`]. NaN stands where there is no number: steps after a failure.
#[wasm_bindgen]
pub struct IndoorTrial {
    run: IndoorRun,
    present: Vec<u8>,
}

#[wasm_bindgen]
impl IndoorTrial {
    /// Time at the end of each step, s: K.
    pub fn times(&self) -> Vec<f64> {
        self.run.times.clone()
    }

    /// Positions of the beacons, m: M x 3.
    pub fn beacons(&self) -> Vec<f64> {
        self.run.beacons.concat()
    }

    /// 1 where a range was measured at the end of a step, else 0: K x M x N.
    pub fn present(&self) -> Vec<u8> {
        self.present.clone()
    }

    /// 1 where ranges were taken at the end of a step, else 0: K.
    pub fn fixes(&self) -> Vec<u8> {
        self.run.fixes.iter().copied().map(u8::from).collect()
    }

    /// True orientations: K x 3 x 3.
    pub fn truth_orientations(&self) -> Vec<f64> {
        self.truth(9, orientation)
    }

    /// True positions, m: K x 3.
    pub fn truth_positions(&self) -> Vec<f64> {
        self.truth(3, position)
    }

    /// The filters: JSON `[{name, label}]`.
    pub fn filters(&self) -> String {
        let names = self.run.filters.iter();
        json(&names.map(|each| Named { name: each.name.name(), label: &each.label }).collect::<Vec<_>>())
    }

    /// `R` of a filter as it keeps it, which need not be a rotation: K x 3 x 3.
    pub fn orientations(&self, filter: usize) -> Vec<f64> {
        self.steps_of(filter, 9, |step, to| orientation(&step.pose, to))
    }

    /// Positions of a filter, m: K x 3.
    pub fn positions(&self, filter: usize) -> Vec<f64> {
        self.steps_of(filter, 3, |step, to| position(&step.pose, to))
    }

    /// Geodesic angles to the truth, rad: K.
    pub fn orientation_errors(&self, filter: usize) -> Vec<f64> {
        self.number(filter, |step| step.angle_error)
    }

    /// Distances to the truth, m: K.
    pub fn position_errors(&self, filter: usize) -> Vec<f64> {
        self.number(filter, |step| step.position_error)
    }

    /// Normalized estimation errors squared over their 9 degrees of freedom: K.
    pub fn nees(&self, filter: usize) -> Vec<f64> {
        self.number(filter, |step| step.nees)
    }

    /// Root mean square distance to the truth over the steps, m; 0 without any.
    pub fn rms_position_error(&self, filter: usize) -> f64 {
        self.filter(filter).rms_position_error()
    }

    /// Root mean square geodesic angle to the truth over the steps, rad; 0 without any.
    pub fn rms_angle_error(&self, filter: usize) -> f64 {
        self.filter(filter).rms_angle_error()
    }

    /// Mean NEES over its 9 degrees of freedom; 0 without steps.
    pub fn mean_nees(&self, filter: usize) -> f64 {
        self.filter(filter).mean_nees()
    }

    /// Singular values of `R`, decreasing, all 1 for a rotation: K x 3.
    pub fn singular_values(&self, filter: usize) -> Vec<f64> {
        self.steps_of(filter, 3, |step, to| to.extend(step.singular_values))
    }

    /// Covariances of the position, m^2: K x 3 x 3.
    pub fn position_covariances(&self, filter: usize) -> Vec<f64> {
        self.steps_of(filter, 9, |step, to| to.extend(step.position_covariance.iter().flatten()))
    }

    /// Covariances of the error's rotation vector in the world frame, rad^2: K x 3 x 3.
    pub fn rotation_covariances(&self, filter: usize) -> Vec<f64> {
        self.steps_of(filter, 9, |step, to| to.extend(step.rotation_covariance.iter().flatten()))
    }

    /// How many times the covariance was replaced by the nearest positive definite one.
    pub fn repairs(&self, filter: usize) -> usize {
        self.filter(filter).steps.iter().map(|step| step.repairs).sum()
    }

    /// The step at which a filter failed, or -1.
    pub fn failed_at(&self, filter: usize) -> i32 {
        self.failure_of(filter).map_or(-1, |failure| i32::try_from(failure.step).unwrap_or(i32::MAX))
    }

    /// Why it failed, or nothing.
    pub fn failure(&self, filter: usize) -> String {
        self.failure_of(filter).map(|failure| failure.message.clone()).unwrap_or_default()
    }
}

impl IndoorTrial {
    /// The run over a recording.
    pub fn new(run: IndoorRun, recording: &IndoorRecording) -> Self {
        let beacons = run.beacons.len();
        let present =
            recording.epochs.iter().flat_map(|epoch| epoch.present(beacons)).map(u8::from).collect();
        Self { run, present }
    }

    /// The run that the arrays are read from.
    pub fn document(&self) -> &IndoorRun {
        &self.run
    }

    fn filter(&self, index: usize) -> &IndoorFilterRun {
        &self.run.filters[index]
    }

    fn failure_of(&self, index: usize) -> Option<&IndoorFailure> {
        self.filter(index).failure.as_ref()
    }

    fn truth(&self, width: usize, write: impl Fn(&PoseEntries, &mut Vec<f64>)) -> Vec<f64> {
        padded(self.run.times.len(), width, self.run.truth.iter().map(Some), write)
    }

    fn steps_of(
        &self,
        filter: usize,
        width: usize,
        write: impl Fn(&IndoorStepRecord, &mut Vec<f64>),
    ) -> Vec<f64> {
        padded(self.run.times.len(), width, self.filter(filter).steps.iter().map(Some), write)
    }

    fn number(&self, filter: usize, read: impl Fn(&IndoorStepRecord) -> f64) -> Vec<f64> {
        self.steps_of(filter, 1, |step, to| to.push(read(step)))
    }
}

fn orientation(pose: &PoseEntries, to: &mut Vec<f64>) {
    to.extend(pose.orientation.iter().flatten());
}

fn position(pose: &PoseEntries, to: &mut Vec<f64>) {
    to.extend(&pose.position);
}
