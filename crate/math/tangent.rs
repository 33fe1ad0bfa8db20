//! Symmetric matrices on the tangent space of poses, `(phi, shift)`: 3 coordinates in the plane, 6 in space.

use nalgebra::{SMatrix, SVector};

use super::block::BlockMatrix;
use super::linalg::spd_inverse;
use super::pose::Theta;
use super::rotation::{AngleMatrix, Angles, MAX_ANGLES, Rotation, rotation_angles};

/// Tangent coordinates in space; in the plane the first 3 are used.
pub const MAX_TANGENT: usize = 6;

/// Number of tangent coordinates of a pose: rotation angles and shift.
pub const fn tangent_dimension(d: usize) -> usize {
    rotation_angles(d) + d
}

/// A tangent vector of a pose: rotation coordinates (rad), then the shift of the position (m).
pub type TangentVector = SVector<f64, MAX_TANGENT>;

/// A linear map between tangent spaces.
pub type TangentTransform = SMatrix<f64, MAX_TANGENT, MAX_TANGENT>;

/// A symmetric matrix on the tangent space of poses. Unused coordinates (D = 2) carry the identity, so that inverses
/// and solutions leave them alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentMatrix<const D: usize>(SMatrix<f64, MAX_TANGENT, MAX_TANGENT>);

impl<const D: usize> TangentMatrix<D> {
    /// Zero on the used coordinates.
    pub fn zeros() -> Self {
        let mut matrix = SMatrix::zeros();
        for i in tangent_dimension(D)..MAX_TANGENT {
            matrix[(i, i)] = 1.0;
        }
        Self(matrix)
    }

    /// Adds `angle I` on the rotation coordinates and `shift I` on the shift.
    pub fn add_isotropic(&mut self, angle: f64, shift: f64) {
        for i in 0..tangent_dimension(D) {
            self.0[(i, i)] += if i < rotation_angles(D) { angle } else { shift };
        }
    }

    /// Entry `(i, j)`, rotation coordinates first.
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        self.0[(i, j)]
    }

    /// Adds to the used entries of the matrix.
    pub fn add(&mut self, other: &Self) {
        for j in 0..tangent_dimension(D) {
            for i in 0..tangent_dimension(D) {
                self.0[(i, j)] += other.0[(i, j)];
            }
        }
    }

    /// Adds `w x x^T`; `x` is 0 beyond the used coordinates.
    pub fn add_square(&mut self, w: f64, x: &TangentVector) {
        for j in 0..tangent_dimension(D) {
            let scaled = w * x[j];
            for i in 0..tangent_dimension(D) {
                self.0[(i, j)] += x[i] * scaled;
            }
        }
    }

    /// `J^T A J`.
    #[must_use]
    pub fn congruence(&self, jacobian: &TangentTransform) -> Self {
        Self(jacobian.transpose() * self.0 * jacobian)
    }

    /// Inverse of a positive definite matrix.
    ///
    /// # Errors
    /// The offending pivot.
    pub fn inverse(&self) -> Result<Self, f64> {
        spd_inverse(&self.0).map(Self)
    }

    /// The product with a tangent vector.
    pub fn times(&self, x: &TangentVector) -> TangentVector {
        self.0 * x
    }

    /// `x^T A x`.
    pub fn quadratic_form(&self, x: &TangentVector) -> f64 {
        x.dot(&(self.0 * x))
    }

    /// Trace over the rotation coordinates, rad^2 if this is a covariance.
    pub fn angle_trace(&self) -> f64 {
        (0..rotation_angles(D)).map(|i| self.0[(i, i)]).sum()
    }

    /// The block of the rotation coordinates, carried from the body frame of `world_from_body` to the world frame:
    /// `R C R^T`, since `R exp(hat(phi)) = exp(hat(R phi)) R`. One turn of the plane is the same in both frames. Unused
    /// coordinates are zero.
    pub fn rotation_block_in_world(&self, world_from_body: &Rotation<D>) -> AngleMatrix {
        if D == 2 {
            let mut block = AngleMatrix::zeros();
            block[(0, 0)] = self.0[(0, 0)];
            return block;
        }
        let in_body = self.0.fixed_view::<MAX_ANGLES, MAX_ANGLES>(0, 0);
        let rotation = AngleMatrix::from_fn(|i, j| world_from_body.matrix()[(i, j)]);
        rotation * in_body * rotation.transpose()
    }

    /// The block of the shift.
    pub fn shift_block(&self) -> SMatrix<f64, D, D> {
        let first = rotation_angles(D);
        SMatrix::from_fn(|i, j| self.0[(first + i, first + j)])
    }

    /// Restricts an information matrix on `theta` to the tangent space at `rotation`: `T^T Lambda T`,
    /// `T = d vec([R exp(hat(phi)) | t])/d(phi, t)`.
    ///
    /// In body axes, `S_jk = R^T Lambda_jk R`, a turn about one axis picks two columns: `hat(e_i)` takes column `p` of `Q`
    /// to axis `q` and column `q` to minus axis `p`.
    pub fn restrict(information: &BlockMatrix<D>, rotation: &Rotation<D>) -> Self {
        let turned = InBodyAxes::new(information, rotation);
        let angles = rotation_angles(D);
        let mut result = Self::zeros();
        for i in 0..angles {
            let (p, q) = turned_axes::<D>(i);
            for k in 0..=i {
                let (r, s) = turned_axes::<D>(k);
                let entry = turned.entry((p, q), (r, s))
                    - turned.entry((p, q), (s, r))
                    - turned.entry((q, p), (r, s))
                    + turned.entry((q, p), (s, r));
                (result.0[(i, k)], result.0[(k, i)]) = (entry, entry);
            }
            for k in 0..D {
                let entry = turned.mixed[p][(k, q)] - turned.mixed[q][(k, p)];
                (result.0[(angles + k, i)], result.0[(i, angles + k)]) = (entry, entry);
            }
        }
        for k in 0..D {
            for i in 0..D {
                result.0[(angles + i, angles + k)] = information.entry(D * D + i, D * D + k);
            }
        }
        result
    }

    /// The covariance of the tangent coordinates of the pose nearest to `[Q | t]`, given that of `vec([Q | t])` about
    /// `rotation`. To first order the nearest rotation errs by `phi_i = vec(R E_i)^T vec(Q - R)/2`.
    pub fn of_nearest_pose(covariance: &BlockMatrix<D>, rotation: &Rotation<D>) -> Self {
        let mut result = Self::restrict(covariance, rotation);
        for i in 0..rotation_angles(D) {
            for j in 0..tangent_dimension(D) {
                result.0[(i, j)] *= 0.5;
                result.0[(j, i)] *= 0.5;
            }
        }
        result
    }
}

/// Restricts a gradient on `theta` to the tangent space at `rotation`: `T^T vec(gradient)`.
pub fn restrict_gradient<const D: usize>(gradient: &Theta<D>, rotation: &Rotation<D>) -> TangentVector {
    let angles = rotation_angles(D);
    let in_body = rotation.matrix().transpose() * gradient.orientation;
    let mut result = TangentVector::zeros();
    for i in 0..angles {
        let (p, q) = turned_axes::<D>(i);
        result[i] = in_body[(q, p)] - in_body[(p, q)];
    }
    for j in 0..D {
        result[angles + j] = gradient.position[j];
    }
    result
}

/// Splits a tangent vector into rotation coordinates and shift.
pub fn split<const D: usize>(x: &TangentVector) -> (Angles, SVector<f64, D>) {
    let angles = rotation_angles(D);
    let mut phi = [0.0; MAX_ANGLES];
    for (i, entry) in phi.iter_mut().enumerate().take(angles) {
        *entry = x[i];
    }
    (phi, SVector::from_fn(|i, _| x[angles + i]))
}

/// Joins rotation coordinates and shift to a tangent vector.
pub fn join<const D: usize>(phi: &Angles, shift: &SVector<f64, D>) -> TangentVector {
    let angles = rotation_angles(D);
    let mut x = TangentVector::zeros();
    for i in 0..angles {
        x[i] = phi[i];
    }
    for i in 0..D {
        x[angles + i] = shift[i];
    }
    x
}

/// The axes `(p, q)` of a turn: `hat(e_i)` takes axis `p` to `q` and `q` to minus `p`.
fn turned_axes<const D: usize>(i: usize) -> (usize, usize) {
    if D == 2 { (0, 1) } else { ((i + 1) % 3, (i + 2) % 3) }
}

/// The blocks of a matrix on `[Q | t]`, turned into the axes of the body.
struct InBodyAxes<const D: usize> {
    /// `R^T A_jk R` for `j >= k`.
    orientation: [[SMatrix<f64, D, D>; D]; D],
    /// `A_tk R`.
    mixed: [SMatrix<f64, D, D>; D],
}

impl<const D: usize> InBodyAxes<D> {
    fn new(matrix: &BlockMatrix<D>, rotation: &Rotation<D>) -> Self {
        let (r, mut orientation) = (rotation.matrix(), [[SMatrix::zeros(); D]; D]);
        for j in 0..D {
            for k in 0..=j {
                orientation[j][k] = r.transpose() * (matrix.block(j, k) * r);
            }
        }
        Self { orientation, mixed: core::array::from_fn(|k| matrix.block(D, k) * r) }
    }

    /// Entry between axis `a` of column `j` and axis `b` of column `k`.
    fn entry(&self, (j, a): (usize, usize), (k, b): (usize, usize)) -> f64 {
        if j >= k { self.orientation[j][k][(a, b)] } else { self.orientation[k][j][(b, a)] }
    }
}
