//! Least squares of a polynomial of scaled time, by orthogonal polynomials.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use crate::error::{Error, Result};
use crate::math::legendre::{legendre_powers, legendre_values};
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::time_scale::TimeScale;

/// A diagonal entry of the triangle below this part of the first one: stamps so close that a power is not seen.
const RANK: f64 = 1e-12;

/// What fits polynomials to values at fixed stamps; `T^T T` of \[A\] eq. 10 is never formed, nor is `T`.
#[derive(Clone, Debug)]
pub struct PolynomialFit {
    /// Orthonormal columns, K x (degree + 1).
    orthonormal: DMatrix<f64>,
    /// Takes Legendre coefficients to those of the columns.
    triangle: DMatrix<f64>,
}

impl PolynomialFit {
    /// For values at these scaled stamps.
    ///
    /// # Errors
    /// [`Error::TooFew`] where fewer stamps than coefficients differ, [`Error::Degenerate`] where they nearly do not.
    pub fn new(what: &'static str, stamps: &[f64], degree: usize) -> Result<Self> {
        let mut distinct = stamps.to_vec();
        distinct.sort_by(f64::total_cmp);
        distinct.dedup();
        let (found, needed) = (distinct.len(), degree + 1);
        if found < needed {
            let reason =
                "A polynomial has one coefficient more than its degree, and each takes a stamp of its own.";
            return Err(Error::TooFew { what, counted: "different stamps", found, needed, reason });
        }
        let values: Vec<f64> = stamps.iter().flat_map(|&s| legendre_values(degree, s)).collect();
        let qr = DMatrix::from_row_slice(stamps.len(), needed, &values).qr();
        let triangle = qr.r();
        let least = triangle.diagonal().iter().fold(f64::INFINITY, |least, value| least.min(value.abs()));
        let value = least / triangle[(0, 0)].abs();
        if !(value > RANK) {
            let reason = "The stamps lie so close together that the powers of time look alike.";
            return Err(Error::Degenerate { what, value, reason });
        }
        Ok(Self { orthonormal: qr.q(), triangle })
    }

    /// Legendre coefficients, one column for each column of `values` (K rows).
    pub fn coefficients(&self, values: &DMatrix<f64>) -> DMatrix<f64> {
        let mut solution = self.orthonormal.tr_mul(values);
        let solved = self.triangle.solve_upper_triangular_mut(&mut solution);
        debug_assert!(solved, "the rank was checked");
        solution
    }
}

/// The combination of the coefficients that is the polynomial at a scaled time.
pub fn legendre_sum(coefficients: &[DMatrix<f64>], s: f64) -> DMatrix<f64> {
    let values = legendre_values(coefficients.len() - 1, s);
    combined(coefficients, &DVector::from_vec(values))
}

/// Coefficients of powers of scaled time from those of Legendre polynomials.
pub fn powers_of(coefficients: &[DMatrix<f64>]) -> Vec<DMatrix<f64>> {
    let rows = legendre_powers(coefficients.len() - 1);
    let of_power = |power: usize| {
        let part = |row: &Vec<f64>| row.get(power).copied().unwrap_or(0.0);
        combined(coefficients, &DVector::from_iterator(rows.len(), rows.iter().map(part)))
    };
    (0..coefficients.len()).map(of_power).collect()
}

/// Derivatives by time at time 0 of what has these Legendre coefficients over scaled time.
///
/// # Errors
/// As [`TimeScale::unscale`].
pub fn derivatives_of(coefficients: &[DMatrix<f64>], scale: &TimeScale) -> Result<Vec<DMatrix<f64>>> {
    let mut derivatives = powers_of(coefficients);
    let mut factorial = 1.0;
    for (l, derivative) in derivatives.iter_mut().enumerate() {
        factorial *= l.max(1) as f64;
        *derivative *= factorial;
    }
    Ok(scale.unscale(&RelativeKinematics::from_coefficients(derivatives))?.coefficients().to_vec())
}

fn combined(coefficients: &[DMatrix<f64>], weights: &DVector<f64>) -> DMatrix<f64> {
    let mut sum = DMatrix::zeros(coefficients[0].nrows(), coefficients[0].ncols());
    for (coefficient, &weight) in coefficients.iter().zip(weights.iter()) {
        sum += coefficient * weight;
    }
    sum
}
