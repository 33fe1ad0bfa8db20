//! Vectors and matrices as the plain numbers of a document, and back.

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};
use serde::{Deserialize, Serialize};

use crate::error::Result;
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::{AngleMatrix, Angles, Rotation, rotation_angles};

/// A D x D matrix row by row and D coordinates: a pose, an unconstrained `[Q | t]`, or an innovation in its shape.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(deny_unknown_fields)]
pub struct PoseEntries {
    /// `Q`, `world_from_body`, row by row.
    pub orientation: Vec<Vec<f64>>,
    /// `t`, m.
    pub position: Vec<f64>,
}

impl PoseEntries {
    /// The identity at the origin.
    pub fn identity(dimension: usize) -> Self {
        let row = |i: usize| (0..dimension).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
        Self { orientation: (0..dimension).map(row).collect(), position: vec![0.0; dimension] }
    }

    /// The unconstrained `[Q | t]`.
    pub(crate) fn to_theta<const D: usize>(&self) -> Theta<D> {
        Theta { orientation: matrix_from_rows(&self.orientation), position: vector(&self.position) }
    }

    /// The pose.
    ///
    /// # Errors
    /// [`crate::Error::Number`] where the orientation is no rotation.
    pub(crate) fn to_pose<const D: usize>(&self) -> Result<Pose<D>> {
        let Theta { orientation, position } = self.to_theta();
        Ok(Pose { rotation: Rotation::from_matrix(&orientation)?, position })
    }
}

impl<const D: usize> From<Theta<D>> for PoseEntries {
    fn from(theta: Theta<D>) -> Self {
        Self { orientation: rows(&theta.orientation), position: theta.position.as_slice().to_vec() }
    }
}

impl<const D: usize> From<Pose<D>> for PoseEntries {
    fn from(pose: Pose<D>) -> Self {
        Theta::from(pose).into()
    }
}

/// A matrix row by row.
pub fn rows<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Vec<Vec<f64>> {
    (0..D).map(|i| (0..D).map(|j| matrix[(i, j)]).collect()).collect()
}

/// A matrix on rotation coordinates row by row: 3 x 3 in space, 1 x 1 in the plane.
pub fn angle_rows<const D: usize>(matrix: &AngleMatrix) -> Vec<Vec<f64>> {
    let angles = 0..rotation_angles(D);
    angles.clone().map(|i| angles.clone().map(|j| matrix[(i, j)]).collect()).collect()
}

/// Points as lists of coordinates.
pub fn coordinates<const D: usize>(points: &[SVector<f64, D>]) -> Vec<Vec<f64>> {
    points.iter().map(|point| point.as_slice().to_vec()).collect()
}

// The sizes below were checked by `validate`.

pub(crate) fn matrix_from_rows<const D: usize>(rows: &[Vec<f64>]) -> SMatrix<f64, D, D> {
    SMatrix::from_fn(|i, j| rows[i][j])
}

pub(crate) fn vector<const D: usize>(entries: &[f64]) -> SVector<f64, D> {
    SVector::from_fn(|i, _| entries[i])
}

pub(crate) fn points<const D: usize>(points: &[Vec<f64>]) -> Vec<SVector<f64, D>> {
    points.iter().map(|point| vector(point)).collect()
}

pub(crate) fn angles<const D: usize>(entries: &[f64]) -> Angles {
    let mut angles = Angles::default();
    angles[..rotation_angles(D)].copy_from_slice(entries);
    angles
}
