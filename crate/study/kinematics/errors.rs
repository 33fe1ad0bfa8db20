//! How far an estimate of relative kinematics is from the truth.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use crate::error::Result;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::estimate::KinematicsEstimate;
use crate::model::kinematics::gauge::procrustes;
use crate::model::kinematics::{KinematicsScenario, KinematicsSetup};

/// How many coefficients `B_l` of the Gram matrix are compared, those of \[A\] Fig. 1.
pub const GRAM_COEFFICIENTS: usize = 3;

/// The truth of a scenario, which is the same in all trials, made ready to compare with.
#[derive(Clone, Debug, PartialEq)]
pub struct Yardstick {
    motion: RelativeKinematics,
    gram: Vec<DMatrix<f64>>,
    stamps: Vec<f64>,
    /// The instants at which positions are compared, s.
    pub instants: Vec<f64>,
    positions: Vec<DMatrix<f64>>,
}

/// Squared errors, each the mean over coordinates (or over the entries of `vech` for Gram matrices); a list is empty where
/// the estimator does not give what it is about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KinematicsErrors {
    /// Of `Y_0, Y_1, ...`, with **one** alignment in O(D), from `Y_0`; (m/s^l)^2.
    pub coefficients: Vec<f64>,
    /// Of `B_0, B_1, B_2`, (m^2/s^l)^2.
    pub gram: Vec<f64>,
    /// Of the positions at each instant with the same alignment, m^2.
    pub positions: Vec<f64>,
    /// Of the positions at each instant, each aligned by itself, m^2.
    pub aligned_positions: Vec<f64>,
}

impl Yardstick {
    /// The truth of a scenario.
    pub fn new(scenario: &KinematicsScenario, setup: &KinematicsSetup) -> Self {
        let degree = scenario.degree().max(scenario.estimators.degree);
        let motion = setup.motion.centred().with_degree(degree);
        let instants = scenario.instants();
        Self {
            gram: motion.with_degree(degree.max(1)).gram(),
            positions: instants.iter().map(|&time| motion.positions(time)).collect(),
            stamps: setup.stamps.clone(),
            instants,
            motion,
        }
    }

    /// The true motion, centred, with as many coefficients as are compared.
    pub fn motion(&self) -> &RelativeKinematics {
        &self.motion
    }

    /// The errors of an estimate.
    ///
    /// # Errors
    /// [`crate::Error::Number`] for a dimension other than 2 or 3.
    pub fn errors(&self, estimate: &KinematicsEstimate) -> Result<KinematicsErrors> {
        let mut errors = KinematicsErrors::default();
        if let Some(found) = &estimate.kinematics {
            let found = found.aligned_to(&self.motion)?.with_degree(self.motion.degree());
            let pairs = found.coefficients().iter().zip(self.motion.coefficients());
            errors.coefficients = pairs.map(|(found, truth)| mean_square(found, truth)).collect();
            for (&time, truth) in self.instants.iter().zip(&self.positions) {
                let positions = found.positions(time);
                errors.positions.push(mean_square(&positions, truth));
                errors.aligned_positions.push(aligned(&positions, truth)?);
            }
        } else if !estimate.snapshots.is_empty() {
            errors.aligned_positions = self.snapshot_errors(&estimate.snapshots)?;
        }
        errors.gram = self.gram_errors(estimate);
        Ok(errors)
    }

    /// Of `vech(B_l)`; estimators that go another way are measured by the `B_l` of their motion (eq. 7).
    fn gram_errors(&self, estimate: &KinematicsEstimate) -> Vec<f64> {
        let of_motion = || {
            let motion = estimate.kinematics.as_ref()?;
            Some(motion.with_degree(motion.degree().max(1)).gram())
        };
        let own = (!estimate.gram.is_empty()).then(|| estimate.gram.clone());
        let Some(gram) = own.or_else(of_motion) else { return Vec::new() };
        let error = |(found, truth): (&DMatrix<f64>, &DMatrix<f64>)| {
            let nodes = truth.nrows();
            let lower = (0..nodes).flat_map(|j| (j..nodes).map(move |i| (i, j)));
            let squared =
                |entry: (usize, usize)| (found[entry] - truth[entry]) * (found[entry] - truth[entry]);
            lower.map(squared).sum::<f64>() / (nodes * (nodes + 1) / 2) as f64
        };
        gram.iter().zip(&self.gram).take(GRAM_COEFFICIENTS).map(error).collect()
    }

    /// Of the snapshot next to each instant, aligned by itself; none where every epoch misses a distance.
    fn snapshot_errors(&self, snapshots: &[Option<DMatrix<f64>>]) -> Result<Vec<f64>> {
        let found = |(k, snapshot): (usize, &Option<DMatrix<f64>>)| snapshot.clone().map(|found| (k, found));
        let present: Vec<(usize, DMatrix<f64>)> = snapshots.iter().enumerate().filter_map(found).collect();
        let nearest = |instant: f64| {
            let distance = |k: usize| (self.stamps[k] - instant).abs();
            present.iter().min_by(|a, b| distance(a.0).total_cmp(&distance(b.0)))
        };
        let near = self.instants.iter().filter_map(|&instant| nearest(instant));
        near.map(|(k, found)| aligned(found, &self.motion.positions(self.stamps[*k]))).collect()
    }
}

fn mean_square(found: &DMatrix<f64>, truth: &DMatrix<f64>) -> f64 {
    found.iter().zip(truth).map(|(found, truth)| (found - truth) * (found - truth)).sum::<f64>()
        / truth.len() as f64
}

fn aligned(found: &DMatrix<f64>, truth: &DMatrix<f64>) -> Result<f64> {
    Ok(mean_square(&(procrustes(found, truth)? * found), truth))
}
