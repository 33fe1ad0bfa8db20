//! The small types of the crate as plain matrices of any size, `theta = vec([Q | t])` column by column.

use nalgebra::{DMatrix, DVector};
use rangelab::math::block::BlockMatrix;
use rangelab::math::pose::Theta;
use rangelab::math::tangent::{TangentMatrix, tangent_dimension};

pub fn vector<const D: usize>(theta: &Theta<D>) -> DVector<f64> {
    DVector::from_fn(D * (D + 1), |k, _| theta.column(k / D)[k % D])
}

pub fn theta<const D: usize>(vector: &DVector<f64>) -> Theta<D> {
    let mut result = Theta::zeros();
    for j in 0..=D {
        result.add_to_column(j, &vector.fixed_rows::<D>(j * D).into_owned());
    }
    result
}

pub fn matrix<const D: usize>(blocks: &BlockMatrix<D>) -> DMatrix<f64> {
    let size = D * (D + 1);
    DMatrix::from_fn(size, size, |i, j| blocks.block(i / D, j / D)[(i % D, j % D)])
}

/// The lower triangle counts.
pub fn blocks<const D: usize>(matrix: &DMatrix<f64>) -> BlockMatrix<D> {
    let mut result = BlockMatrix::zeros();
    for i in 0..=D {
        for j in 0..=i {
            result.set_block(i, j, &matrix.fixed_view::<D, D>(i * D, j * D).into_owned());
        }
    }
    result
}

pub fn tangent<const D: usize>(matrix: &TangentMatrix<D>) -> DMatrix<f64> {
    DMatrix::from_fn(tangent_dimension(D), tangent_dimension(D), |i, j| matrix.entry(i, j))
}

/// `||a - b|| / ||b||` in the Frobenius norm.
pub fn difference(a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
    (a - b).norm() / b.norm()
}

pub fn vector_difference(a: &DVector<f64>, b: &DVector<f64>) -> f64 {
    (a - b).norm() / b.norm()
}
