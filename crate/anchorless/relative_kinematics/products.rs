//! \[A\] eqs. 16 to 18 in the plane: a linear system in the six products of `(h_1, h_2)` and `(1, u_1, u_2)`.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::SecondStage;
use super::lyapunov::{Lyapunov, Sides, skew};
use crate::error::{Error, Result};
use crate::math::float::sqrt;

/// How `h` and `u` are read off the products.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// `u_1 = phi_3/phi_1`, `u_2 = phi_6/phi_2`, as printed.
    Literal,
    /// `u` from all four products, weighted by `h`: no divisor is small.
    Rank1,
}

/// A diagonal entry of the triangle below this part of the largest: a product is not seen.
const RANK: f64 = 1e-10;

/// Both branches, with `H` a rotation and with it a reflection; the one whose products, made feasible, fit better.
pub fn solve(sides: &Sides, reading: Reading) -> Result<SecondStage> {
    let proper = branch(sides, reading)?;
    let mut mirrored = branch(&sides.mirrored(), reading)?;
    // `Yh_2` was mirrored, so its rotation is followed by the mirror.
    mirrored.rotation.column_mut(0).neg_mut();
    Ok(if mirrored.cost < proper.cost { mirrored } else { proper })
}

fn branch(sides: &Sides, reading: Reading) -> Result<SecondStage> {
    let first = &sides.first;
    // Y_1 = P + u_1 E_1 + u_2 E_2 with u = (Z_1[1, 0], Z_1[0, 1]).
    let unit = |i: usize, j: usize| first.left.column(i) * first.right.column(j).transpose();
    let parts = [first.known(), unit(1, 0), unit(0, 1)];
    // H^T = h_1 I - h_2 J.
    let minus_j = -skew(2, 0);
    let columns: Vec<DVector<f64>> = [
        observed(&sides.second, &parts[0]),
        observed(&sides.second, &(&minus_j * &parts[0])),
        observed(&sides.second, &parts[1]),
        observed(&sides.second, &parts[2]),
        observed(&sides.second, &(&minus_j * &parts[1])),
        observed(&sides.second, &(&minus_j * &parts[2])),
    ]
    .into();
    let system = DMatrix::from_columns(&columns);
    let target = observed(&sides.second, &sides.second.known());
    let products = least_squares(&system, &target)?;
    let (h, u) = read(&products, reading)?;
    // The branch is judged at the feasible point next to the products, by whatever way they are read: the linear residual
    // cannot tell the branches apart for five nodes, and a division by nearly zero must not decide either.
    let (_, next) = read(&products, Reading::Rank1)?;
    let feasible = [h[0], h[1], h[0] * next[0], h[0] * next[1], h[1] * next[0], h[1] * next[1]];
    Ok(SecondStage {
        velocities: &parts[0] + &parts[1] * u[0] + &parts[2] * u[1],
        rotation: DMatrix::from_row_slice(2, 2, &[h[0], -h[1], h[1], h[0]]),
        cost: (system * DVector::from_row_slice(&feasible) - target).norm_squared(),
        iterations: 0,
    })
}

/// What the second equation knows of a candidate for `H^T Y_1`: the diagonal of its `Z_1` and its `Z_2`.
fn observed(second: &Lyapunov, candidate: &DMatrix<f64>) -> DVector<f64> {
    let turned = second.left.transpose() * candidate;
    let inner = &turned * &second.right;
    let outer = turned - &inner * second.right.transpose();
    DVector::from_iterator(inner.nrows() + outer.len(), inner.diagonal().iter().chain(outer.iter()).copied())
}

fn least_squares(system: &DMatrix<f64>, target: &DVector<f64>) -> Result<DVector<f64>> {
    super::lifted::least_squares(system, target, RANK).ok_or(Error::Degenerate {
        what: "the system of eq. 17",
        value: 0.0,
        reason: "Its matrix W lost its rank: the nodes lie or move too regularly.",
    })
}

/// `h` of length 1 and `u`.
fn read(phi: &DVector<f64>, reading: Reading) -> Result<([f64; 2], [f64; 2])> {
    let squared = phi[0] * phi[0] + phi[1] * phi[1];
    let u = match reading {
        Reading::Literal => [phi[2] / phi[0], phi[5] / phi[1]],
        Reading::Rank1 => {
            [(phi[0] * phi[2] + phi[1] * phi[4]) / squared, (phi[0] * phi[3] + phi[1] * phi[5]) / squared]
        }
    };
    let length = sqrt(squared);
    if !(u[0].is_finite() && u[1].is_finite() && length > 0.0) {
        let reason = "One of h_1 and h_2 is zero, and eq. 18 divides by it.";
        return Err(Error::Degenerate { what: "the solution of eq. 18", value: squared, reason });
    }
    Ok(([phi[0] / length, phi[1] / length], u))
}
