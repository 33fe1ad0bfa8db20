//! How a cloud of points fills its space: the geometry behind "this cannot be seen".

use nalgebra::{SMatrix, SVector};

use crate::math::float::sqrt;
use crate::math::singular::singular;

/// Centroid and principal extents of a cloud of points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread<const D: usize> {
    /// Mean of the points, m.
    pub centroid: SVector<f64, D>,
    /// Singular values of the centred points, decreasing, m.
    pub singular_values: [f64; D],
    /// Principal directions, one a column, in the order of the singular values.
    pub directions: SMatrix<f64, D, D>,
}

/// Below this part of the largest singular value a direction counts as missing.
pub const RANK_TOLERANCE: f64 = 1e-9;

impl<const D: usize> Spread<D> {
    /// Measures a cloud of at least one point.
    ///
    /// The singular values come from a QR factorization, so that the least one keeps its digits.
    pub fn of(points: &[SVector<f64, D>]) -> Self {
        let centroid = points.iter().fold(SVector::zeros(), |sum, p| sum + p) / points.len() as f64;
        let triangle = triangular_factor(points, &centroid);
        let s = singular(&triangle);
        Self { centroid, singular_values: s.values, directions: s.right }
    }

    /// Number of directions in which the points extend.
    pub fn rank(&self) -> usize {
        let floor = RANK_TOLERANCE * self.singular_values[0];
        self.singular_values.iter().filter(|&&value| value > floor).count()
    }

    /// Largest over least singular value; infinite where the rank is deficient.
    pub fn condition(&self) -> f64 {
        self.singular_values[0] / self.singular_values[D - 1]
    }

    /// Largest distance of a point from the flat of so many dimensions (1: line, 2: plane) through the centroid that fits
    /// the points best, m.
    pub fn thickness(&self, points: &[SVector<f64, D>], dimensions: usize) -> f64 {
        let squared_distance = |p: &SVector<f64, D>| {
            let lever = p - self.centroid;
            (dimensions..D).map(|k| lever.dot(&self.directions.column(k))).map(|x| x * x).sum()
        };
        sqrt(points.iter().map(squared_distance).fold(0.0, f64::max))
    }
}

/// Singular values of points about a place, decreasing.
pub(crate) fn singular_values<const D: usize>(
    points: &[SVector<f64, D>],
    about: &SVector<f64, D>,
) -> [f64; D] {
    singular(&triangular_factor(points, about)).values
}

/// The triangular factor of the centred points, by Givens rotations row by row: no buffer of the size of the cloud.
fn triangular_factor<const D: usize>(
    points: &[SVector<f64, D>],
    centroid: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let mut triangle = SMatrix::<f64, D, D>::zeros();
    for point in points {
        let mut row = point - centroid;
        for k in 0..D {
            let (a, b) = (triangle[(k, k)], row[k]);
            let length = sqrt(a * a + b * b);
            if length == 0.0 {
                continue;
            }
            let (c, s) = (a / length, b / length);
            for j in k..D {
                let (x, y) = (triangle[(k, j)], row[j]);
                triangle[(k, j)] = c * x + s * y;
                row[j] = c * y - s * x;
            }
        }
    }
    triangle
}
