//! Poses of the body, and the paper's unconstrained `Theta = [Q | t]`.

use nalgebra::{SMatrix, SVector};

use super::rotation::{Angles, Rotation};

/// Position and orientation of the body: `s = R c + t` takes a point of the body frame to the world frame.
///
/// ```
/// use nalgebra::Vector2;
/// use rangelab::math::{pose::Pose, rotation::Rotation};
/// let world_from_body = Pose { rotation: Rotation::exp(&[1.0, 0.0, 0.0]), position: Vector2::new(3.0, 4.0) };
/// let round_trip = world_from_body.inverse().act(&world_from_body.act(&Vector2::new(0.1, 0.2)));
/// assert!((round_trip - Vector2::new(0.1, 0.2)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<const D: usize> {
    /// Orientation, `world_from_body`.
    pub rotation: Rotation<D>,
    /// Position of the body's origin in the world frame, m.
    pub position: SVector<f64, D>,
}

impl<const D: usize> Pose<D> {
    /// The body frame on the world frame.
    pub fn identity() -> Self {
        Self { rotation: Rotation::identity(), position: SVector::zeros() }
    }

    /// The world position of a point of the body, `R c + t`.
    pub fn act(&self, point_in_body: &SVector<f64, D>) -> SVector<f64, D> {
        self.rotation.matrix() * point_in_body + self.position
    }

    /// `body_from_world`.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        Self { rotation, position: -(rotation.matrix() * self.position) }
    }

    /// `self * other`.
    #[must_use]
    pub fn compose(&self, other: &Self) -> Self {
        Self { rotation: self.rotation.compose(&other.rotation), position: self.act(&other.position) }
    }

    /// Moves the pose by a tangent step on SO(D) x R^D: `(R exp(hat(phi)), t + shift)`, rotation perturbed on the right.
    #[must_use]
    pub fn retract(&self, phi: &Angles, shift: &SVector<f64, D>) -> Self {
        Self { rotation: self.rotation.compose(&Rotation::exp(phi)), position: self.position + shift }
    }

    /// Inverse of [`Pose::retract`]: the step from `self` to `other`.
    pub fn local(&self, other: &Self) -> (Angles, SVector<f64, D>) {
        (self.rotation.inverse().compose(&other.rotation).log(), other.position - self.position)
    }
}

/// The unconstrained state `Theta = [Q | t]` of \[T\] eq. 3: `Q` is any D x D matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theta<const D: usize> {
    /// `Q`, near a rotation but not constrained to be one.
    pub orientation: SMatrix<f64, D, D>,
    /// `t`, m.
    pub position: SVector<f64, D>,
}

impl<const D: usize> Theta<D> {
    /// All zeros.
    pub fn zeros() -> Self {
        Self { orientation: SMatrix::zeros(), position: SVector::zeros() }
    }

    /// Column `j` of `[Q | t]`, `j = 0..=D`.
    #[inline]
    pub fn column(&self, j: usize) -> SVector<f64, D> {
        if j < D { self.orientation.column(j).into_owned() } else { self.position }
    }

    /// Adds to column `j` of `[Q | t]`.
    #[inline]
    pub fn add_to_column(&mut self, j: usize, delta: &SVector<f64, D>) {
        if j < D {
            for i in 0..D {
                self.orientation[(i, j)] += delta[i];
            }
        } else {
            self.position += delta;
        }
    }

    /// `self - other`.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self { orientation: self.orientation - other.orientation, position: self.position - other.position }
    }

    /// `vec(self)^T vec(other)`.
    #[inline]
    pub fn dot(&self, other: &Self) -> f64 {
        self.orientation.dot(&other.orientation) + self.position.dot(&other.position)
    }

    /// True if every entry is finite.
    pub fn is_finite(&self) -> bool {
        self.orientation.iter().chain(self.position.iter()).all(|x| x.is_finite())
    }
}

impl<const D: usize> Default for Theta<D> {
    fn default() -> Self {
        Self::zeros()
    }
}

impl<const D: usize> From<Pose<D>> for Theta<D> {
    fn from(pose: Pose<D>) -> Self {
        Self { orientation: *pose.rotation.matrix(), position: pose.position }
    }
}
