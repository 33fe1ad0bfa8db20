//! The room again, with one thing changed.

use alloc::vec;
use alloc::vec::Vec;

use super::indoor::{CEILING, HAND, room, walked};
use crate::math::pose::Pose;
use crate::math::rotation::{Manifold, Rotation};
use crate::model::document::entries::PoseEntries;
use crate::model::scenario::Scenario;

/// Four sensors on a rod of 1.2 m.
const ROD: [[f64; 3]; 4] = [[-0.6, 0.0, 0.0], [-0.2, 0.0, 0.0], [0.2, 0.0, 0.0], [0.6, 0.0, 0.0]];

/// The start of the room, turned.
fn start(rotation: Rotation<3>) -> PoseEntries {
    Pose { rotation, position: [1.6, 1.4, 1.1].into() }.into()
}

/// Turned to the left, then rolled about the body's x axis.
fn rolled(roll: f64) -> Rotation<3> {
    Rotation::exp(&[0.0, 0.0, 0.35]).compose(&Rotation::exp(&[roll, 0.0, 0.0]))
}

/// On its back, which the prior denies; the estimators' third row of `Q` comes from the prior alone.
pub fn mirrored() -> Scenario {
    let mut scenario = walked("mirrored", &CEILING[..4]);
    scenario.start = start(rolled(2.8));
    scenario.initial.covariance = 0.3;
    scenario.estimators.manifold = Manifold::O;
    scenario
}

pub fn missing_ranges() -> Scenario {
    Scenario { name: "missing-ranges".into(), missing_probability: 0.4, ..room() }
}

pub fn small_body() -> Scenario {
    let sensors = HAND.iter().map(|sensor| sensor.map(|x| 0.1 * x).to_vec()).collect();
    Scenario { name: "small-body".into(), sensors, ..room() }
}

/// Rolled by a radian, which no range tells and the prior does not know.
pub fn rod() -> Scenario {
    let mut scenario = Scenario { name: "rod".into(), start: start(rolled(1.0)), ..room() };
    scenario.sensors = ROD.iter().map(|sensor| sensor.to_vec()).collect();
    scenario.motion.angular_velocity = vec![0.0, 0.0, 0.3];
    scenario
}

pub fn overconfident() -> Scenario {
    let mut scenario = Scenario { name: "overconfident".into(), ..room() };
    scenario.process.sigma_q *= 0.1;
    scenario.process.sigma_t *= 0.1;
    scenario
}

pub fn wide_prior() -> Scenario {
    let rotation = Rotation::exp(&[0.3, -0.2, 2.8]);
    let mut scenario = Scenario { name: "wide-prior".into(), start: start(rotation), ..room() };
    scenario.initial.position = Vec::from([4.6, 4.0, 1.6]);
    scenario.initial.covariance = 1e4;
    scenario
}
