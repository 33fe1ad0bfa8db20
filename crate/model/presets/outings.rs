//! Longer ways: along a path, or down a corridor.

use alloc::vec;
use alloc::vec::Vec;

use super::indoor::ROBOT;
use super::{base, moving};
use crate::math::pose::Pose;
use crate::math::rotation::Rotation;
use crate::model::noise::RangeNoise;
use crate::model::path::{PathSettings, Side};
use crate::model::scenario::{MotionSettings, Scenario};

/// Around the entrance of a hall of 22 x 8 m.
const ENTRANCE: [[f64; 2]; 4] = [[0.3, 0.4], [0.4, 7.6], [4.5, 0.3], [4.2, 7.7]];

/// On towers at the corners of a field.
const TOWERS: [[f64; 3]; 4] = [[2.0, 3.0, 8.0], [38.0, 2.0, 12.0], [37.0, 38.0, 9.0], [3.0, 37.0, 11.0]];

/// A drone of 1.2 x 0.8 m.
const DRONE: [[f64; 3]; 5] =
    [[-0.6, -0.4, -0.15], [0.6, -0.4, -0.15], [0.6, 0.4, -0.15], [-0.6, 0.4, -0.15], [0.0, 0.0, 0.6]];

/// Along the middle of a corridor of 32 x 3 m.
const LAMPS: [[f64; 2]; 5] = [[0.5, 1.6], [8.0, 1.5], [16.0, 1.62], [24.0, 1.48], [31.5, 1.58]];

/// Once through an eight, the first circle towards the anchors. Ranges are good to half a percent of their length.
pub fn figure_eight() -> Scenario {
    let mut scenario = base("figure-eight", &ENTRANCE, &ROBOT, RangeNoise::Toa { zeta_db: 46.0 });
    scenario.interval = 0.5;
    scenario.steps = 80;
    let quarter = core::f64::consts::FRAC_PI_2;
    scenario.start =
        Pose::<2> { rotation: Rotation::exp(&[quarter, 0.0, 0.0]), position: [12.5, 4.0].into() }.into();
    scenario.initial.position = Vec::from([8.0, 4.0]);
    let path = PathSettings::FigureEight { radius: 3.0, period: 40.0 };
    moving(scenario, following(path, 2))
}

/// Three turns of ten metres' climb each, from the height of the towers to four times that.
pub fn towers() -> Scenario {
    let mut scenario = base("towers", &TOWERS, &DRONE, RangeNoise::Range { sigma: 0.05 });
    scenario.interval = 0.5;
    scenario.steps = 120;
    scenario.start.position = Vec::from([20.0, 10.0, 9.0]);
    scenario.initial.position = Vec::from([20.0, 20.0, 10.0]);
    let path = PathSettings::Helix { radius: 10.0, period: 20.0, climb: 10.0, side: Side::Left };
    moving(scenario, following(path, 3))
}

fn following(path: PathSettings, dimension: usize) -> MotionSettings {
    MotionSettings {
        velocity: vec![0.0; dimension],
        angular_velocity: vec![0.0; crate::math::rotation::rotation_angles(dimension)],
        path: Some(path),
        sigma_omega: 0.05,
        sigma_t: 0.02,
    }
}

pub fn corridor() -> Scenario {
    let mut scenario = base("corridor", &LAMPS, &ROBOT, RangeNoise::Range { sigma: 0.05 });
    scenario.interval = 0.5;
    scenario.steps = 40;
    scenario.start.position = Vec::from([3.0, 0.8]);
    scenario.initial.position = Vec::from([3.0, 1.2]);
    scenario.initial.covariance = 4.0;
    moving(
        scenario,
        MotionSettings {
            velocity: vec![1.2, 0.0],
            angular_velocity: vec![0.0],
            sigma_omega: 0.1,
            sigma_t: 0.02,
            ..MotionSettings::default()
        },
    )
}
