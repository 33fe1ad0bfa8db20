//! The set-up of \[L\] Sec. VII.

use alloc::vec;

use super::base;
use crate::math::float::radians;
use crate::math::rotation::Rotation;
use crate::model::document::entries::{PoseEntries, rows};
use crate::model::noise::RangeNoise;
use crate::model::scenario::{InitialSettings, MotionSettings, RedrawAnchors, Scenario};

/// Uniform in the cube of half width 500 m; of 201 draws the one whose UC-CRB of the orientation is the median
/// (`localization_cube_500` of the specification's `paper-anchors.json`).
const ANCHORS: [[f64; 3]; 4] =
    [[364.7, -285.7, -119.4], [-225.2, 312.0, -466.1], [380.9, 59.64, 81.83], [-440.7, 337.0, 147.8]];

/// Along the edges of a pyramid of 5 x 5 x 5 m around their centroid: its vertices, the middles of the four edges that rise
/// and of one at the base.
const PYRAMID: [[f64; 3]; 10] = [
    [-2.5, -2.25, -1.5],
    [2.5, -2.25, -1.5],
    [2.5, 2.75, -1.5],
    [-2.5, 2.75, -1.5],
    [0.0, 0.25, 3.5],
    [-1.25, -1.0, 1.0],
    [1.25, -1.0, 1.0],
    [1.25, 1.5, 1.0],
    [-1.25, 1.5, 1.0],
    [0.0, -2.25, -1.5],
];

pub fn fixed() -> Scenario {
    let turn = |axis: usize, angle: f64| {
        let mut phi = [0.0; 3];
        phi[axis] = radians(angle);
        Rotation::<3>::exp(&phi)
    };
    let rotation = turn(2, 10.0).compose(&turn(1, -25.0)).compose(&turn(0, 20.0));
    let start = PoseEntries { orientation: rows(rotation.matrix()), position: vec![100.0, 100.0, 55.0] };
    let scenario = base("localization-paper", &ANCHORS, &PYRAMID, RangeNoise::Toa { zeta_db: 60.0 });
    // A filter that starts here knows nothing: the prior reaches from the origin to the body and beyond.
    let initial = InitialSettings { covariance: 1e6, ..scenario.initial };
    let still = MotionSettings {
        velocity: vec![0.0; 3],
        angular_velocity: vec![0.0; 3],
        ..MotionSettings::default()
    };
    Scenario { start, initial, motion: still, ..scenario }
}

pub fn redrawn() -> Scenario {
    Scenario {
        name: "localization-paper-redrawn".into(),
        redraw_anchors: Some(RedrawAnchors { half_width: 500.0 }),
        ..fixed()
    }
}
