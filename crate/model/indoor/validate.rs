//! The rules of an indoor scenario.

use alloc::vec::Vec;

use nalgebra::Vector3;

use super::trajectory::steps;
use super::{IndoorScenario, StartPrior, TRANSMITTERS};
use crate::error::Problem;
use crate::model::document::check::{Check, Limit, MAX_STEPS, Readable};
use crate::model::document::entries::points;

/// Least `sin^2` of the angle between two sides of the triangle of transmitters: below it the triangle is a line.
const FLATTEST: f64 = 1e-12;

pub fn problems(scenario: &IndoorScenario) -> Vec<Problem> {
    let mut check = Check::default();
    check.version(scenario.version);
    check.name(&scenario.name);
    check.points("beacons", &scenario.beacons, Some(3));
    transmitters(&mut check, &scenario.transmitters);
    scenario.imu.check(&mut check);
    let ranging = &scenario.ranging;
    check.number("ranging.sigma", ranging.sigma, Limit::LENGTH);
    check.number("ranging.interval", ranging.interval, Limit::INTERVAL);
    check.number("ranging.missing_probability", ranging.missing_probability, Limit::PROBABILITY);
    lengths(&mut check, scenario);
    match scenario.start.prior {
        StartPrior::Isotropic { variance } => check.number("start.prior.variance", variance, Limit::VARIANCE),
        StartPrior::Tangent { angle, position, velocity } => {
            check.number("start.prior.angle", angle, Limit::ANGLE_LIMIT);
            check.number("start.prior.position", position, Limit::LENGTH);
            check.number("start.prior.velocity", velocity, Limit::SPEED_LIMIT);
        }
    }
    scenario.filters.check(&mut check);
    check.seed(scenario.seed);
    check.view(scenario.view.as_ref());
    check.into_problems()
}

fn transmitters(check: &mut Check, transmitters: &[Vec<f64>]) {
    check.points("transmitters", transmitters, Some(3));
    if transmitters.len() != TRANSMITTERS {
        check.problem("transmitters", format_args!("{} long", transmitters.len()), "3 transmitters");
        return;
    }
    if transmitters.iter().any(|point| point.len() != 3) {
        return;
    }
    let corners: Vec<Vector3<f64>> = points(transmitters);
    let (a, b) = (corners[1] - corners[0], corners[2] - corners[0]);
    if !(a.cross(&b).norm_squared() > FLATTEST * a.norm_squared() * b.norm_squared()) {
        check.problem(
            "transmitters",
            "on one line",
            "three corners of a triangle: a line does not show its roll",
        );
    }
}

/// The interval of the IMU against the path and the ranging.
fn lengths(check: &mut Check, scenario: &IndoorScenario) {
    let rate = scenario.imu.rate_hz;
    if !Limit::RATE.allows(rate) {
        return;
    }
    let steps = steps(scenario.path, scenario.imu.interval());
    if !(1..=MAX_STEPS).contains(&steps) {
        let found = format_args!("{}: {steps} samples along the path", Readable(rate));
        check.problem("imu.rate_hz", found, format_args!("1 to {MAX_STEPS} samples along the path"));
    }
    let (between, least) = (scenario.ranging.interval, scenario.imu.interval());
    if between < least * (1.0 - 1e-9) {
        let limit = format_args!("at least {} s, the interval of the IMU", Readable(least));
        check.problem("ranging.interval", Readable(between), limit);
    }
    check.total_ranges("imu.rate_hz", scenario.beacons.len(), TRANSMITTERS, steps);
}
