//! The paths of the paper (\[I\] Fig. 3), made into motions: the body looks along its way.

use alloc::vec::Vec;

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use super::profile::Profile;
use crate::math::float::{cos, floor, radians, sin};
use crate::math::rotation::{Rotation, hat};

/// A path by its name. Speed and angles change by quintic smooth steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "lowercase")]
pub enum IndoorPath {
    /// 10 s: straight on, half a turn to the left, and back.
    #[default]
    U,
    /// 5 s: forty degrees to the left, to the right, left and right again.
    Zigzag,
    /// 5 s: up, level, down, level.
    Bridge,
    /// 85 s: five flights up at thirty degrees, four landings with half a turn each.
    Stair,
    /// 10 s at rest.
    Static,
    /// 10 s of yaw, pitch and roll at once: the test of what is more than a planar turn.
    Tumble,
}

impl IndoorPath {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 6] = [Self::U, Self::Zigzag, Self::Bridge, Self::Stair, Self::Static, Self::Tumble];

    /// Length, s.
    pub fn duration(self) -> f64 {
        match self {
            Self::U | Self::Static | Self::Tumble => 10.0,
            Self::Zigzag | Self::Bridge => 5.0,
            Self::Stair => 85.0,
        }
    }
}

/// The true motion at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics {
    /// `world_from_body`.
    pub rotation: Rotation<3>,
    /// Position of the body's origin in the world frame, m.
    pub position: Vector3<f64>,
    /// Its velocity in the world frame, m/s.
    pub velocity: Vector3<f64>,
    /// Its acceleration in the world frame, m/s^2.
    pub acceleration: Vector3<f64>,
    /// Angular velocity in the body frame, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// Its derivative, rad/s^2.
    pub angular_acceleration: Vector3<f64>,
}

impl Kinematics {
    /// `Omega^2 + hat(alpha)`: what a point of the body is accelerated by beyond the origin, in the body frame.
    pub fn lever(&self) -> Matrix3<f64> {
        let omega: Matrix3<f64> = hat(&self.angular_velocity.into());
        omega * omega + hat::<3>(&self.angular_acceleration.into())
    }

    /// Velocity of a point of the body in the world frame, m/s.
    pub fn velocity_of(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.velocity + self.rotation.matrix() * self.angular_velocity.cross(point)
    }

    /// Acceleration of a point of the body in the world frame, m/s^2.
    pub fn acceleration_of(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.acceleration + self.rotation.matrix() * (self.lever() * point)
    }
}

/// Speed along the body's first axis, and its attitude `Rz(yaw) Ry(-pitch) Rx(roll)`.
struct Course {
    speed: Profile,
    yaw: Profile,
    pitch: Profile,
    roll: Profile,
}

/// Steps in degrees.
fn turns(start: f64, steps: &[(f64, f64, f64)]) -> Profile {
    let steps: Vec<_> = steps.iter().map(|&(from, to, degrees)| (from, to, radians(degrees))).collect();
    Profile::through(radians(start), &steps)
}

impl Course {
    fn of(path: IndoorPath) -> Self {
        let level = || Profile::constant(0.0);
        let (speed, yaw, pitch, roll) = match path {
            IndoorPath::U => {
                let speed = Profile::through(0.0, &[(0.0, 1.0, 1.2), (9.0, 10.0, 0.0)]);
                (speed, turns(0.0, &[(3.5, 6.5, 180.0)]), level(), level())
            }
            IndoorPath::Zigzag => {
                let bends = [(1.0, 1.8, -40.0), (2.1, 2.9, 40.0), (3.2, 4.0, -40.0)];
                (short_way(), turns(40.0, &bends), level(), level())
            }
            IndoorPath::Bridge => {
                let slopes = [(0.8, 1.4, 30.0), (1.9, 2.5, 0.0), (2.5, 3.1, -30.0), (3.6, 4.2, 0.0)];
                (short_way(), level(), turns(0.0, &slopes), level())
            }
            IndoorPath::Stair => (Profile::constant(0.5), landings(), flights(), level()),
            IndoorPath::Static => (level(), level(), level(), level()),
            IndoorPath::Tumble => tumble(),
        };
        Self { speed, yaw, pitch, roll }
    }

    /// All but the position.
    fn at(&self, time: f64) -> Kinematics {
        let ([yaw, yaw1, yaw2], [pitch, pitch1, pitch2]) = (self.yaw.at(time), self.pitch.at(time));
        let ([roll, roll1, roll2], [speed, speed1, _]) = (self.roll.at(time), self.speed.at(time));
        let about = |axis: usize, angle: f64| {
            let mut phi = [0.0; 3];
            phi[axis] = angle;
            *Rotation::<3>::exp(&phi).matrix()
        };
        let rotation = about(2, yaw) * about(1, -pitch) * about(0, roll);
        // The axes of pitch and yaw in the body frame, and how they move in it.
        let (sr, cr, sp, cp) = (sin(roll), cos(roll), sin(pitch), cos(pitch));
        let pitch_axis = Vector3::new(0.0, cr, -sr);
        let pitch_axis1 = Vector3::new(0.0, -sr, -cr) * roll1;
        let yaw_axis = Vector3::new(sp, sr * cp, cr * cp);
        let yaw_axis1 =
            Vector3::new(0.0, cr, -sr) * (roll1 * cp) + Vector3::new(cp, -sr * sp, -cr * sp) * pitch1;
        let angular_velocity = Vector3::x() * roll1 - pitch_axis * pitch1 + yaw_axis * yaw1;
        let angular_acceleration = Vector3::x() * roll2 - pitch_axis * pitch2 - pitch_axis1 * pitch1
            + yaw_axis * yaw2
            + yaw_axis1 * yaw1;
        let in_body = Vector3::x() * speed1 + angular_velocity.cross(&Vector3::x()) * speed;
        Kinematics {
            rotation: Rotation::from_matrix_unchecked(rotation),
            position: Vector3::zeros(),
            velocity: rotation * Vector3::x() * speed,
            acceleration: rotation * in_body,
            angular_velocity,
            angular_acceleration,
        }
    }
}

/// Speed of zigzag and bridge.
fn short_way() -> Profile {
    Profile::through(0.0, &[(0.0, 0.6, 1.5), (4.4, 5.0, 0.0)])
}

const FLIGHT: f64 = 13.0;
const LANDING: f64 = 5.0;
const LANDINGS: usize = 4;

/// Half a turn on each landing, to the left and to the right in turn.
fn landings() -> Profile {
    let half_turn = |i: usize| {
        let from = FLIGHT + i as f64 * (FLIGHT + LANDING);
        (from, from + LANDING, if i.is_multiple_of(2) { 180.0 } else { 0.0 })
    };
    turns(0.0, &(0..LANDINGS).map(half_turn).collect::<Vec<_>>())
}

/// Level on the landings: the slope begins to change a little before the flight ends.
const EASING: f64 = 1.32;
const EASING_ON_FLIGHT: f64 = 0.4 * EASING;

fn flights() -> Profile {
    let landing = |i: usize| {
        let begin = FLIGHT + i as f64 * (FLIGHT + LANDING) - EASING_ON_FLIGHT;
        let end = begin + LANDING + 2.0 * EASING_ON_FLIGHT;
        [(begin, begin + EASING, 0.0), (end - EASING, end, 30.0)]
    };
    turns(30.0, (0..LANDINGS).map(landing).collect::<Vec<_>>().as_flattened())
}

fn tumble() -> (Profile, Profile, Profile, Profile) {
    let speed = Profile::through(0.0, &[(0.0, 1.0, 1.0), (9.0, 10.0, 0.0)]);
    let yaw = turns(0.0, &[(1.0, 5.0, 180.0), (5.0, 9.0, 0.0)]);
    let pitch = turns(0.0, &[(1.0, 3.0, 40.0), (3.5, 6.5, -40.0), (7.0, 9.0, 0.0)]);
    let roll = turns(0.0, &[(1.5, 4.5, 90.0), (5.0, 8.5, 0.0)]);
    (speed, yaw, pitch, roll)
}

/// Nodes and weights of Gauss-Legendre integration on [-1, 1], exact up to degree 9.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// The motion at times `0, T, .., N T` from the origin on, `N` being the whole intervals in the path.
pub fn kinematics(path: IndoorPath, interval: f64) -> Vec<Kinematics> {
    let course = Course::of(path);
    let steps = steps(path, interval);
    let mut position = Vector3::zeros();
    let mut states = Vec::with_capacity(steps + 1);
    for k in 0..=steps {
        let time = k as f64 * interval;
        states.push(Kinematics { position, ..course.at(time) });
        let middle = time + 0.5 * interval;
        for (node, weight) in GAUSS {
            position += course.at(middle + 0.5 * interval * node).velocity * (0.5 * interval * weight);
        }
    }
    states
}

/// How many whole intervals there are in a path.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a path is short and the interval positive"
)]
pub fn steps(path: IndoorPath, interval: f64) -> usize {
    // A path of exactly N intervals has N of them, whatever rounding says.
    floor(path.duration() / interval + 1e-9) as usize
}
