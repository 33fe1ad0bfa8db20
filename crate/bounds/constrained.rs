//! Bounds from one epoch alone: the unconstrained Cramér-Rao bound and the one for rotations (UC-CRB).

use core::ops::Range;

use nalgebra::SMatrix;

use super::cause::unobservable;
use super::fisher::FisherInformation;
use crate::error::Result;
use crate::math::block::BlockMatrix;
use crate::math::rotation::{Rotation, rotation_angles};
use crate::math::tangent::{TangentMatrix, tangent_dimension};
use crate::model::lack::Parameters;

/// Where knowing nothing of the other parameters costs more than this factor in the variance of one, the information
/// matrix is singular within double precision.
const MAX_INFLATION: f64 = 1e12;

/// Information about one of several parameters of the same unit, below this part of the largest, is rounding: anchors at
/// the same height leave a trace of it, which the inflation of that one parameter does not show.
const MIN_PART: f64 = 1.0 / MAX_INFLATION;

/// The Cramér-Rao bound `F^-1` of all entries of `[Q | t]`, which takes `Q` for any matrix (\[L\] eq. 40).
///
/// Entries of `Q` have no unit, those of `t` are in m.
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause: it needs M >= D + 1 anchors and N >= D + 1 sensors that fill the space.
pub fn crb<const D: usize>(information: &FisherInformation<D>) -> Result<BlockMatrix<D>> {
    let f = &information.matrix;
    let inverse = f.inverse().ok();
    inverse
        .filter(|c| (0..D * (D + 1)).all(|i| carries_digits(f.entry(i, i) * c.entry(i, i))))
        .filter(|_| {
            // Along each column of [Q | t] the anchors decide; from column to column of Q the sensors.
            let column = |j: usize| f.block(j, j).diagonal();
            (0..=D).all(|j| comparable((0..D).map(|i| column(j)[i])))
                && comparable((0..D).map(|j| column(j).sum()))
        })
        .ok_or_else(|| unobservable("the Cramér-Rao bound", information, Parameters::Unconstrained))
}

/// The unitarily constrained bound on the tangent space, `(T^T F T)^-1` with `T = d vec([R exp(hat(phi)) | t])/d(phi, t)`
/// (\[L\] eq. 42, corrected, in coordinates of rad and m).
///
/// # Errors
/// [`crate::Error::Unobservable`] with the cause.
pub fn unitary_crb<const D: usize>(information: &FisherInformation<D>) -> Result<TangentMatrix<D>> {
    unitary_crb_on(information, &information.on_tangent_space())
}

/// [`unitary_crb`] where the information `j` on the tangent space is known already.
pub(super) fn unitary_crb_on<const D: usize>(
    information: &FisherInformation<D>,
    j: &TangentMatrix<D>,
) -> Result<TangentMatrix<D>> {
    covariance_of(j)
        .ok_or_else(|| unobservable("the unitarily constrained bound", information, Parameters::Pose))
}

/// [`unitary_crb`] of an information on the tangent space alone; without the cause where there is no bound.
pub fn covariance_of<const D: usize>(j: &TangentMatrix<D>) -> Option<TangentMatrix<D>> {
    j.inverse()
        .ok()
        .filter(|c| (0..tangent_dimension(D)).all(|i| carries_digits(j.entry(i, i) * c.entry(i, i))))
        .filter(|_| {
            let part = |range: Range<usize>| comparable(range.map(|i| j.entry(i, i)));
            part(0..rotation_angles(D)) && part(rotation_angles(D)..tangent_dimension(D))
        })
}

/// The covariance `T C T^T` of `vec([Q | t])` that belongs to a covariance `C` of the tangent coordinates: with
/// [`unitary_crb`] it is `U (U^T F U)^-1 U^T` of \[L\] eq. 42 and 47, of rank D(D+1)/2.
pub fn image<const D: usize>(covariance: &TangentMatrix<D>, rotation: &Rotation<D>) -> BlockMatrix<D> {
    let angles = rotation_angles(D);
    // Column j of the derivative of [R exp(hat(phi)) | t] in tangent coordinate a.
    let derivative = |a: usize, j: usize| match (a < angles, j < D) {
        (true, true) => rotation.tangent(a).column(j).into_owned(),
        (false, false) => SMatrix::<f64, D, 1>::from_fn(|i, _| f64::from(u8::from(i == a - angles))),
        _ => SMatrix::zeros(),
    };
    let mut result = BlockMatrix::zeros();
    for i in 0..=D {
        for j in 0..=i {
            let mut block = SMatrix::<f64, D, D>::zeros();
            for a in 0..tangent_dimension(D) {
                for b in 0..tangent_dimension(D) {
                    block += derivative(a, i) * derivative(b, j).transpose() * covariance.entry(a, b);
                }
            }
            result.set_block(i, j, &block);
        }
    }
    result
}

/// Whether the least of some informations is more than rounding beside the largest.
fn comparable(mut information: impl Iterator<Item = f64> + Clone) -> bool {
    let largest = information.clone().fold(0.0, f64::max);
    information.all(|x| x > MIN_PART * largest)
}

/// Written so that NaN and negative variances fail too.
fn carries_digits(inflation: f64) -> bool {
    inflation > 0.0 && inflation < MAX_INFLATION
}
