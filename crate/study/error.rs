//! The error of one step against the truth.

use nalgebra::{SMatrix, SVector};

use crate::math::float::{atan2, sqrt};
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::{Manifold, Rotation};
use crate::track::filter::Step;

/// Error of a reported pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseError<const D: usize> {
    /// `Q_hat - Q`, of the matrix as reported.
    pub orientation: SMatrix<f64, D, D>,
    /// `t_hat - t`, m.
    pub position: SVector<f64, D>,
    /// Geodesic angle between the polar factor of `Q_hat` over SO(D) and `Q`, rad.
    pub angle: f64,
    /// Mean over the columns of the angle between `q_i` and `q_hat_i`, rad: what the paper's MAE averages before its root.
    pub column_angle: f64,
}

impl<const D: usize> PoseError<D> {
    /// Measures a step against the true pose.
    pub fn of(step: &Step<D>, truth: &Pose<D>) -> Self {
        Self::between(&step.posterior, truth)
    }

    /// Measures `[Q | t]` against the true pose.
    pub fn between(theta: &Theta<D>, truth: &Pose<D>) -> Self {
        let nearest = Rotation::project(&theta.orientation, Manifold::So);
        let rotation = truth.rotation.matrix();
        let columns = (0..D).map(|j| {
            angle_between(&theta.orientation.column(j).into_owned(), &rotation.column(j).into_owned())
        });
        Self {
            orientation: theta.orientation - rotation,
            position: theta.position - truth.position,
            angle: nearest.inverse().compose(&truth.rotation).angle(),
            column_angle: columns.sum::<f64>() / D as f64,
        }
    }
}

/// Angle between two vectors, accurate also where it is small; `pi/2` if one of them vanishes.
fn angle_between<const D: usize>(a: &SVector<f64, D>, b: &SVector<f64, D>) -> f64 {
    let (length_a, length_b) = (sqrt(a.norm_squared()), sqrt(b.norm_squared()));
    if length_a == 0.0 || length_b == 0.0 {
        return core::f64::consts::FRAC_PI_2;
    }
    let (a, b) = (a / length_a, b / length_b);
    2.0 * atan2(sqrt((a - b).norm_squared()), sqrt((a + b).norm_squared()))
}
