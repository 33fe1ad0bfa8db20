//! Paths: undisturbed bodies stay on them to the last digits, and look along them; estimators are told how they move.

#[path = "../support/mod.rs"]
mod support;

mod drawn;
mod motion;
mod shapes;

use nalgebra::SVector;
use rangelab::math::float::{atan2, cos, sin};
use rangelab::math::pose::Pose;
use rangelab::model::path::{PathSettings, Side};
use rangelab::model::presets::preset;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;
use support::sampling::Sampler;

/// A scenario of a body that follows a path undisturbed.
fn undisturbed<const D: usize>(start: Pose<D>, path: PathSettings, interval: f64, steps: usize) -> Scenario {
    let mut scenario = preset(if D == 2 { "planar" } else { "room" }).unwrap();
    scenario.start = start.into();
    scenario.motion.path = Some(path);
    scenario.motion.velocity = vec![0.0; D];
    scenario.motion.angular_velocity.fill(0.0);
    (scenario.motion.sigma_omega, scenario.motion.sigma_t) = (0.0, 0.0);
    Scenario { interval, steps, ..scenario }
}

/// The true poses from the first epoch on.
fn poses<const D: usize>(scenario: &Scenario) -> Vec<Pose<D>> {
    simulate::<D>(scenario, 0).unwrap().truth.into_iter().map(Option::unwrap).collect()
}

/// Where the body looks, seen from above.
fn heading<const D: usize>(pose: &Pose<D>) -> f64 {
    atan2(pose.rotation.matrix()[(1, 0)], pose.rotation.matrix()[(0, 0)])
}

/// An angle brought to `-pi..=pi`.
fn wrapped(angle: f64) -> f64 {
    atan2(sin(angle), cos(angle))
}

/// Any heading, tilted by up to half a radian.
fn start<const D: usize>(sampler: &mut Sampler) -> Pose<D> {
    use rangelab::math::rotation::Rotation;
    let tilt = if D == 2 { [0.0; 3] } else { [sampler.uniform(-0.4, 0.4), sampler.uniform(-0.3, 0.3), 0.0] };
    let angle = sampler.uniform(-3.1, 3.1);
    let turn = if D == 2 { [angle, 0.0, 0.0] } else { [0.0, 0.0, angle] };
    Pose { rotation: Rotation::exp(&turn).compose(&Rotation::exp(&tilt)), position: sampler.vector(3.0) }
}

/// One path of every kind that goes round, in ten seconds.
fn rounds<const D: usize>(sampler: &mut Sampler) -> Vec<PathSettings> {
    let (radius, period) = (sampler.uniform(0.5, 3.0), 10.0);
    let points = (0..7).map(|_| sampler.vector::<D>(3.0).as_slice().to_vec()).collect();
    vec![
        PathSettings::Turn { radius, period, side: Side::Left },
        PathSettings::Turn { radius, period, side: Side::Right },
        PathSettings::FigureEight { radius, period },
        PathSettings::Drawn { points, closed: true, period },
    ]
}

/// The horizontal part.
fn level<const D: usize>(vector: &SVector<f64, D>) -> [f64; 2] {
    [vector[0], vector[1]]
}
