//! The set-up of \[T\] Sec. V.

use alloc::vec;

use super::{base, moving};
use crate::math::float::radians;
use crate::model::noise::RangeNoise;
use crate::model::scenario::{MotionSettings, RedrawAnchors, Scenario};

/// Uniform in the cube of half width 1000 m; of 201 draws the one whose bound on the orientation is the median.
const ANCHORS: [[f64; 3]; 4] =
    [[-753.8, 161.8, 701.8], [-680.5, -511.0, 387.2], [-169.7, -647.0, -208.3], [703.6, 218.6, 968.2]];

/// The vertices of a pyramid of 1 x 1 x 1 m around their centroid.
const PYRAMID: [[f64; 3]; 5] =
    [[-0.5, -0.5, -0.2], [0.5, -0.5, -0.2], [0.5, 0.5, -0.2], [-0.5, 0.5, -0.2], [0.0, 0.0, 0.8]];

pub fn fixed() -> Scenario {
    let noise = RangeNoise::SquaredRange { sigma: 0.0316 };
    let mut scenario = moving(
        base("tracking-paper", &ANCHORS, &PYRAMID, noise),
        MotionSettings {
            velocity: vec![1.0; 3],
            angular_velocity: vec![radians(1.0); 3],
            sigma_omega: radians(0.1),
            sigma_t: 1.0,
            ..MotionSettings::default()
        },
    );
    // The paper goes on from the projected orientation.
    scenario.estimators.feedback = true;
    scenario
}

pub fn redrawn() -> Scenario {
    Scenario {
        name: "tracking-paper-redrawn".into(),
        redraw_anchors: Some(RedrawAnchors { half_width: 1000.0 }),
        ..fixed()
    }
}
