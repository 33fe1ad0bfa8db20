//! The rules of a kinematics scenario.

use alloc::vec::Vec;

use super::KinematicsScenario;
use super::distance_record::pair_count;
use super::settings::MAX_DEGREE;
use super::stamps::{LEAST_SPREAD, Stamps};
use crate::error::Problem;
use crate::model::document::check::{Check, Limit, MAX_RANGES, MAX_STEPS, Readable};

/// Fewest and most nodes.
const NODES: (usize, usize) = (2, 100);
/// Last stamps may be this far from time 0, s.
const MAX_TIME: f64 = 1e6;

pub fn problems(scenario: &KinematicsScenario) -> Vec<Problem> {
    let mut check = Check::default();
    check.version(scenario.version);
    check.name(&scenario.name);
    coefficients(&mut check, scenario);
    stamps(&mut check, &scenario.stamps);
    sizes(&mut check, scenario);
    let noise = &scenario.noise;
    check.number("noise.sigma_distance", noise.sigma_distance, Limit::POSITION_NOISE);
    check.number("noise.sigma_acceleration", noise.sigma_acceleration, Limit::ACCELERATION_NOISE);
    check.number("noise.missing_probability", noise.missing_probability, Limit::PROBABILITY);
    scenario.estimators.check(&mut check, "estimators.");
    if !(1..=MAX_STEPS).contains(&scenario.steps) {
        check.problem("steps", scenario.steps, format_args!("1 to {MAX_STEPS}"));
    }
    check.seed(scenario.seed);
    check.view(scenario.view.as_ref());
    check.into_problems()
}

fn coefficients(check: &mut Check, scenario: &KinematicsScenario) {
    check.count("coefficients", scenario.coefficients.len(), 1, MAX_DEGREE + 1);
    if scenario.coefficients.is_empty() {
        return;
    }
    let nodes = scenario.nodes();
    check.count("coefficients[0]", nodes, NODES.0, NODES.1);
    let dimension = scenario.dimension();
    if !(2..=3).contains(&dimension) {
        check.problem("coefficients[0][0]", format_args!("{dimension} long"), "2 or 3 numbers");
        return;
    }
    for (l, points) in scenario.coefficients.iter().enumerate() {
        if points.len() != nodes {
            let limit = format_args!("{nodes} vectors, one for each node");
            check.problem(format_args!("coefficients[{l}]"), format_args!("{} long", points.len()), limit);
        }
        for (node, point) in points.iter().enumerate() {
            let path = format_args!("coefficients[{l}][{node}]");
            check.vector(path, point, Some(dimension), Limit::KINEMATIC);
        }
    }
}

fn stamps(check: &mut Check, stamps: &Stamps) {
    let time = |check: &mut Check, path: &dyn core::fmt::Display, value: f64| {
        if !(value.abs() <= MAX_TIME) {
            check.problem(path, Readable(value), format_args!("from -{MAX_TIME} to {MAX_TIME} s"));
        }
    };
    match stamps {
        Stamps::Regular { first, last, count } => {
            time(check, &"stamps.first", *first);
            time(check, &"stamps.last", *last);
            if last < first {
                let limit = format_args!("at least {} s, the first stamp", Readable(*first));
                check.problem("stamps.last", Readable(*last), limit);
            }
            if !(1..=MAX_STEPS).contains(count) {
                check.problem("stamps.count", count, format_args!("1 to {MAX_STEPS}"));
            }
        }
        Stamps::Listed { times } => {
            check.count("stamps.times", times.len(), 1, MAX_STEPS);
            for (k, &value) in times.iter().enumerate() {
                time(check, &format_args!("stamps.times[{k}]"), value);
            }
        }
    }
    let [first, last] = stamps.ends();
    let spread = last - first;
    if spread > 0.0 && spread < LEAST_SPREAD {
        let limit = format_args!(
            "at least {LEAST_SPREAD:e} s, or 0 for stamps at one time: in a shorter one no motion is told from rounding"
        );
        check.problem("stamps", format_args!("{} s from the first to the last", Readable(spread)), limit);
    }
}

fn sizes(check: &mut Check, scenario: &KinematicsScenario) {
    let (pairs, stamps) = (pair_count(scenario.nodes()), scenario.stamps.count());
    let total = pairs.saturating_mul(stamps);
    if total > MAX_RANGES {
        let found = format_args!("{stamps}: {pairs} pairs x {stamps} stamps = {total} distances");
        check.problem("stamps", found, format_args!("at most {MAX_RANGES} distances in all"));
    }
}
