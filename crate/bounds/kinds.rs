//! The bounds by name, and what each says about orientation and position.

use nalgebra::SMatrix;

use crate::math::block::BlockMatrix;
use crate::math::rotation::{AngleMatrix, Rotation};
use crate::math::tangent::TangentMatrix;

/// One of the bounds along a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BoundKind {
    /// `F^-1` of the epoch alone.
    Crb,
    /// `(T^T F T)^-1` of the epoch alone, projected squared ranges.
    UnitaryCrb,
    /// The same with the squared ranges as they are.
    UnitaryCrbRaw,
    /// Tichavsky's recursion on all entries of `[Q | t]`.
    LinearPosteriorCrb,
    /// The recursion on SO(D) x R^D, projected squared ranges.
    PosteriorCrb,
    /// The same with the squared ranges as they are.
    PosteriorCrbRaw,
}

impl BoundKind {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 6] = [
        Self::Crb,
        Self::UnitaryCrb,
        Self::UnitaryCrbRaw,
        Self::LinearPosteriorCrb,
        Self::PosteriorCrb,
        Self::PosteriorCrbRaw,
    ];

    /// The name in documents and on the command line; it stays.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Crb => "crb",
            Self::UnitaryCrb => "uc_crb",
            Self::UnitaryCrbRaw => "uc_crb_raw",
            Self::LinearPosteriorCrb => "linear_posterior_crb",
            Self::PosteriorCrb => "posterior_crb",
            Self::PosteriorCrbRaw => "posterior_crb_raw",
        }
    }

    /// The name for people.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Crb => "CRB, this step alone",
            Self::UnitaryCrb => "UC-CRB, this step alone",
            Self::UnitaryCrbRaw => "UC-CRB, this step alone, unprojected ranges",
            Self::LinearPosteriorCrb => "posterior CRB, any matrix Q",
            Self::PosteriorCrb => "posterior CRB, rotations",
            Self::PosteriorCrbRaw => "posterior CRB, rotations, unprojected ranges",
        }
    }
}

/// A bound on a covariance.
#[allow(
    clippy::large_enum_variant,
    reason = "the lint takes the generic matrix for empty; both live on the stack"
)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BoundMatrix<const D: usize> {
    /// Of all entries of `[Q | t]`.
    Linear(BlockMatrix<D>),
    /// Of the tangent coordinates `(phi, t)`, rotation perturbed on the right.
    Tangent(TangentMatrix<D>),
}

/// A bound and its traces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound<const D: usize> {
    /// The whole matrix.
    pub matrix: BoundMatrix<D>,
    /// Least mean of `||Qhat - Q||_F^2`: the trace on `vec(Q)`; twice the angle variance on the manifold.
    pub orientation_trace: f64,
    /// Least mean square of the rotation angle, rad^2. For a linear bound that of the rotation nearest to `Qhat`;
    /// `None` where the true orientation is not known.
    pub angle_variance: Option<f64>,
    /// Least mean of `||that - t||^2`, m^2.
    pub position_trace: f64,
}

impl<const D: usize> Bound<D> {
    /// A bound on all entries of `[Q | t]`.
    ///
    /// Its angle variance is that of the nearest rotation ([`TangentMatrix::of_nearest_pose`]).
    pub fn linear(matrix: BlockMatrix<D>, rotation: Option<&Rotation<D>>) -> Self {
        Self {
            matrix: BoundMatrix::Linear(matrix),
            orientation_trace: matrix.orientation_trace(),
            angle_variance: rotation.map(|r| TangentMatrix::of_nearest_pose(&matrix, r).angle_trace()),
            position_trace: matrix.position_block().trace(),
        }
    }

    /// A bound on the tangent coordinates.
    pub fn tangent(matrix: TangentMatrix<D>) -> Self {
        Self {
            matrix: BoundMatrix::Tangent(matrix),
            orientation_trace: 2.0 * matrix.angle_trace(),
            angle_variance: Some(matrix.angle_trace()),
            position_trace: matrix.shift_block().trace(),
        }
    }

    /// The bound on the covariance of the error's rotation vector in the world frame, rad^2, at the true orientation; for
    /// a linear bound that of the rotation nearest to `Qhat`. Its trace is the angle variance.
    pub fn rotation_block_in_world(&self, truth: &Rotation<D>) -> AngleMatrix {
        match &self.matrix {
            BoundMatrix::Linear(matrix) => {
                TangentMatrix::of_nearest_pose(matrix, truth).rotation_block_in_world(truth)
            }
            BoundMatrix::Tangent(matrix) => matrix.rotation_block_in_world(truth),
        }
    }

    /// The bound on the covariance of the position, m^2.
    pub fn position_block(&self) -> SMatrix<f64, D, D> {
        match &self.matrix {
            BoundMatrix::Linear(matrix) => matrix.position_block(),
            BoundMatrix::Tangent(matrix) => matrix.shift_block(),
        }
    }
}
