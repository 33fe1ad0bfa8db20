//! The Gram matrix as a polynomial of time, \[A\] eqs. 6 to 10 with degree 2L.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::distance_matrix::gram_matrix;
use super::polynomial_fit::{PolynomialFit, derivatives_of, legendre_sum, powers_of};
use crate::error::{Error, Result};
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::distance_record::{DistanceRecord, pair_count, pairs};
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
    /// [`Error::TooFew`] where a pair has fewer different stamps than the polynomial has coefficients.
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
        Self::of(record, degree, |k, i, j| (known[k].column(i) - known[k].column(j)).norm_squared())
    }

    fn of(record: &DistanceRecord, degree: usize, part: impl Fn(usize, usize, usize) -> f64) -> Result<Self> {
        let nodes = record.nodes();
        if nodes < 2 {
            let reason = "Distances are measured between two nodes.";
            return Err(Error::TooFew { what: WHAT, counted: "nodes", found: nodes, needed: 2, reason });
        }
        let squared = |k: usize, (i, j): (usize, usize), distance: f64| distance * distance - part(k, i, j);
        let fitted = fitted_pairs(record, degree, squared)?;
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
    pub fn powers(&self) -> Vec<DMatrix<f64>> {
        let mut derivatives = derivatives_of(&self.coefficients, &self.scale);
        let mut factorial = 1.0;
        for (l, derivative) in derivatives.iter_mut().enumerate() {
            factorial *= l.max(1) as f64;
            *derivative /= factorial;
        }
        derivatives
    }
}

/// Legendre coefficients of each pair, (degree + 1) x pairs.
fn fitted_pairs(
    record: &DistanceRecord,
    degree: usize,
    value: impl Fn(usize, (usize, usize), f64) -> f64,
) -> Result<DMatrix<f64>> {
    let scale = record.time_scale();
    let stamps: Vec<f64> = record.stamps().iter().map(|&time| scale.scaled(time)).collect();
    let every = PolynomialFit::new(WHAT, &stamps, degree)?;
    let mut values = DMatrix::zeros(stamps.len(), pair_count(record.nodes()));
    let mut gaps = Vec::new();
    for (pair, nodes) in pairs(record.nodes()).enumerate() {
        let mut complete = true;
        for k in 0..stamps.len() {
            match record.distances(k)[pair] {
                Some(distance) => values[(k, pair)] = value(k, nodes, distance),
                None => complete = false,
            }
        }
        if !complete {
            gaps.push(pair);
        }
    }
    let mut fitted = every.coefficients(&values);
    for pair in gaps {
        let present: Vec<usize> =
            (0..stamps.len()).filter(|&k| record.distances(k)[pair].is_some()).collect();
        let own: Vec<f64> = present.iter().map(|&k| stamps[k]).collect();
        let column = DMatrix::from_fn(own.len(), 1, |row, _| values[(present[row], pair)]);
        let solution = PolynomialFit::new(WHAT, &own, degree)?.coefficients(&column);
        fitted.set_column(pair, &solution.column(0));
    }
    Ok(fitted)
}
