//! The Gram matrix as a polynomial of time, \[A\] eqs. 6 to 10 with degree 2L.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::distance_matrix::gram_matrix;
use super::pair_fit::fitted_pairs;
use super::polynomial_fit::{derivatives_of, legendre_sum, powers_of};
use crate::error::{Error, Result};
use crate::model::kinematics::coefficients::{RelativeKinematics, squared_distance};
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::time_scale::TimeScale;

/// What is being computed, for errors.
const WHAT: &str = "the polynomial of the Gram matrix";

/// `G(t) = sum_l B_l t^l`, fitted by unweighted least squares.
///
/// Double centring is linear and the same at each stamp, so it is the squared distances of each pair that are fitted and
/// the few coefficients that are centred: K N (N - 1)/2 numbers are read once, and nothing larger is formed. A pair that
/// misses distances is fitted at the stamps it has.
#[derive(Clone, Debug, PartialEq)]
pub struct GramFit {
    scale: TimeScale,
    /// Of the Legendre polynomials of scaled time, each N x N.
    coefficients: Vec<DMatrix<f64>>,
}

impl GramFit {
    /// Fits a polynomial of this degree, 2L for a motion of degree L.
    ///
    /// # Errors
    /// [`Error::TooFew`] for fewer than two nodes, [`Error::Number`] for distances above 1e30 m, else as [`fitted_pairs`].
    pub fn new(record: &DistanceRecord, degree: usize) -> Result<Self> {
        Self::of(record, degree, |_, _, _| 0.0)
    }

    /// Fits what is left after the squared distances of a known part of the motion, given by derivatives at the middle of
    /// scaled time, are taken away: `G(t) - X_a(t)^T X_a(t)`, for \[A\] eq. 25.
    ///
    /// # Errors
    /// As [`GramFit::new`].
    pub fn less(record: &DistanceRecord, degree: usize, known: &RelativeKinematics) -> Result<Self> {
        let scale = record.time_scale();
        let known: Vec<DMatrix<f64>> =
            record.stamps().iter().map(|&time| known.positions(scale.scaled(time))).collect();
        Self::of(record, degree, |k, i, j| squared_distance(&known[k], i, j))
    }

    fn of(record: &DistanceRecord, degree: usize, part: impl Fn(usize, usize, usize) -> f64) -> Result<Self> {
        let nodes = record.nodes();
        if nodes < 2 {
            let reason = "Distances are measured between two nodes.";
            return Err(Error::TooFew { what: WHAT, counted: "nodes", found: nodes, needed: 2, reason });
        }
        super::small_enough(record)?;
        let squared = |k: usize, (i, j): (usize, usize), distance: f64| distance * distance - part(k, i, j);
        let fitted = fitted_pairs(WHAT, record, degree, squared)?;
        let coefficients = (0..=degree).map(|l| gram_matrix(nodes, fitted.row(l).iter().copied())).collect();
        Ok(Self { scale: record.time_scale(), coefficients })
    }

    /// The fitted Gram matrix at a time (s), N x N, m^2.
    pub fn at(&self, time: f64) -> DMatrix<f64> {
        legendre_sum(&self.coefficients, self.scale.scaled(time))
    }

    /// Coefficients of the powers of scaled time, m^2.
    pub fn scaled_powers(&self) -> Vec<DMatrix<f64>> {
        powers_of(&self.coefficients)
    }

    /// `B_0, B_1, ...`, the coefficients of the powers of time, m^2/s^l.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where they grow beyond all numbers.
    pub fn powers(&self) -> Result<Vec<DMatrix<f64>>> {
        let mut derivatives = derivatives_of(&self.coefficients, &self.scale)?;
        let mut factorial = 1.0;
        for (l, derivative) in derivatives.iter_mut().enumerate() {
            factorial *= l.max(1) as f64;
            *derivative /= factorial;
        }
        Ok(derivatives)
    }
}
