//! The rules of a scenario.

use alloc::vec::Vec;

use super::{InitialSettings, MotionSettings, Scenario};
use crate::error::Problem;
use crate::math::rotation::rotation_angles;
use crate::model::availability;
use crate::model::document::check::{Check, Limit, MAX_STEPS};
use crate::model::motion::ProcessNoise;
use crate::model::path;

pub fn problems(scenario: &Scenario) -> Vec<Problem> {
    let mut check = Check::default();
    check.version(scenario.version);
    check.name(&scenario.name);
    let dimension = check.dimension(scenario.dimension);
    check.points("anchors", &scenario.anchors, dimension);
    if let Some(redraw) = scenario.redraw_anchors {
        check.number("redraw_anchors.half_width", redraw.half_width, Limit::LENGTH);
    }
    check.points("sensors", &scenario.sensors, dimension);
    check.number("mounting_sigma", scenario.mounting_sigma, Limit::POSITION_NOISE);
    check.noise(&scenario.noise);
    check.number("missing_probability", scenario.missing_probability, Limit::PROBABILITY);
    check.number("interval", scenario.interval, Limit::INTERVAL);
    if !(1..=MAX_STEPS).contains(&scenario.steps) {
        check.problem("steps", scenario.steps, format_args!("1 to {MAX_STEPS}"));
    }
    check.total_ranges("steps", scenario.anchors.len(), scenario.sensors.len(), scenario.steps);
    check.seed(scenario.seed);
    motion(&mut check, &scenario.motion, dimension);
    if let Some(settings) = &scenario.motion.path {
        path::check(&mut check, settings, dimension, &scenario.start.position);
    }
    check.pose("start", &scenario.start, dimension);
    initial(&mut check, &scenario.initial, dimension);
    process(&mut check, &scenario.process);
    scenario.estimators.check(&mut check, "estimators.");
    let anchors = scenario.anchors.len();
    availability::check(&mut check, &scenario.availability, anchors, dimension);
    scenario.field.check(&mut check, dimension);
    scenario.placement.check(&mut check, anchors, dimension);
    scenario.localize.check(&mut check);
    check.view(scenario.view.as_ref());
    check.into_problems()
}

fn motion(check: &mut Check, motion: &MotionSettings, dimension: Option<usize>) {
    let angles = dimension.map(rotation_angles);
    check.vector("motion.velocity", &motion.velocity, dimension, Limit::VELOCITY);
    check.vector("motion.angular_velocity", &motion.angular_velocity, angles, Limit::ANGULAR_VELOCITY);
    check.number("motion.sigma_omega", motion.sigma_omega, Limit::ANGULAR_VELOCITY_NOISE);
    check.number("motion.sigma_t", motion.sigma_t, Limit::POSITION_NOISE);
}

pub(in crate::model) fn initial(check: &mut Check, initial: &InitialSettings, dimension: Option<usize>) {
    check.matrix("initial.orientation", &initial.orientation, dimension);
    check.vector("initial.position", &initial.position, dimension, Limit::COORDINATE);
    check.number("initial.covariance", initial.covariance, Limit::VARIANCE);
}

pub(in crate::model) fn process(check: &mut Check, process: &ProcessNoise) {
    check.number("process.sigma_q", process.sigma_q, Limit::ANGLE_NOISE);
    check.number("process.sigma_t", process.sigma_t, Limit::POSITION_NOISE);
}
