//! The older way: a polynomial for the range of each pair, \[A\] ref. 10.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::distance_matrix::gram_matrix;
use super::polynomial_fit::{PolynomialFit, derivatives_of};
use crate::error::Result;
use crate::model::kinematics::distance_record::{DistanceRecord, pair_count};
use crate::model::kinematics::estimate::KinematicsEstimate;

/// What is being computed, for errors.
const WHAT: &str = "the polynomial of a range";

/// `B_0, B_1, B_2` from range, range rate and range acceleration at time 0, each pair fitted by itself without weights:
///
/// ```text
/// B_0 = -1/2 C r^2 C      B_1 = -C (r r') C      B_2 = -1/2 C (r'^2 + r r'') C
/// ```
///
/// A range is no polynomial of time, so a low degree is biased, and a high one noisy.
///
/// # Errors
/// [`crate::Error::TooFew`] where a pair has fewer different stamps than `degree + 1`; [`crate::Error::Degenerate`] where
/// they lie too close.
pub fn range_polynomial(record: &DistanceRecord, degree: usize) -> Result<KinematicsEstimate> {
    super::at_least_nodes(WHAT, record.nodes(), 2, "Distances are measured between two nodes.")?;
    let derivatives = (0..pair_count(record.nodes()))
        .map(|pair| range_derivatives(record, degree, pair))
        .collect::<Result<Vec<[f64; 3]>>>()?;
    let gram =
        |coefficient: fn(&[f64; 3]) -> f64| gram_matrix(record.nodes(), derivatives.iter().map(coefficient));
    let gram = Vec::from([
        gram(|[range, _, _]| range * range),
        gram(|[range, rate, _]| 2.0 * range * rate),
        gram(|[range, rate, acceleration]| rate * rate + range * acceleration),
    ]);
    Ok(KinematicsEstimate { gram, ..KinematicsEstimate::default() })
}

/// Range, its rate and its acceleration at time 0.
fn range_derivatives(record: &DistanceRecord, degree: usize, pair: usize) -> Result<[f64; 3]> {
    let scale = record.time_scale();
    let mut stamps = Vec::with_capacity(record.stamps().len());
    let mut ranges = Vec::with_capacity(record.stamps().len());
    for (k, &time) in record.stamps().iter().enumerate() {
        if let Some(range) = record.distances(k)[pair] {
            stamps.push(scale.scaled(time));
            ranges.push(range);
        }
    }
    let fit = PolynomialFit::new(WHAT, &stamps, degree)?;
    let coefficients = fit.coefficients(&DMatrix::from_vec(ranges.len(), 1, ranges));
    let one = |value: f64| DMatrix::from_element(1, 1, value);
    let legendre: Vec<DMatrix<f64>> = coefficients.column(0).iter().map(|&value| one(value)).collect();
    let derivatives = derivatives_of(&legendre, &scale);
    let at = |l: usize| derivatives.get(l).map_or(0.0, |value| value[(0, 0)]);
    Ok([at(0), at(1), at(2)])
}
