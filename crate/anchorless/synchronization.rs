//! Snapshots of the fitted Gram matrix, brought into one frame by the motion being a polynomial.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::gram_fit::GramFit;
use super::multidimensional_scaling::classical_scaling;
use super::polynomial_fit::{PolynomialFit, powers_of};
use crate::error::Result;
use crate::math::legendre::legendre_values;
use crate::math::orthogonal::nearest_orthogonal;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::estimate::KinematicsEstimate;
use crate::model::kinematics::pair_polynomial::chebyshev_nodes;
use crate::model::kinematics::stacked::from_stacked_powers;

/// What is being computed, for errors.
const WHAT: &str = "snapshot synchronization";

/// Relative kinematics of any degree L in closed form.
///
/// The Gram matrix is fitted with degree 2L and scaled to positions `X_m` at M instants, each in a frame of its own, `R_m`
/// in O(D). The motion `R_m X_m` is a polynomial of degree L in one frame, so that what is orthogonal to such polynomials is
/// zero:
///
/// ```text
/// sum_m c_mq R_m X_m = 0    for the M - L - 1 vectors c_q orthogonal to 1, t, ..., t^L
/// ```
///
/// This is linear in all `R_m` together; its D solutions are the last right singular vectors of the equations. Each block is
/// then made orthogonal, and the snapshots in one frame are fitted with degree L.
/// `M = max(2L + 3, ceil(((N - 1)(L + 1) - D)/(N - 1 - D)))` Chebyshev nodes: the second counts equations.
///
/// It does not rest on any single coefficient, as \[A\] eq. 11 does on the last, and takes motions of any degree, in the plane
/// and in space, mirrored frames included.
///
/// # Errors
/// [`crate::Error::TooFew`] for fewer than D + 2 nodes, or where a pair has fewer than 2L + 1 different stamps;
/// [`crate::Error::Degenerate`] where stamps lie too close; [`crate::Error::Number`] for
/// distances above 1e30 m.
///
/// ```
/// use rangelab::anchorless::synchronization::snapshot_sync;
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::simulate::kinematics::simulate_kinematics;
/// let trial = simulate_kinematics(&kinematics_preset("kinematics-paper")?, 0)?;
/// let found = snapshot_sync(&trial.record, 2)?.kinematics.expect("it finds the motion").aligned_to(&trial.truth)?;
/// assert!((found.coefficient(1) - trial.truth.coefficient(1)).amax() < 0.3); // m/s
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn snapshot_sync(record: &DistanceRecord, degree: usize) -> Result<KinematicsEstimate> {
    let Synchronized { motion, fit, cost } = synchronized(record, degree)?;
    Ok(KinematicsEstimate {
        kinematics: Some(motion),
        gram: fit.powers()?,
        cost,
        ..KinematicsEstimate::default()
    })
}

pub(super) struct Synchronized {
    pub motion: RelativeKinematics,
    /// Of the Gram matrix.
    fit: GramFit,
    cost: f64,
}

/// [`snapshot_sync`] in parts.
pub(super) fn synchronized(record: &DistanceRecord, degree: usize) -> Result<Synchronized> {
    let (nodes, dimension) = (record.nodes(), record.dimension());
    let reason = "With fewer, any rotation at each instant is a polynomial motion too.";
    super::at_least_nodes(WHAT, nodes, dimension + 2, reason)?;
    let fit = GramFit::new(record, 2 * degree)?;
    let scale = record.time_scale();
    let instants = chebyshev_nodes(instant_count(nodes, dimension, degree));
    let snapshots: Vec<DMatrix<f64>> =
        instants.iter().map(|&s| classical_scaling(&fit.at(scale.time(s)), dimension).positions).collect();
    let polynomial = PolynomialFit::new(WHAT, &instants, degree)?;
    let (frames, cost) = common_frames(&snapshots, &orthogonal_to(&polynomial, &instants, degree))?;
    let mut values = DMatrix::zeros(instants.len(), dimension * nodes);
    for (m, (frame, snapshot)) in frames.iter().zip(&snapshots).enumerate() {
        let turned = frame * snapshot;
        values.row_mut(m).iter_mut().zip(turned.iter()).for_each(|(value, turned)| *value = *turned);
    }
    let fitted = polynomial.coefficients(&values);
    let of_legendre = |l: usize| DMatrix::from_iterator(dimension, nodes, fitted.row(l).iter().copied());
    let powers = powers_of(&(0..=degree).map(of_legendre).collect::<Vec<_>>());
    let stacked: Vec<f64> = powers.iter().flat_map(|power| power.iter().copied()).collect();
    let scaled = from_stacked_powers(dimension, nodes, &stacked).centred();
    Ok(Synchronized { motion: scale.unscale(&scaled)?, fit, cost })
}

/// M.
fn instant_count(nodes: usize, dimension: usize, degree: usize) -> usize {
    let equations = ((nodes - 1) * (degree + 1)).saturating_sub(dimension).div_ceil(nodes - 1 - dimension);
    equations.max(2 * degree + 3)
}

/// `sum_q c_q c_q^T`: what is left of values at the instants once a polynomial of degree L is fitted to them. Its columns say
/// the same as all `c_q`.
fn orthogonal_to(polynomial: &PolynomialFit, instants: &[f64], degree: usize) -> DMatrix<f64> {
    let identity = DMatrix::identity(instants.len(), instants.len());
    let values: Vec<f64> = instants.iter().flat_map(|&s| legendre_values(degree, s)).collect();
    let design = DMatrix::from_row_slice(instants.len(), degree + 1, &values);
    &identity - design * polynomial.coefficients(&identity)
}

/// All `R_m`, up to one element of O(D), and the mean square of what is not polynomial, m^2.
fn common_frames(snapshots: &[DMatrix<f64>], residual: &DMatrix<f64>) -> Result<(Vec<DMatrix<f64>>, f64)> {
    let (count, (dimension, nodes)) = (snapshots.len(), snapshots[0].shape());
    let mut equations = DMatrix::zeros(count * nodes, count * dimension);
    for (m, snapshot) in snapshots.iter().enumerate() {
        for q in 0..count {
            let block = snapshot.transpose() * residual[(m, q)];
            equations.view_mut((q * nodes, m * dimension), (nodes, dimension)).copy_from(&block);
        }
    }
    // Not by the eigenvectors of the square, which would lose half the digits.
    let svd = equations.svd(false, true);
    let right = svd.v_t.expect("it was asked for");
    let least = |i: usize| count * dimension - 1 - i;
    let frame = |m: usize| {
        nearest_orthogonal(&DMatrix::from_fn(dimension, dimension, |i, j| {
            right[(least(i), m * dimension + j)]
        }))
    };
    let left: f64 = (0..dimension).map(|i| svd.singular_values[least(i)]).map(|value| value * value).sum();
    let frames = (0..count).map(frame).collect::<Result<Vec<_>>>()?;
    Ok((frames, left / (dimension * nodes) as f64))
}
