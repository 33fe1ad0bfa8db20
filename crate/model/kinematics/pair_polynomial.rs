//! All distances of one pair, compressed to what they say about a polynomial of degree 2L.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::distance_record::{DistanceRecord, pair_count};
use crate::math::float::{cos, sqrt};

/// The squared distance of a pair over scaled time, a polynomial of degree 2L, as its values at 2L+1 fixed instants.
///
/// Values determine the polynomial as its 2L+1 coefficients do and have their conditioning for free; a model gives them
/// without multiplying polynomials, `m_i = ||x_a(s_i) - x_b(s_i)||^2`. The weighted least-squares cost of all distances of
/// the pair is, up to a constant, `||factor m - target||^2`, with weights `1/(4 d^2 sigma^2 + 2 sigma^4)`, the variance of a
/// squared distance. The factor has as many rows as the pair has distances, at most 2L+1: nothing is solved for, so too few
/// are no special case.
#[derive(Clone, Debug, PartialEq)]
pub struct PairPolynomial {
    /// Upper triangular or trapezoidal, at most (2L+1) x (2L+1), 1/m^2.
    pub factor: DMatrix<f64>,
    /// As many numbers as the factor has rows.
    pub target: DVector<f64>,
}

/// The `count` Chebyshev nodes `cos(pi (m + 1/2)/count)` of scaled time.
pub fn chebyshev_nodes(count: usize) -> Vec<f64> {
    (0..count).map(|m| cos(core::f64::consts::PI * (m as f64 + 0.5) / count as f64)).collect()
}

/// Values at `s` of the polynomials that are 1 at one of the nodes and 0 at the others.
pub fn lagrange_values(nodes: &[f64], s: f64) -> Vec<f64> {
    let value = |i: usize| {
        let others = nodes.iter().enumerate().filter(|(j, _)| *j != i);
        others.fold(1.0, |product, (_, other)| product * (s - other) / (nodes[i] - other))
    };
    (0..nodes.len()).map(value).collect()
}

/// One polynomial for each pair of a record, in the order of [`pairs`](super::distance_record::pairs), at the
/// [`chebyshev_nodes`] of 2L+1.
///
/// A record with `sigma` 0 is weighted as if it were 1: the minimum is the same.
pub fn pair_polynomials(record: &DistanceRecord, degree: usize) -> Vec<PairPolynomial> {
    let nodes = chebyshev_nodes(2 * degree + 1);
    let scale = record.time_scale();
    let rows: Vec<Vec<f64>> =
        record.stamps().iter().map(|&t| lagrange_values(&nodes, scale.scaled(t))).collect();
    (0..pair_count(record.nodes())).map(|pair| compressed(record, &rows, pair)).collect()
}

fn compressed(record: &DistanceRecord, rows: &[Vec<f64>], pair: usize) -> PairPolynomial {
    let sigma = if record.sigma() > 0.0 { record.sigma() } else { 1.0 };
    let measured: Vec<(usize, f64)> =
        (0..rows.len()).filter_map(|k| Some((k, record.distances(k)[pair]?))).collect();
    let columns = rows.first().map_or(0, Vec::len);
    // Scaled rows of the design with their measurement in the last column.
    let mut design = DMatrix::zeros(measured.len(), columns + 1);
    for (row, &(k, distance)) in measured.iter().enumerate() {
        let squared = distance * distance;
        let weight = 1.0 / (sigma * sqrt(4.0 * squared + 2.0 * sigma * sigma));
        for (column, value) in rows[k].iter().enumerate() {
            design[(row, column)] = weight * value;
        }
        design[(row, columns)] = weight * squared;
    }
    let triangle = design.qr().unpack_r();
    let kept = triangle.nrows().min(columns);
    PairPolynomial {
        factor: triangle.view((0, 0), (kept, columns)).into_owned(),
        target: triangle.view((0, columns), (kept, 1)).column(0).into_owned(),
    }
}
