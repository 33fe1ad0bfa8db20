//! Integrals of the exponential of SO(3): what a constant turn over an interval does to velocity and position.
//!
//! All of them are written on `f_n(theta) = sum_k (-1)^k theta^(2k) / (2k + n + 1)!`, so that
//!
//! ```text
//! Exp(phi) = I   + f_0 K + f_1 K^2          K = hat(phi), theta = ||phi||
//! G_1(phi) = I   + f_1 K + f_2 K^2          G_1 = int_0^1 Exp(s phi) ds
//! G_2(phi) = I/2 + f_2 K + f_3 K^2          G_2 = int_0^1 (1 - s) Exp(s phi) ds
//! ```
//!
//! and `d f_n / d theta = theta ((n + 1) f_(n+2) - f_(n+1))`.

use nalgebra::{Matrix3, Vector3};

use super::factorial::factorial;
use super::float::{cos, sin, sqrt};
use super::rotation::hat;

/// Highest `n` of the `f_n` kept.
const HIGHEST: usize = 5;

/// Below this `theta^2` the power series is summed; above it the recursion loses at most a few digits of `f_5`.
const SERIES: f64 = 4.0;

/// Terms of the series: the next is below `4^14 / 29! = 3e-23` of the sum.
const TERMS: usize = 14;

/// The functions `f_0 .. f_5` at one `theta^2`.
fn functions(theta_squared: f64) -> [f64; HIGHEST + 1] {
    let mut f = [0.0; HIGHEST + 1];
    if theta_squared < SERIES {
        for (n, value) in f.iter_mut().enumerate() {
            *value = series(n, theta_squared);
        }
        return f;
    }
    let theta = sqrt(theta_squared);
    f[0] = sin(theta) / theta;
    f[1] = (1.0 - cos(theta)) / theta_squared;
    let mut inverse_factorial = 1.0;
    for n in 2..=HIGHEST {
        // f_n = (1/(n - 1)! - f_(n-2)) / theta^2
        f[n] = (inverse_factorial - f[n - 2]) / theta_squared;
        inverse_factorial /= n as f64;
    }
    f
}

fn series(n: usize, theta_squared: f64) -> f64 {
    // Horner's scheme on the ratio of neighbouring terms.
    let mut sum = 1.0;
    for k in (1..TERMS).rev() {
        let m = (2 * k + n) as f64;
        sum = 1.0 - sum * theta_squared / (m * (m + 1.0));
    }
    sum / factorial(n + 1)
}

/// `G_1`, `G_2` and their derivatives for one rotation vector.
#[derive(Clone, Copy, Debug)]
pub struct ExponentialIntegral {
    phi: Vector3<f64>,
    hat: Matrix3<f64>,
    f: [f64; HIGHEST + 1],
}

impl ExponentialIntegral {
    /// The integrals for `phi`, rad.
    pub fn new(phi: &Vector3<f64>) -> Self {
        Self { phi: *phi, hat: hat(&(*phi).into()), f: functions(phi.norm_squared()) }
    }

    /// `Exp(phi)`, the same as [`Rotation::exp`](super::rotation::Rotation::exp) up to rounding.
    pub fn exponential(&self) -> Matrix3<f64> {
        self.combination(1.0, 0)
    }

    /// `G_1`, which is also the left Jacobian of SO(3).
    pub fn first(&self) -> Matrix3<f64> {
        self.combination(1.0, 1)
    }

    /// `G_2`.
    pub fn second(&self) -> Matrix3<f64> {
        self.combination(0.5, 2)
    }

    /// The right Jacobian of SO(3), `G_1^T`: `Exp(phi + d) = Exp(phi) Exp(J d) + O(d^2)`.
    pub fn right_jacobian(&self) -> Matrix3<f64> {
        self.first().transpose()
    }

    /// `d(G_1(phi) a)/d phi`.
    pub fn first_derivative(&self, a: &Vector3<f64>) -> Matrix3<f64> {
        self.derivative(1, a)
    }

    /// `d(G_2(phi) a)/d phi`.
    pub fn second_derivative(&self, a: &Vector3<f64>) -> Matrix3<f64> {
        self.derivative(2, a)
    }

    /// `c I + f_n K + f_(n+1) K^2`.
    fn combination(&self, identity: f64, n: usize) -> Matrix3<f64> {
        Matrix3::identity() * identity + self.hat * self.f[n] + self.hat * self.hat * self.f[n + 1]
    }

    /// `d(f_n phi x a + f_(n+1) phi x (phi x a))/d phi`.
    fn derivative(&self, n: usize, a: &Vector3<f64>) -> Matrix3<f64> {
        let (f, phi) = (&self.f, &self.phi);
        let slope = |n: usize| (n as f64 + 1.0) * f[n + 2] - f[n + 1];
        let once = phi.cross(a);
        let twice = phi.cross(&once);
        let of_twice = Matrix3::identity() * phi.dot(a) + phi * a.transpose() - a * phi.transpose() * 2.0;
        hat::<3>(&(*a).into()) * -f[n]
            + of_twice * f[n + 1]
            + once * phi.transpose() * slope(n)
            + twice * phi.transpose() * slope(n + 1)
    }
}
