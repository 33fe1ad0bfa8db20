//! What an estimator of relative kinematics found.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::coefficients::RelativeKinematics;

/// The parts that an estimator can give; each one gives its own.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KinematicsEstimate {
    /// `Y_0, ..., Y_L`, centred, up to one element of O(D). `None` for estimators that find no motion.
    pub kinematics: Option<RelativeKinematics>,
    /// The coefficients `B_0, B_1, ...` of `G(t) = X(t)^T X(t) = sum_l B_l t^l`, N x N, m^2/s^l; empty where the estimator
    /// goes another way.
    pub gram: Vec<DMatrix<f64>>,
    /// Positions at each stamp, D x N, each up to its own element of O(D), `None` where distances are missing; only from
    /// estimators that see one epoch at a time.
    pub snapshots: Vec<Option<DMatrix<f64>>>,
    /// `H_2` of \[A\] eq. 13b, or the frame `Q` of the accelerometers (eq. 20); `None` where neither is estimated.
    pub rotation: Option<DMatrix<f64>>,
    /// The least eigenvalue kept of the accelerations' Gram matrix `4 B_4` over its most negative one: below 1 the
    /// accelerations drown in noise. `None` where they are not found from it.
    pub acceleration_margin: Option<f64>,
    /// Value of the cost that chose the solution, in the estimator's own unit.
    pub cost: f64,
    /// Iterations that were made; 0 for closed forms.
    pub iterations: usize,
}
