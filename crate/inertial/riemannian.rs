//! Retraction and transport on SO(3), the Riemannian tools of the paper (\[I\] Table II).

use nalgebra::{Matrix3, SMatrix};

use super::bilinear::StateMatrix;
use super::filter::require_finite;
use crate::error::Result;
use crate::math::float::sqrt;
use crate::math::rotation::{Manifold, Rotation, determinant, vee};
use crate::model::indoor::filter_settings::{FilterSettings, Retraction, Transport};

/// What a filter does to stay on SO(3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Riemannian {
    /// How a step comes back.
    pub retraction: Retraction,
    /// How the covariance follows.
    pub transport: Transport,
    /// Whether a correction is projected onto the tangent space first.
    pub tangent_correction: bool,
}

/// A rotation that came of a retraction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Retracted {
    /// The rotation.
    pub rotation: Matrix3<f64>,
    /// Whether the Q-factor was a reflection.
    pub reflected: bool,
}

impl Riemannian {
    /// The choices of the settings.
    pub fn of(settings: &FilterSettings) -> Self {
        let FilterSettings { retraction, transport, tangent_correction, .. } = *settings;
        Self { retraction, transport, tangent_correction }
    }

    /// Retraction and nothing else.
    pub fn retraction_only(retraction: Retraction) -> Self {
        Self { retraction, transport: Transport::None, tangent_correction: false }
    }

    /// The rotation that the step `v` leads to from `r`.
    ///
    /// # Errors
    /// [`crate::Error::Number`] where `r + v` has no Q-factor.
    pub fn retract(&self, r: &Matrix3<f64>, v: &Matrix3<f64>) -> Result<Retracted> {
        retract(self.retraction, r, v)
    }

    /// The retraction of a correction, which is in general not tangent.
    ///
    /// # Errors
    /// As [`Riemannian::retract`].
    pub fn retract_correction(&self, r: &Matrix3<f64>, v: &Matrix3<f64>) -> Result<Retracted> {
        if !self.tangent_correction {
            return self.retract(r, v);
        }
        let in_body = r.transpose() * v;
        self.retract(r, &(r * ((in_body - in_body.transpose()) * 0.5)))
    }
}

/// The rotation that the step `v` leads to from the rotation `r`.
///
/// # Errors
/// [`crate::Error::Number`] where `r + v` has no Q-factor.
pub fn retract(kind: Retraction, r: &Matrix3<f64>, v: &Matrix3<f64>) -> Result<Retracted> {
    let moved = r + v;
    require_finite(moved.iter())?;
    let rotation = match kind {
        Retraction::Qr => return q_factor(&moved),
        Retraction::Polar => *Rotation::project(&moved, Manifold::So).matrix(),
        Retraction::Exponential => {
            let in_body = r.transpose() * v;
            let turn = Rotation::<3>::exp(&vee(&((in_body - in_body.transpose()) * 0.5)));
            // Products of rotations drift by an ulp a step.
            *Rotation::from_matrix_unchecked(r * turn.matrix()).renormalized().matrix()
        }
    };
    Ok(Retracted { rotation, reflected: false })
}

/// Gram-Schmidt on the first two columns; the third is their cross product, which is that of the Q-factor up to its sign.
fn q_factor(a: &Matrix3<f64>) -> Result<Retracted> {
    let unit = |x: nalgebra::Vector3<f64>| x / sqrt(x.norm_squared());
    let first = unit(a.column(0).into_owned());
    let second = a.column(1) - first * first.dot(&a.column(1));
    // Once more, so that what rounding left goes too.
    let second = unit(second - first * first.dot(&second));
    let rotation = Matrix3::from_columns(&[first, second, first.cross(&second)]);
    require_finite(rotation.iter())?;
    Ok(Retracted { rotation, reflected: determinant(a) < 0.0 })
}

/// Carries a covariance from the rotation `old` to `new`, `M = blkdiag(I (x) new old^T, I_6)`.
///
/// `before` is the block of `vec(R)` from before the step, which only [`Transport::Literal`] reads.
pub fn transport(
    kind: Transport,
    p: &mut StateMatrix,
    before: &SMatrix<f64, 9, 9>,
    old: &Matrix3<f64>,
    new: &Matrix3<f64>,
) {
    let turn = new * old.transpose();
    match kind {
        Transport::None => (),
        Transport::Literal => {
            let mut carried = StateMatrix::zeros();
            carried.fixed_view_mut::<9, 9>(0, 0).copy_from(before);
            turn_blocks(&mut carried, &turn, 3);
            p.fixed_view_mut::<9, 9>(0, 0).copy_from(&carried.fixed_view::<9, 9>(0, 0));
        }
        Transport::Block => turn_blocks(p, &turn, 3),
        Transport::Congruence => turn_blocks(p, &turn, 5),
    }
}

/// `M P M^T` on the first `blocks` blocks of three: rows and columns of `vec(R)` are turned, the rest is left.
fn turn_blocks(p: &mut StateMatrix, turn: &Matrix3<f64>, blocks: usize) {
    for i in 0..blocks {
        for j in 0..blocks {
            let block = p.fixed_view::<3, 3>(3 * i, 3 * j).into_owned();
            let left = if i < 3 { turn * block } else { block };
            let both = if j < 3 { left * turn.transpose() } else { left };
            p.fixed_view_mut::<3, 3>(3 * i, 3 * j).copy_from(&both);
        }
    }
}
