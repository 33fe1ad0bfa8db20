//! \[A\] Algorithms 1 and 2: positions and accelerations from Gram matrices, then velocities and the rotation between the
//! two from `B_1` and `B_3`.

mod lifted;
mod lyapunov;
mod products;
mod special_orthogonal;

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::at_least_nodes;
use super::gram_fit::GramFit;
use super::multidimensional_scaling::{Scaling, classical_scaling};
use super::polynomial_fit::{PolynomialFit, powers_of};
use crate::error::{Error, Result};
use crate::math::factorial::factorial;
use crate::model::kinematics::coefficients::{RelativeKinematics, centred_columns};
use crate::model::kinematics::distance_record::DistanceRecord;
use crate::model::kinematics::estimate::KinematicsEstimate;
use lyapunov::Sides;

/// How the second stage finds the velocities and the rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// Eqs. 17 and 18 as printed, divisions included; D = 2.
    Literal,
    /// The same linear system, the six products read as the rank-one matrix `h [1 u_1 u_2]`; D = 2.
    Rank1,
    /// Least squares over O(D).
    So,
    /// Linear in `(H, H Omega_2, Omega)`, `H` put on O(D) afterwards.
    Lifted,
}

/// What the second stage found.
#[derive(Clone, Debug)]
struct SecondStage {
    /// `Y_1`, D x N.
    velocities: DMatrix<f64>,
    /// `H` with `Y_2 = H Yh_2`, in O(D).
    rotation: DMatrix<f64>,
    /// The cost by which it was chosen.
    cost: f64,
    iterations: usize,
}

/// Relative eigenvalue or singular value below which a direction is not there.
const RANK: f64 = 1e-12;

/// \[A\] Algorithm 1: distances alone, constant accelerations (degree 2).
///
/// The expansion is about the middle of the stamps, which is time 0 where they are symmetric, as in the paper; the result
/// is carried to time 0 exactly.
///
/// # Errors
/// [`Error::Number`] for another degree than 2, [`Error::TooFew`] for fewer nodes or stamps than the solver takes,
/// [`Error::Degenerate`] where positions or accelerations do not span the space.
pub fn algorithm_1(record: &DistanceRecord, degree: usize, solver: Solver) -> Result<KinematicsEstimate> {
    const WHAT: &str = "Algorithm 1";
    if degree != 2 {
        let what = "the degree of the motion in Algorithm 1";
        return Err(Error::Number {
            what,
            value: degree as f64,
            limit: "2: it is for constant accelerations",
        });
    }
    enough_nodes(WHAT, record, solver)?;
    let fit = GramFit::new(record, 4)?;
    let powers = fit.scaled_powers();
    let (dimension, size) = (record.dimension(), size(record));
    let positions = spanning(WHAT, classical_scaling(&powers[0], dimension), size, POSITIONS)?;
    let accelerations = classical_scaling(&(&powers[4] * 4.0), dimension);
    let accelerations = spanning(WHAT, accelerations, size, ACCELERATIONS)?;
    let sides =
        Sides::new((&positions.positions, &powers[1]), (&accelerations.positions, &(&powers[3] * 2.0)));
    let found = velocities(&sides, solver)?;
    let scaled = Vec::from([
        positions.positions.clone(),
        found.velocities,
        &found.rotation * &accelerations.positions,
    ]);
    Ok(KinematicsEstimate {
        kinematics: Some(in_seconds(record, scaled)?),
        gram: fit.powers()?,
        rotation: Some(found.rotation),
        acceleration_margin: Some(accelerations.margin()),
        cost: found.cost,
        iterations: found.iterations,
        ..KinematicsEstimate::default()
    })
}

/// \[A\] Algorithm 2: distances and accelerometers, degree 2 or more.
///
/// With `Y~ = Q Y` (eq. 20) what is left of the Gram matrix has degree L + 1, and
/// `L! B~_(L+1) = Y~_L^T Q Y_1 + Y_1^T Q^T Y~_L`; the printed eq. 29 holds for L = 2 alone. The rotation given is `Q`.
///
/// # Errors
/// As [`algorithm_1`]; [`Error::TooFew`] where the record has no accelerations.
pub fn algorithm_2(record: &DistanceRecord, degree: usize, solver: Solver) -> Result<KinematicsEstimate> {
    const WHAT: &str = "Algorithm 2";
    if degree < 2 {
        let what = "the degree of the motion in Algorithm 2";
        return Err(Error::Number {
            what,
            value: degree as f64,
            limit: "2 or more: below it nothing accelerates",
        });
    }
    enough_nodes(WHAT, record, solver)?;
    let sensed = sensed_accelerations(WHAT, record, degree)?;
    let fit = GramFit::less(record, degree + 1, &sensed)?;
    let powers = fit.scaled_powers();
    let scaling = classical_scaling(&powers[0], record.dimension());
    let positions = spanning(WHAT, scaling, size(record), POSITIONS)?;
    let top = sensed.coefficient(degree);
    let sides =
        Sides::new((&positions.positions, &powers[1]), (top, &(&powers[degree + 1] * factorial(degree))));
    sides.check_span(WHAT)?;
    let found = velocities(&sides, solver)?;
    let mut scaled = Vec::from([positions.positions, found.velocities]);
    scaled.extend(sensed.coefficients()[2..].iter().map(|each| &found.rotation * each));
    Ok(KinematicsEstimate {
        kinematics: Some(in_seconds(record, scaled)?),
        gram: sums(fit.powers()?, record.time_scale().unscale(&sensed)?.gram()),
        rotation: Some(found.rotation.transpose()),
        cost: found.cost,
        iterations: found.iterations,
        ..KinematicsEstimate::default()
    })
}

fn velocities(sides: &Sides, solver: Solver) -> Result<SecondStage> {
    match solver {
        Solver::Literal => products::solve(sides, products::Reading::Literal),
        Solver::Rank1 => products::solve(sides, products::Reading::Rank1),
        Solver::So => special_orthogonal::solve(sides),
        Solver::Lifted => lifted::solve(sides),
    }
}

/// The fewest nodes of each solver: by the rank of its linear system, or by the number of exact solutions.
fn enough_nodes(what: &'static str, record: &DistanceRecord, solver: Solver) -> Result<()> {
    let plane = record.dimension() == 2;
    let (needed, reason) = match solver {
        Solver::Literal | Solver::Rank1 if !plane => {
            let limit = "2: in space the products of eq. 17 are not told apart by any number of nodes; take another solver";
            return Err(Error::Number { what: "the dimension", value: record.dimension() as f64, limit });
        }
        Solver::Literal | Solver::Rank1 => (5, "With fewer the matrix W of eq. 17 loses its rank."),
        Solver::So if plane => (3, "With two, several motions fit."),
        Solver::So => (5, "With four, several motions in space fit B_1 and B_3."),
        Solver::Lifted if plane => {
            (6, "Its linear system has nine unknowns, and a node more than five gives enough equations.")
        }
        Solver::Lifted => (9, "Its linear system has 21 unknowns, of which eight nodes in space give 20."),
    };
    at_least_nodes(what, record.nodes(), needed, reason)
}

const POSITIONS: &str =
    "The positions do not span the space: the nodes lie on a line, in a plane or in one point.";
const ACCELERATIONS: &str = "The accelerations relative to each other do not span the space (constant velocities, say, or \
                             all nodes accelerating alike), and the rotation is found from them.";

/// The largest squared distance, m^2: what rounding is measured by.
fn size(record: &DistanceRecord) -> f64 {
    let all = (0..record.stamps().len()).flat_map(|k| record.distances(k).iter().flatten());
    all.fold(0.0, |most, distance| most.max(distance * distance))
}

/// Refuses a Gram matrix with fewer positive eigenvalues than dimensions.
fn spanning(what: &'static str, scaling: Scaling, size: f64, reason: &'static str) -> Result<Scaling> {
    // Where all distances are zero, so is everything found from them.
    let value = if size > 0.0 { scaling.values[scaling.positions.nrows() - 1] / size } else { 0.0 };
    if value > RANK { Ok(scaling) } else { Err(Error::Degenerate { what, value, reason }) }
}

/// `Y~_l`, l >= 2, by least squares (eq. 24), as derivatives by scaled time in its middle; the first two are zero.
fn sensed_accelerations(
    what: &'static str,
    record: &DistanceRecord,
    degree: usize,
) -> Result<RelativeKinematics> {
    let accelerometers = record.needed_accelerometers(what)?;
    let (dimension, nodes, scale) = (record.dimension(), record.nodes(), record.time_scale());
    let stamps: Vec<f64> = record.stamps().iter().map(|&time| scale.scaled(time)).collect();
    let fit = PolynomialFit::new(what, &stamps, degree - 2)?;
    let mut values = DMatrix::zeros(stamps.len(), dimension * nodes);
    for (k, reading) in accelerometers.readings.iter().enumerate() {
        let centred = centred_columns(reading);
        values.row_mut(k).copy_from_slice(centred.as_slice());
    }
    let fitted = fit.coefficients(&values);
    let matrix = |l: usize| DMatrix::from_iterator(dimension, nodes, fitted.row(l).iter().copied());
    let legendre: Vec<DMatrix<f64>> = (0..fitted.nrows()).map(matrix).collect();
    let mut coefficients = Vec::from([DMatrix::zeros(dimension, nodes), DMatrix::zeros(dimension, nodes)]);
    let mut factor = scale.half * scale.half;
    for (l, power) in powers_of(&legendre).iter().enumerate() {
        factor *= l.max(1) as f64;
        coefficients.push(power * factor);
    }
    Ok(RelativeKinematics::from_coefficients(coefficients))
}

/// The coefficients of the sum of two polynomials.
fn sums(mut one: Vec<DMatrix<f64>>, other: Vec<DMatrix<f64>>) -> Vec<DMatrix<f64>> {
    let both = one.len().min(other.len());
    one.iter_mut().zip(&other).for_each(|(one, other)| *one += other);
    one.extend(other.into_iter().skip(both));
    one
}

fn in_seconds(record: &DistanceRecord, scaled: Vec<DMatrix<f64>>) -> Result<RelativeKinematics> {
    let scaled = RelativeKinematics::new(scaled)?;
    Ok(record.time_scale().unscale(&scaled)?.centred())
}
