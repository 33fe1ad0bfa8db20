//! Eigenvalues of Gram matrices: what classical scaling keeps, and what it leaves as noise.

use alloc::vec::Vec;

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use super::errors::Yardstick;
use crate::anchorless::distance_matrix::gram_matrix;
use crate::anchorless::gram_fit::GramFit;
use crate::anchorless::multidimensional_scaling::classical_scaling;
use crate::error::Result;
use crate::math::factorial::factorial;
use crate::model::kinematics::KinematicsScenario;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::simulate::kinematics::draw;

/// The eigenvalues of one trial, each list decreasing and N long, negative ones too; empty where there is no such matrix.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct GramSpectrum {
    /// Of `-1/2 C D C` of the distances at the complete stamp nearest to time 0, m^2.
    pub epoch: Vec<f64>,
    /// Of the fitted `B_0`, from all stamps, m^2.
    pub fitted: Vec<f64>,
    /// Of the true `Y_0^T Y_0`, m^2.
    pub truth: Vec<f64>,
    /// Of the fitted `(L!)^2 B_(2L)`, the Gram matrix of the highest derivative that is assumed, (m/s^L)^2: from it Algorithm
    /// 1 reads the accelerations.
    pub fitted_top: Vec<f64>,
    /// Of the true `Y_L^T Y_L`, (m/s^L)^2.
    pub truth_top: Vec<f64>,
}

/// The spectra of one trial of a scenario.
///
/// # Errors
/// When the scenario is not valid.
///
/// ```
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::study::kinematics::spectrum::gram_spectrum;
/// let spectrum = gram_spectrum(&kinematics_preset("kinematics-paper")?, 0)?;
/// // Two of ten stand out: the network lies in a plane.
/// assert!(spectrum.fitted[1] > 1000.0 * spectrum.fitted[2].abs());
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn gram_spectrum(scenario: &KinematicsScenario, trial: u64) -> Result<GramSpectrum> {
    let setup = scenario.setup()?;
    let record = draw(scenario, &setup, trial)?.record;
    let yardstick = Yardstick::new(scenario, &setup);
    let (motion, degree) = (yardstick.motion(), scenario.estimators.degree);
    // Where a pair has too few stamps there is no fit; the others stand.
    let powers = GramFit::new(&record, 2 * degree).and_then(|fit| fit.powers()).unwrap_or_default();
    let top = powers.last().map(|power| power * (factorial(degree) * factorial(degree)));
    Ok(GramSpectrum {
        epoch: nearest_epoch(&record),
        fitted: powers.first().map(values).unwrap_or_default(),
        truth: of_derivative(motion, 0),
        fitted_top: top.as_ref().map(values).unwrap_or_default(),
        truth_top: of_derivative(motion, degree),
    })
}

fn values(gram: &DMatrix<f64>) -> Vec<f64> {
    classical_scaling(gram, 1).values
}

fn of_derivative(motion: &RelativeKinematics, l: usize) -> Vec<f64> {
    let coefficient = motion.coefficient(l);
    values(&coefficient.tr_mul(coefficient))
}

fn nearest_epoch(record: &DistanceRecord) -> Vec<f64> {
    let complete = |k: &usize| record.distances(*k).iter().all(Option::is_some);
    let age = |k: &usize| record.stamps()[*k].abs();
    let nearest = (0..record.stamps().len()).filter(complete).min_by(|a, b| age(a).total_cmp(&age(b)));
    let of_stamp = |k: usize| {
        let squared = record.distances(k).iter().flatten().map(|distance| distance * distance);
        values(&gram_matrix(record.nodes(), squared))
    };
    nearest.map(of_stamp).unwrap_or_default()
}
