//! What a perfect IMU would say about an interval.

use nalgebra::Vector3;

use crate::math::exponential_integral::ExponentialIntegral;
use crate::math::linalg::general_inverse;
use crate::model::imu::{Convention, ImuSample};
use crate::model::indoor::trajectory::Kinematics;

/// The exact sample of an interval of length `interval` between two states of the motion, by an IMU at `place` on the
/// body: angular velocity, and acceleration less gravity, both in the body frame.
pub fn exact_sample(
    convention: Convention,
    before: &Kinematics,
    after: &Kinematics,
    interval: f64,
    place: &Vector3<f64>,
    gravity: &Vector3<f64>,
) -> ImuSample {
    let instant = |state: &Kinematics| ImuSample {
        angular_velocity: state.angular_velocity,
        acceleration: state.rotation.matrix().transpose() * (state.acceleration_of(place) - gravity),
    };
    let turn: Vector3<f64> = before.rotation.inverse().compose(&after.rotation).log().into();
    // R^T (dv/T - g): the mean acceleration in the body's axes at the beginning.
    let change = (after.velocity_of(place) - before.velocity_of(place)) / interval - gravity;
    let mean_from_beginning = before.rotation.matrix().transpose() * change;
    match convention {
        Convention::Sample => instant(before),
        Convention::Disc => {
            ImuSample { angular_velocity: turn / interval, acceleration: mean_from_beginning }
        }
        Convention::Mean => {
            let held = ExponentialIntegral::new(&turn).first();
            ImuSample {
                angular_velocity: turn / interval,
                // `G_1` is singular only for whole turns in one interval, which the logarithm never is.
                acceleration: general_inverse(&held) * mean_from_beginning,
            }
        }
        Convention::Trap => {
            let (first, last) = (instant(before), instant(after));
            ImuSample {
                angular_velocity: (first.angular_velocity + last.angular_velocity) * 0.5,
                acceleration: (first.acceleration + last.acceleration) * 0.5,
            }
        }
    }
}
