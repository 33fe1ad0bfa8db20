//! Rooms and halls. The world frame has its origin in a corner of the floor.

use alloc::vec;
use alloc::vec::Vec;

use super::{base, moving};
use crate::math::pose::Pose;
use crate::math::rotation::Rotation;
use crate::model::noise::RangeNoise;
use crate::model::scenario::{MotionSettings, Scenario};

/// Walls of a room of 6 x 5 x 2.8 m, high and low in turn.
const ROOM: [[f64; 3]; 6] =
    [[0.1, 0.1, 2.7], [5.9, 0.2, 0.4], [5.8, 4.9, 2.6], [0.2, 4.8, 0.5], [3.0, 0.1, 1.9], [2.8, 4.9, 1.1]];

/// Hung from the ceiling of the same room.
pub const CEILING: [[f64; 3]; 5] =
    [[0.4, 0.5, 2.70], [5.6, 0.4, 2.65], [5.5, 4.6, 2.72], [0.5, 4.5, 2.68], [3.0, 2.4, 2.64]];

/// As large as a hand: a pyramid around its centroid.
pub const HAND: [[f64; 3]; 5] = [
    [-0.12, -0.08, -0.03],
    [0.12, -0.08, -0.03],
    [0.12, 0.08, -0.03],
    [-0.12, 0.08, -0.03],
    [0.0, 0.0, 0.12],
];

/// Four corners of a hall of 10 x 8 m.
const HALL: [[f64; 2]; 4] = [[0.2, 0.3], [9.8, 0.2], [9.7, 7.8], [0.3, 7.6]];

/// A slender robot of 0.9 x 0.12 m, its nose in front.
pub const ROBOT: [[f64; 2]; 3] = [[-0.3, -0.06], [-0.3, 0.06], [0.6, 0.0]];

pub fn room() -> Scenario {
    walked("room", &ROOM)
}

pub fn ceiling() -> Scenario {
    walked("coplanar-ceiling", &CEILING)
}

pub fn three_anchors() -> Scenario {
    walked("three-anchors", &ROOM[..3])
}

/// Six seconds across the room, ten epochs a second; the estimators start in its middle, unturned.
pub fn walked(name: &str, anchors: &[[f64; 3]]) -> Scenario {
    let mut scenario = base(name, anchors, &HAND, RangeNoise::Range { sigma: 0.01 });
    scenario.interval = 0.1;
    scenario.steps = 60;
    scenario.start =
        Pose::<3> { rotation: Rotation::exp(&[0.1, -0.15, 0.35]), position: [1.6, 1.4, 1.1].into() }.into();
    scenario.initial.position = Vec::from([3.0, 2.5, 1.2]);
    scenario.initial.covariance = 4.0;
    moving(
        scenario,
        MotionSettings {
            velocity: vec![0.4, 0.25, 0.05],
            angular_velocity: vec![0.05, 0.1, 0.3],
            sigma_omega: 0.1,
            sigma_t: 0.01,
            ..MotionSettings::default()
        },
    )
}

pub fn planar() -> Scenario {
    let mut scenario = base("planar", &HALL, &ROBOT, RangeNoise::Range { sigma: 0.03 });
    scenario.interval = 0.25;
    scenario.steps = 40;
    scenario.start =
        Pose::<2> { rotation: Rotation::exp(&[0.4, 0.0, 0.0]), position: [2.0, 2.0].into() }.into();
    scenario.initial.position = Vec::from([5.0, 4.0]);
    moving(
        scenario,
        MotionSettings {
            velocity: vec![0.5, 0.35],
            angular_velocity: vec![0.2],
            sigma_omega: 0.1,
            sigma_t: 0.02,
            ..MotionSettings::default()
        },
    )
}
