//! The older way: a polynomial for the range of each pair, \[A\] ref. 10.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::distance_matrix::gram_matrix;
use super::pair_fit::fitted_pairs;
use super::polynomial_fit::derivatives_of;
use crate::error::Result;
use crate::model::kinematics::distance_record::DistanceRecord;
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
/// [`crate::Error::TooFew`] for fewer than two nodes, else as [`fitted_pairs`].
pub fn range_polynomial(record: &DistanceRecord, degree: usize) -> Result<KinematicsEstimate> {
    super::at_least_nodes(WHAT, record.nodes(), 2, "Distances are measured between two nodes.")?;
    let fitted = fitted_pairs(WHAT, record, degree, |_, _, range| range)?;
    let row = |l: usize| DMatrix::from_iterator(1, fitted.ncols(), fitted.row(l).iter().copied());
    let derivatives = derivatives_of(&(0..=degree).map(row).collect::<Vec<_>>(), &record.time_scale())?;
    let at = |l: usize, pair: usize| derivatives.get(l).map_or(0.0, |values| values[pair]);
    let gram = |coefficient: fn([f64; 3]) -> f64| {
        let of_pair = |pair| coefficient([at(0, pair), at(1, pair), at(2, pair)]);
        gram_matrix(record.nodes(), (0..fitted.ncols()).map(of_pair))
    };
    let gram = Vec::from([
        gram(|[range, _, _]| range * range),
        gram(|[range, rate, _]| 2.0 * range * rate),
        gram(|[range, rate, acceleration]| rate * rate + range * acceleration),
    ]);
    Ok(KinematicsEstimate { gram, ..KinematicsEstimate::default() })
}
