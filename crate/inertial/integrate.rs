//! Exact integration of inputs that are held in the body frame over an interval.

use nalgebra::{Matrix3, Vector3};

use super::filter::ErrorMatrix;
use crate::math::exponential_integral::ExponentialIntegral;
use crate::math::rotation::{Rotation, hat};
use crate::model::imu::Input;
use crate::model::indoor::epoch::NavigationState;

/// One interval with its held input.
///
/// ```text
/// R' = R Exp(T omega)
/// v' = v + T R G_1(T omega) a + T g
/// p' = p + T v + T^2 R G_2(T omega) a + T^2 g/2
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    /// `T`, s.
    pub length: f64,
    /// `Exp(T omega)`.
    pub turn: Matrix3<f64>,
    /// `T G_1 a`, m/s, in the body frame at the beginning.
    pub velocity: Vector3<f64>,
    /// `T^2 G_2 a`, m.
    pub position: Vector3<f64>,
    gravity: Vector3<f64>,
    input: Input,
    integral: ExponentialIntegral,
}

impl Interval {
    /// Works out the integrals.
    pub fn new(length: f64, input: &Input, gravity: &Vector3<f64>) -> Self {
        let integral = ExponentialIntegral::new(&(input.angular_velocity * length));
        Self {
            length,
            turn: integral.exponential(),
            velocity: integral.first() * input.acceleration * length,
            position: integral.second() * input.acceleration * (length * length),
            gravity: *gravity,
            input: *input,
            integral,
        }
    }

    /// The state at the end.
    pub fn apply(&self, state: &NavigationState) -> NavigationState {
        let (r, t) = (state.rotation.matrix(), self.length);
        NavigationState {
            rotation: Rotation::from_matrix_unchecked(r * self.turn).renormalized(),
            position: state.position + state.velocity * t + r * self.position + self.gravity * (0.5 * t * t),
            velocity: state.velocity + r * self.velocity + self.gravity * t,
        }
    }

    /// `d(error after)/d(error before)` on `(phi, p, v)`, the rotation being `R` before.
    pub fn transition(&self, rotation: &Matrix3<f64>) -> ErrorMatrix {
        let mut f = ErrorMatrix::identity();
        set(&mut f, 0, 0, &self.turn.transpose());
        set(&mut f, 3, 0, &(rotation * hat::<3>(&self.position.into()) * -1.0));
        set(&mut f, 3, 6, &(Matrix3::identity() * self.length));
        set(&mut f, 6, 0, &(rotation * hat::<3>(&self.velocity.into()) * -1.0));
        f
    }

    /// What the noise of the input adds to the covariance.
    pub fn noise(&self, rotation: &Matrix3<f64>) -> ErrorMatrix {
        let b = self.input_jacobian(rotation);
        let mut q = ErrorMatrix::zeros();
        for i in 0..3 {
            for j in 0..3 {
                let turning = b[i][0] * b[j][0].transpose() * self.input.angular_velocity_variance;
                let moving = b[i][1] * self.input.acceleration_covariance * b[j][1].transpose();
                set(&mut q, 3 * i, 3 * j, &(turning + moving));
            }
        }
        q
    }

    /// The derivative of the error after by the input, `(omega, a)`, block by block.
    pub fn input_jacobian(&self, rotation: &Matrix3<f64>) -> [[Matrix3<f64>; 2]; 3] {
        let (t, a) = (self.length, &self.input.acceleration);
        let integral = &self.integral;
        [
            [integral.right_jacobian() * t, Matrix3::zeros()],
            [rotation * integral.second_derivative(a) * (t * t * t), rotation * integral.second() * (t * t)],
            [rotation * integral.first_derivative(a) * (t * t), rotation * integral.first() * t],
        ]
    }
}

/// Sets the 3 x 3 block whose first entry is `(i, j)`.
pub(super) fn set(matrix: &mut ErrorMatrix, i: usize, j: usize, block: &Matrix3<f64>) {
    for row in 0..3 {
        for column in 0..3 {
            matrix[(i + row, j + column)] = block[(row, column)];
        }
    }
}
