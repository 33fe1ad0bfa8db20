//! From the place of the IMU to the origin of the body (\[I\] appendix, corrected).

use nalgebra::{Matrix3, Vector3};

use crate::math::rotation::hat;
use crate::model::imu::{Input, LeverArmCorrection};
use crate::model::indoor::epoch::{IndoorEpoch, IndoorModel};

/// The input of an epoch at the body's origin; `rotation` is the one believed, which only the printed formula uses.
///
/// ```text
/// a_c = a_imu - (Omega^2 + hat(alpha)) z,     alpha = (omega_next - omega) / T
/// ```
pub fn input(model: &IndoorModel, epoch: &IndoorEpoch, rotation: &Matrix3<f64>) -> Input {
    let (sample, z) = (&epoch.sample, &model.lever_arm);
    let mut input = Input {
        angular_velocity: sample.angular_velocity,
        acceleration: sample.acceleration,
        angular_velocity_variance: model.angular_velocity_variance,
        acceleration_covariance: Matrix3::identity() * model.acceleration_variance,
    };
    if *z == Vector3::zeros() || model.lever_arm_correction == LeverArmCorrection::Ignored {
        return input;
    }
    let angular_acceleration = (epoch.next_angular_velocity - sample.angular_velocity) / epoch.interval;
    let omega: Matrix3<f64> = hat(&sample.angular_velocity.into());
    let felt = (omega * omega + hat::<3>(&angular_acceleration.into())) * z;
    input.acceleration -= match model.lever_arm_correction {
        LeverArmCorrection::Printed => rotation * felt,
        _ => felt,
    };
    input.acceleration_covariance = acceleration_covariance(
        &sample.angular_velocity,
        z,
        epoch.interval,
        model.angular_velocity_variance,
        model.acceleration_variance,
    );
    input
}

/// Covariance of the corrected acceleration, exact for normal noise (\[I\] eq. 29-34 take its parts for independent):
///
/// ```text
/// s_a^2 I + s_w^2 [(J + Z/T)(J + Z/T)^T + Z Z^T/T^2] + 2 s_w^4 [tr(A_i A_j)]
/// J = (omega . z) I + omega z^T - 2 z omega^T,  Z = hat(z),  A_i = sym(e_i z^T) - z_i I
/// ```
///
/// `omega^T A_i omega` is coordinate i of `Omega^2 z`.
pub fn acceleration_covariance(
    angular_velocity: &Vector3<f64>,
    z: &Vector3<f64>,
    interval: f64,
    angular_velocity_variance: f64,
    acceleration_variance: f64,
) -> Matrix3<f64> {
    let (w, identity) = (angular_velocity, Matrix3::identity());
    let slope = identity * w.dot(z) + w * z.transpose() - z * w.transpose() * 2.0;
    let turn = hat::<3>(&(*z).into()) / interval;
    let both = slope + turn;
    let form = |i: usize| {
        let unit = Vector3::from_fn(|k, _| f64::from(u8::from(k == i)));
        (unit * z.transpose() + z * unit.transpose()) * 0.5 - identity * z[i]
    };
    let forms: [Matrix3<f64>; 3] = core::array::from_fn(form);
    let traces = Matrix3::from_fn(|i, j| (forms[i] * forms[j]).trace());
    let (first, second) =
        (angular_velocity_variance, 2.0 * angular_velocity_variance * angular_velocity_variance);
    identity * acceleration_variance
        + (both * both.transpose() + turn * turn.transpose()) * first
        + traces * second
}
