//! The second stage made linear: `H`, `P = H Omega_2` and `Omega` as free unknowns.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::SecondStage;
use super::lyapunov::{Sides, skew, skew_entries};
use crate::error::{Error, Result};
use crate::math::orthogonal::nearest_orthogonal;

/// A diagonal entry of the triangle below this part of the largest: an unknown is not seen.
const RANK: f64 = 1e-10;

/// Both equations solved up to a skew matrix each, `Y_1 = Y_1p + Omega Y_0 = H (W_p + Omega_2 Yh_2)`.
#[derive(Clone, Debug)]
pub struct Stage {
    /// `Y_1p`, D x N.
    pub first: DMatrix<f64>,
    /// `W_p`, D x N.
    pub second: DMatrix<f64>,
    /// `Y_0`, D x N.
    pub positions: DMatrix<f64>,
    /// `Yh_2`, D x N.
    pub accelerations: DMatrix<f64>,
}

impl Stage {
    /// From the two equations.
    pub fn new(sides: &Sides) -> Self {
        Self {
            first: sides.first.particular(),
            second: sides.second.particular(),
            positions: sides.first.factor.clone(),
            accelerations: sides.second.factor.clone(),
        }
    }

    /// D.
    pub fn dimension(&self) -> usize {
        self.first.nrows()
    }

    /// The best `Omega` and `Omega_2` for a given `H`, whose `Y_1 = Y_1p + Omega Y_0` obeys the first equation exactly.
    pub fn with_rotation(&self, rotation: &DMatrix<f64>, iterations: usize) -> Result<SecondStage> {
        let entries = skew_entries(self.dimension());
        let mut columns = self.omega_columns();
        columns.extend(self.second_columns(rotation));
        let system = DMatrix::from_columns(&columns);
        let target = stacked(&(rotation * &self.second - &self.first));
        let solution = least_squares(&system, &target, RANK).ok_or_else(not_seen)?;
        Ok(SecondStage {
            velocities: &self.first + self.omega(&solution.as_slice()[..entries]) * &self.positions,
            rotation: rotation.clone(),
            cost: (system * solution - target).norm_squared(),
            iterations,
        })
    }

    /// Derivatives of `Omega Y_0` by the entries of `Omega`.
    pub fn omega_columns(&self) -> Vec<DVector<f64>> {
        let dimension = self.dimension();
        let column = |index| stacked(&(skew(dimension, index) * &self.positions));
        (0..skew_entries(dimension)).map(column).collect()
    }

    /// Derivatives of `-H Omega_2 Yh_2` by the entries of `Omega_2`.
    pub fn second_columns(&self, rotation: &DMatrix<f64>) -> Vec<DVector<f64>> {
        let dimension = self.dimension();
        let column = |index| stacked(&-(rotation * skew(dimension, index) * &self.accelerations));
        (0..skew_entries(dimension)).map(column).collect()
    }

    /// The skew matrix of these entries.
    pub fn omega(&self, entries: &[f64]) -> DMatrix<f64> {
        let dimension = self.dimension();
        let zero = DMatrix::zeros(dimension, dimension);
        entries.iter().enumerate().fold(zero, |sum, (index, &entry)| sum + skew(dimension, index) * entry)
    }
}

/// `H W_p + P Yh_2 - Omega Y_0 = Y_1p` by linear least squares; reflections need no branch of their own.
pub fn solve(sides: &Sides) -> Result<SecondStage> {
    let stage = Stage::new(sides);
    let rotation = rotation(&stage).ok_or_else(not_seen)?;
    stage.with_rotation(&rotation, 0)
}

/// `H` on O(D); `None` where the linear system has lost its rank.
pub fn rotation(stage: &Stage) -> Option<DMatrix<f64>> {
    let (dimension, nodes) = stage.first.shape();
    let mut columns = Vec::new();
    for factor in [&stage.second, &stage.accelerations] {
        for j in 0..dimension {
            for i in 0..dimension {
                let mut column = DMatrix::zeros(dimension, nodes);
                column.row_mut(i).copy_from(&factor.row(j));
                columns.push(stacked(&column));
            }
        }
    }
    columns.extend(stage.omega_columns().into_iter().map(|column| -column));
    let solution = least_squares(&DMatrix::from_columns(&columns), &stacked(&stage.first), RANK)?;
    let h = DMatrix::from_column_slice(dimension, dimension, &solution.as_slice()[..dimension * dimension]);
    nearest_orthogonal(&h).ok()
}

/// The columns below each other.
pub fn stacked(matrix: &DMatrix<f64>) -> DVector<f64> {
    DVector::from_column_slice(matrix.as_slice())
}

/// Least squares by an orthogonal triangle; `None` where a diagonal entry is below `rank` of the largest.
pub fn least_squares(system: &DMatrix<f64>, target: &DVector<f64>, rank: f64) -> Option<DVector<f64>> {
    if system.nrows() < system.ncols() {
        return None;
    }
    let qr = system.clone().qr();
    let triangle = qr.r();
    let sizes = triangle.diagonal().abs();
    if !(sizes.min() > rank * sizes.max()) {
        return None;
    }
    let mut turned = target.clone();
    qr.q_tr_mul(&mut turned);
    triangle.solve_upper_triangular(&turned.rows(0, system.ncols()))
}

/// The error where velocities are not seen.
pub fn not_seen() -> Error {
    Error::Degenerate {
        what: "the rotation between positions and accelerations",
        value: 0.0,
        reason: "Its linear system lost its rank: the nodes lie or move too regularly.",
    }
}
