//! The paper's state `X = [vec(R); p; v]` of 15 numbers: its motion, its measurement, its noise, all in blocks of 3.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use super::filter::{ErrorMatrix, require_finite};
use crate::error::Result;
use crate::math::rotation::{MAX_ANGLES, Manifold, Rotation, hat};
use crate::model::imu::Input;
use crate::model::indoor::epoch::{IndoorModel, IndoorStart};
use crate::model::indoor::{StartPrior, TRANSMITTERS};

/// Entries of the state.
pub const STATE: usize = 15;

/// `[vec(R); p; v]`, `R` column by column.
pub type State = SVector<f64, STATE>;

/// A covariance of the state.
pub type StateMatrix = SMatrix<f64, STATE, STATE>;

/// What a tangent prior adds to each entry of `vec(R)` so that the covariance has an inverse.
const NORMAL_VARIANCE: f64 = 1e-10;

/// `R` of a state.
pub fn orientation(x: &State) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| x[3 * j + i])
}

/// Sets `R` of a state.
pub fn set_orientation(x: &mut State, r: &Matrix3<f64>) {
    for j in 0..3 {
        for i in 0..3 {
            x[3 * j + i] = r[(i, j)];
        }
    }
}

/// Block `k` of three entries: the columns of `R`, then `p`, then `v`.
pub fn block(x: &State, k: usize) -> Vector3<f64> {
    Vector3::from_fn(|i, _| x[3 * k + i])
}

/// State and covariance before the first epoch.
pub fn start(start: &IndoorStart) -> (State, StateMatrix) {
    let (mut x, mut p) = (State::zeros(), StateMatrix::zeros());
    let rotation = &start.state.rotation;
    set_orientation(&mut x, rotation.matrix());
    x.fixed_rows_mut::<3>(9).copy_from(&start.state.position);
    x.fixed_rows_mut::<3>(12).copy_from(&start.state.velocity);
    match start.prior {
        StartPrior::Isotropic { variance } => p.fill_diagonal(variance),
        StartPrior::Tangent { angle, position, velocity } => {
            for axis in 0..3 {
                let mut direction = State::zeros();
                set_orientation(&mut direction, &rotation.tangent(axis));
                p += direction * direction.transpose() * (angle * angle);
            }
            for i in 0..STATE {
                let deviation = if i < 12 { position } else { velocity };
                p[(i, i)] += if i < 9 { NORMAL_VARIANCE } else { deviation * deviation };
            }
        }
    }
    (x, p)
}

/// The covariance on the tangent space at the rotation next to the state, `A P A^T` with `phi = vee(skew(R^T dR))`.
pub fn tangent_covariance(x: &State, p: &StateMatrix) -> ErrorMatrix {
    let rotation = Rotation::project(&orientation(x), Manifold::So);
    let mut rows = SMatrix::<f64, 9, STATE>::zeros();
    for axis in 0..MAX_ANGLES {
        let direction = rotation.tangent(axis);
        for k in 0..9 {
            // The directions have the length of the square root of 2.
            rows[(axis, k)] = 0.5 * direction[(k % 3, k / 3)];
        }
    }
    for k in 3..9 {
        rows[(k, k + 6)] = 1.0;
    }
    rows * p * rows.transpose()
}

/// One prediction, which is linear in the state (\[I\] eq. 9, 13-16): with `M = I + T hat(omega)`
///
/// ```text
/// R' = R M,  p' = p + T v + T^2/2 R a + T^2/2 g,  v' = v + T R a + T g
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Prediction {
    interval: f64,
    mixing: Matrix3<f64>,
    acceleration: Vector3<f64>,
}

impl Prediction {
    /// The motion itself, which is also its derivative.
    pub fn full(interval: f64, input: &Input) -> Self {
        let turn: Matrix3<f64> = hat(&input.angular_velocity.into());
        Self { interval, mixing: Matrix3::identity() + turn * interval, acceleration: input.acceleration }
    }

    /// The derivative as printed, `F` of \[I\] eq. 15: what `R` does to the input is taken for a constant.
    pub fn frozen(interval: f64) -> Self {
        Self { interval, mixing: Matrix3::identity(), acceleration: Vector3::zeros() }
    }

    /// The product with a state.
    pub fn apply(&self, x: &State) -> State {
        let (r, t) = (orientation(x), self.interval);
        let accelerated = r * self.acceleration;
        let mut next = *x;
        set_orientation(&mut next, &(r * self.mixing));
        for i in 0..3 {
            next[9 + i] += t * x[12 + i] + 0.5 * t * t * accelerated[i];
            next[12 + i] += t * accelerated[i];
        }
        next
    }

    /// `F P F^T`.
    pub fn congruence(&self, p: &StateMatrix) -> StateMatrix {
        let half = self.on_columns(p).transpose();
        self.on_columns(&half)
    }

    fn on_columns(&self, p: &StateMatrix) -> StateMatrix {
        let mut result = StateMatrix::zeros();
        for j in 0..STATE {
            result.set_column(j, &self.apply(&p.column(j).into_owned()));
        }
        result
    }
}

/// Adds what gravity does over an interval.
pub fn fall(x: &mut State, gravity: &Vector3<f64>, interval: f64) {
    for i in 0..3 {
        x[9 + i] += 0.5 * interval * interval * gravity[i];
        x[12 + i] += interval * gravity[i];
    }
}

/// `g(X) Q g(X)^T` of one interval: the block of `vec(R)`, and `R Q_a R^T` from which those of `p` and `v` follow.
#[derive(Clone, Copy, Debug)]
pub struct InputNoise {
    turning: SMatrix<f64, 9, 9>,
    moving: Matrix3<f64>,
}

impl InputNoise {
    /// At an orientation.
    pub fn at(r: &Matrix3<f64>, input: &Input, interval: f64) -> Self {
        // Pi Pi^T in blocks: sum_i (R E_i)_column j (R E_i)_column k^T = delta_jk R R^T - R_k R_j^T.
        let scale = interval * interval * input.angular_velocity_variance;
        let square = r * r.transpose() * scale;
        let mut turning = SMatrix::<f64, 9, 9>::zeros();
        for j in 0..3 {
            for k in 0..3 {
                let mut block = r.column(k) * r.column(j).transpose() * -scale;
                if j == k {
                    block += square;
                }
                turning.fixed_view_mut::<3, 3>(3 * j, 3 * k).copy_from(&block);
            }
        }
        Self { turning, moving: r * input.acceleration_covariance * r.transpose() }
    }

    /// So many times as much.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self { turning: self.turning * factor, moving: self.moving * factor }
    }

    /// `self + weight (other - self)`, where `centre` plays the part of `self` in the difference.
    pub fn add_difference(&mut self, weight: f64, other: &Self, centre: &Self) {
        self.turning += (other.turning - centre.turning) * weight;
        self.moving += (other.moving - centre.moving) * weight;
    }

    /// Adds it to a covariance.
    pub fn add_to(&self, p: &mut StateMatrix, interval: f64) {
        let (t, mut corner) = (interval, p.fixed_view_mut::<9, 9>(0, 0));
        corner += self.turning;
        for (i, j, scale) in [
            (9, 9, 0.25 * t * t * t * t),
            (9, 12, 0.5 * t * t * t),
            (12, 9, 0.5 * t * t * t),
            (12, 12, t * t),
        ] {
            let mut part = p.fixed_view_mut::<3, 3>(i, j);
            part += self.moving * scale;
        }
    }
}

/// The positions of the transmitters, `y_i = p + R c_i` (\[I\] eq. 7), linear in the state.
#[derive(Clone, Copy, Debug)]
pub struct Transmitters {
    places: [Vector3<f64>; TRANSMITTERS],
}

impl Transmitters {
    /// Those of the model.
    pub fn new(model: &IndoorModel) -> Self {
        Self { places: model.transmitters }
    }

    /// `h(X)`.
    pub fn expected(&self, x: &State) -> [Vector3<f64>; TRANSMITTERS] {
        self.places.map(|c| block(x, 3) + orientation(x) * c)
    }

    /// `H x`, with rows of zeros where the mask is zero.
    pub fn apply(&self, x: &State, mask: &[f64; 9]) -> SVector<f64, 9> {
        let expected = self.expected(x);
        SVector::from_fn(|k, _| mask[k] * expected[k / 3][k % 3])
    }

    /// `P H^T`.
    pub fn cross(&self, p: &StateMatrix, mask: &[f64; 9]) -> SMatrix<f64, STATE, 9> {
        let mut result = SMatrix::<f64, STATE, 9>::zeros();
        for j in 0..STATE {
            // P is symmetric: its columns are its rows.
            let row = self.apply(&p.column(j).into_owned(), mask);
            for k in 0..9 {
                result[(j, k)] = row[k];
            }
        }
        result
    }

    /// `H C` for `C = P H^T`.
    pub fn spread(&self, cross: &SMatrix<f64, STATE, 9>, mask: &[f64; 9]) -> SMatrix<f64, 9, 9> {
        let mut result = SMatrix::<f64, 9, 9>::zeros();
        for j in 0..9 {
            result.set_column(j, &self.apply(&cross.column(j).into_owned(), mask));
        }
        result
    }
}

/// Refuses a state that left double precision.
pub fn check(x: &State) -> Result<()> {
    require_finite(x.iter())
}
