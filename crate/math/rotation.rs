//! Rotations of the plane and of space, one code path for both.
//!
//! Everything is written on the skew matrix `K = hat(phi)`: `theta^2 = ||K||_F^2 / 2` in both dimensions.

use nalgebra::{SMatrix, SVector};

use super::float;
use super::polar::polar_factor;
use super::singular::singular;
use crate::error::{Error, Result};

/// Number of rotation angles in dimension `d`: 1 in the plane, 3 in space.
pub const fn rotation_angles(d: usize) -> usize {
    d * (d - 1) / 2
}

/// The most rotation angles there are (space); angle coordinates travel as `[f64; MAX_ANGLES]`, unused ones zero.
pub const MAX_ANGLES: usize = 3;

/// Rotation coordinates `phi`, radians: one angle in the plane (first entry), a rotation vector in space.
pub type Angles = [f64; MAX_ANGLES];

/// A matrix on rotation coordinates, such as their covariance (rad^2).
pub type AngleMatrix = SMatrix<f64, MAX_ANGLES, MAX_ANGLES>;

/// The manifold a matrix is projected onto.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum Manifold {
    /// Rotations, `det = +1`. What a rigid body can do.
    #[default]
    So,
    /// Orthogonal matrices, reflections included: the papers' Stiefel manifold `V_{D,D}`.
    O,
}

/// An orthogonal matrix `world_from_body`; a rotation (`det = +1`) unless it was projected onto [`Manifold::O`].
///
/// ```
/// use rangelab::math::rotation::Rotation;
/// let quarter = Rotation::<2>::exp(&[core::f64::consts::FRAC_PI_2, 0.0, 0.0]);
/// assert!((quarter.matrix()[(1, 0)] - 1.0).abs() < 1e-15);
/// assert!((quarter.log()[0] - core::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation<const D: usize>(SMatrix<f64, D, D>);

/// A rotation that was rounded to double precision is no further than this from being one.
const ROUNDING: f64 = 1e-14;

impl<const D: usize> Rotation<D> {
    /// The identity.
    pub fn identity() -> Self {
        const { assert!(D == 2 || D == 3, "rigid bodies live in the plane or in space") };
        Self(SMatrix::identity())
    }

    /// Takes a matrix that is orthogonal to within `1e-6` and has `det > 0`. It is projected, so that what is kept is a
    /// rotation to the last digit, unless it is one already: then it keeps its bits, as a pose read from a file must.
    ///
    /// # Errors
    /// [`Error::Number`] with the defect `||Q^T Q - I||_F` or the determinant.
    pub fn from_matrix(matrix: &SMatrix<f64, D, D>) -> Result<Self> {
        let found = defect(matrix);
        if !(found <= 1e-6) {
            return Err(Error::Number {
                what: "the defect ||Q^T Q - I||_F of an orientation",
                value: found,
                limit: "at most 1e-6: the columns of a rotation are orthogonal and of length 1",
            });
        }
        let sign = determinant(matrix);
        if sign < 0.0 {
            return Err(Error::Number {
                what: "the determinant of an orientation",
                value: sign,
                limit: "+1: this matrix mirrors the body",
            });
        }
        Ok(if found <= ROUNDING { Self(*matrix) } else { Self::project(matrix, Manifold::So) })
    }

    /// Takes an orthogonal matrix as it is.
    ///
    /// Not checked: orthogonality. For results of exact group operations.
    pub fn from_matrix_unchecked(matrix: SMatrix<f64, D, D>) -> Self {
        Self(matrix)
    }

    /// The matrix, `world_from_body`.
    pub fn matrix(&self) -> &SMatrix<f64, D, D> {
        &self.0
    }

    /// `exp(hat(phi))`, Rodrigues' formula (\[T\] eq. 10) in a form that is accurate down to `phi = 0`.
    ///
    /// `I + sin(theta)/theta K + 2 sin^2(theta/2)/theta^2 K^2`.
    pub fn exp(phi: &Angles) -> Self {
        let k = hat::<D>(phi);
        let theta_squared = 0.5 * k.norm_squared();
        let (s, c) = if theta_squared < 1e-8 {
            // The next terms are below theta^4/120 = 1e-18.
            (1.0 - theta_squared / 6.0, 0.5 - theta_squared / 24.0)
        } else {
            let theta = float::sqrt(theta_squared);
            let half = float::sin(0.5 * theta);
            (float::sin(theta) / theta, 2.0 * half * half / theta_squared)
        };
        Self(SMatrix::identity() + k * s + k * k * c)
    }

    /// The rotation coordinates `phi` with `exp(phi) = self` and `||phi|| <= pi`; accurate at and near pi.
    ///
    /// At exactly pi in space the axis is known up to its sign; the one whose largest component is positive is taken.
    pub fn log(&self) -> Angles {
        let skew = vee(&(self.0 - self.0.transpose())).map(|x| 0.5 * x);
        if D == 2 {
            return [float::atan2(self.0[(1, 0)], self.0[(0, 0)]), 0.0, 0.0];
        }
        let sine = norm(&skew);
        let cosine = 0.5 * (self.0.trace() - 1.0);
        let theta = float::atan2(sine, cosine);
        if cosine > 0.0 {
            // sin(theta)/theta from the same theta, so that exp(log) closes; 1 at zero.
            let scale = if sine < 1e-8 { 1.0 } else { theta / sine };
            return skew.map(|x| scale * x);
        }
        let axis = axis_of_large_angle(&self.0, cosine, &skew);
        axis.map(|x| theta * x)
    }

    /// The geodesic angle of the rotation, `0..=pi`.
    pub fn angle(&self) -> f64 {
        norm(&self.log())
    }

    /// The inverse rotation.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self(self.0.transpose())
    }

    /// `self * other`.
    #[must_use]
    pub fn compose(&self, other: &Self) -> Self {
        Self(self.0 * other.0)
    }

    /// The nearest element of the manifold in the Frobenius norm (\[T\] eq. 28): the polar factor `U V^T`, on
    /// [`Manifold::So`] with the sign of the least singular direction turned where it would mirror.
    pub fn project(matrix: &SMatrix<f64, D, D>, manifold: Manifold) -> Self {
        if let Some(polar) = polar_factor(matrix) {
            return Self(polar);
        }
        let s = singular(matrix);
        let mut left = s.left;
        let polar = left * s.right.transpose();
        if manifold == Manifold::So && determinant(&polar) < 0.0 {
            for i in 0..D {
                left[(i, D - 1)] = -left[(i, D - 1)];
            }
            return Self(left * s.right.transpose());
        }
        Self(polar)
    }

    /// The rotation nearest to one that products have moved off the manifold by rounding, `R (3 I - R^T R)/2`: the square
    /// of the defect is left.
    #[must_use]
    pub fn renormalized(&self) -> Self {
        Self(self.0 * (SMatrix::<f64, D, D>::identity() * 1.5 - self.0.transpose() * self.0 * 0.5))
    }

    /// `d(R exp(hat(phi)))/d phi_i` at `phi = 0`: the D x D matrix `R E_i`, `E_i = hat(e_i)`.
    pub fn tangent(&self, i: usize) -> SMatrix<f64, D, D> {
        let mut phi = [0.0; MAX_ANGLES];
        phi[i] = 1.0;
        self.0 * hat::<D>(&phi)
    }
}

/// Inverse right Jacobian of SO(D) at `phi`: `log(R exp(hat(delta))) = phi + J delta + O(delta^2)` for `R = exp(hat(phi))`.
///
/// `I + hat(phi)/2 + (1/theta^2 - (1 + cos theta)/(2 theta sin theta)) hat(phi)^2`, valid for `theta < 2 pi`; 1 in the
/// plane. Returned on the angle coordinates, unused ones carry the identity.
pub fn right_jacobian_inverse<const D: usize>(phi: &Angles) -> AngleMatrix {
    if D == 2 {
        return SMatrix::identity();
    }
    let k = hat::<MAX_ANGLES>(phi);
    let theta_squared = 0.5 * k.norm_squared();
    let factor = if theta_squared < 1e-4 {
        // The next term is theta^4/30240.
        1.0 / 12.0 + theta_squared / 720.0
    } else {
        // (1 + cos)/sin = cot(theta/2), which has no cancellation near pi.
        let half = 0.5 * float::sqrt(theta_squared);
        (1.0 - half * float::cos(half) / float::sin(half)) / theta_squared
    };
    SMatrix::identity() + k * 0.5 + k * k * factor
}

/// The skew matrix of rotation coordinates: `[0 -phi; phi 0]` in the plane, the cross product matrix in space.
pub fn hat<const D: usize>(phi: &Angles) -> SMatrix<f64, D, D> {
    let mut k = SMatrix::zeros();
    if D == 2 {
        k[(1, 0)] = phi[0];
        k[(0, 1)] = -phi[0];
    } else {
        for (axis, &x) in phi.iter().enumerate() {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            k[(j, i)] = x;
            k[(i, j)] = -x;
        }
    }
    k
}

/// Inverse of [`hat`]; reads the lower entries of each pair only.
pub fn vee<const D: usize>(k: &SMatrix<f64, D, D>) -> Angles {
    if D == 2 { [k[(1, 0)], 0.0, 0.0] } else { [k[(2, 1)], k[(0, 2)], k[(1, 0)]] }
}

/// Defect from orthogonality, `||Q^T Q - I||_F`: the statistic of the event trigger (\[T\] Sec. IV-C).
pub fn defect<const D: usize>(q: &SMatrix<f64, D, D>) -> f64 {
    float::sqrt((q.transpose() * q - SMatrix::<f64, D, D>::identity()).norm_squared())
}

/// Determinant of a 2 x 2 or 3 x 3 matrix.
pub fn determinant<const D: usize>(a: &SMatrix<f64, D, D>) -> f64 {
    if D == 2 {
        return a[(0, 0)] * a[(1, 1)] - a[(0, 1)] * a[(1, 0)];
    }
    let minor = |i: usize, j: usize| a[(1, i)] * a[(2, j)] - a[(1, j)] * a[(2, i)];
    a[(0, 0)] * minor(1, 2) - a[(0, 1)] * minor(0, 2) + a[(0, 2)] * minor(0, 1)
}

fn norm(phi: &Angles) -> f64 {
    float::sqrt(SVector::<f64, MAX_ANGLES>::from(*phi).norm_squared())
}

/// Unit axis from the symmetric part, `(R + R^T)/2 = cos I + (1 - cos) a a^T`, with the sign of the skew part.
fn axis_of_large_angle<const D: usize>(r: &SMatrix<f64, D, D>, cosine: f64, skew: &Angles) -> Angles {
    let outer = |i: usize, j: usize| {
        let diagonal = if i == j { cosine } else { 0.0 };
        (0.5 * (r[(i, j)] + r[(j, i)]) - diagonal) / (1.0 - cosine)
    };
    let mut largest = 0;
    for i in 1..D {
        if outer(i, i) > outer(largest, largest) {
            largest = i;
        }
    }
    let mut axis = [0.0; MAX_ANGLES];
    for (i, entry) in axis.iter_mut().enumerate().take(D) {
        *entry = outer(i, largest);
    }
    let length = if skew[largest] < 0.0 { -norm(&axis) } else { norm(&axis) };
    axis.map(|x| x / length)
}
