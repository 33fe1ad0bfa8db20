//! A polynomial of time for what each pair measured.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::polynomial_fit::PolynomialFit;
use crate::error::{Error, Result};
use crate::model::kinematics::distance_record::{DistanceRecord, pair_count, pairs};

/// Legendre coefficients over scaled time of a value of every distance, fitted by unweighted least squares: (degree + 1) x
/// pairs, in the order of [`pairs`]. `value` takes the number of the stamp, the nodes and the distance (m).
///
/// Pairs without gaps share one factorization; one that misses distances is fitted at the stamps it has.
///
/// # Errors
/// [`Error::TooFew`] where fewer stamps than the polynomial has coefficients differ, [`Error::PairTooFew`] where it is those
/// of one pair; [`Error::Degenerate`] where they lie too close.
pub fn fitted_pairs(
    what: &'static str,
    record: &DistanceRecord,
    degree: usize,
    value: impl Fn(usize, (usize, usize), f64) -> f64,
) -> Result<DMatrix<f64>> {
    let scale = record.time_scale();
    let stamps: Vec<f64> = record.stamps().iter().map(|&time| scale.scaled(time)).collect();
    let every = PolynomialFit::new(what, &stamps, degree)?;
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
            gaps.push((pair, nodes));
        }
    }
    let mut fitted = every.coefficients(&values);
    for (pair, nodes) in gaps {
        let present: Vec<usize> =
            (0..stamps.len()).filter(|&k| record.distances(k)[pair].is_some()).collect();
        let own: Vec<f64> = present.iter().map(|&k| stamps[k]).collect();
        let column = DMatrix::from_fn(own.len(), 1, |row, _| values[(present[row], pair)]);
        let fit = PolynomialFit::new(what, &own, degree).map_err(|error| of_pair(error, nodes))?;
        fitted.set_column(pair, &fit.coefficients(&column).column(0));
    }
    Ok(fitted)
}

/// The stamps that are too few are those of one pair, and it is said of which.
fn of_pair(error: Error, pair: (usize, usize)) -> Error {
    match error {
        Error::TooFew { what, found, needed, .. } => Error::PairTooFew { what, pair, found, needed },
        other => other,
    }
}
