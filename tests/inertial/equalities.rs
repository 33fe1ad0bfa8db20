//! What is the same as what: the spec's findings about where the gain of the Riemannian filters comes from.

use nalgebra::Vector3;
use rangelab::inertial::inertial_filter;
use rangelab::model::imu::Convention;
use rangelab::model::indoor::IndoorScenario;
use rangelab::model::indoor::filter_settings::{FilterName, FilterSettings, Retraction, Transport};
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::simulate::indoor::simulate_indoor;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;

use crate::support::{at_most, caught};

const PATHS: [&str; 4] = ["indoor-u", "indoor-zigzag", "indoor-bridge", "indoor-stair"];

fn trials(name: &str) -> usize {
    if name == "indoor-stair" { 4 } else { 20 }
}

/// Position (m) and angle (rad) of some filters.
fn errors(scenario: &IndoorScenario, filters: &[FilterName], transport: Transport) -> Vec<[f64; 2]> {
    let mut scenario = scenario.clone();
    scenario.filters = FilterSettings { enabled: filters.to_vec(), transport, ..scenario.filters };
    let report = IndoorMonteCarlo::new(&scenario, trials(&scenario.name)).unwrap().run().unwrap();
    report.filters.iter().map(|filter| [filter.summary.position.value, filter.summary.angle.value]).collect()
}

/// Largest difference, m or rad.
fn difference(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// To four digits: the covariance that is carried along SO(3) has no part in the gain.
#[test]
fn retraction_alone_is_ekf_rie() {
    for name in PATHS {
        for convention in [Convention::Sample, Convention::Disc] {
            let mut scenario = indoor_preset(name).unwrap();
            scenario.imu.convention = convention;
            let alone = errors(&scenario, &[FilterName::Ekf, FilterName::EkfRetraction], Transport::None);
            for transport in [Transport::Literal, Transport::Block, Transport::Congruence] {
                let rie = errors(&scenario, &[FilterName::EkfRie], transport);
                let what = format!("{name}, {convention:?}, {transport:?}");
                at_most(&what, difference(&rie[0], &alone[1]), 5e-5);
            }
            caught(&format!("{name}, {convention:?}: EKF"), difference(&alone[0], &alone[1]), 2e-3);
        }
    }
}

/// With a wide prior the readings of the transport part.
#[test]
fn a_wide_prior_parts_the_transports() {
    let mut scenario = indoor_preset("indoor-u").unwrap();
    scenario.start.prior = rangelab::model::indoor::StartPrior::Isotropic { variance: 1.0 };
    let literal = errors(&scenario, &[FilterName::EkfRie], Transport::Literal)[0];
    let congruence = errors(&scenario, &[FilterName::EkfRie], Transport::Congruence)[0];
    caught("literal for congruence", difference(&literal, &congruence), 0.1);
}

/// Positions of a filter along one trial.
fn positions(name: FilterName, scenario: &IndoorScenario) -> Vec<Vector3<f64>> {
    let recording = simulate_indoor(scenario, 0).unwrap();
    let settings = FilterSettings::default();
    let mut filter = inertial_filter(name, &settings, &recording.model, &recording.start).unwrap();
    recording.epochs.iter().map(|epoch| filter.step(epoch).unwrap().position).collect()
}

fn largest(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

/// The unscented transform is the missing Jacobian: the model is bilinear, and nothing else. What is left is the input's
/// noise, which the unscented filter averages over its points; it grows with `R`, which doubles on the stairs.
#[test]
fn the_ukf_is_the_ekf_with_the_full_jacobian() {
    for (name, limit) in PATHS.into_iter().zip([1e-6, 1e-6, 1e-6, 4e-6]) {
        let mut scenario = indoor_preset(name).unwrap();
        let ukf = positions(FilterName::Ukf, &scenario);
        let left = largest(&ukf, &positions(FilterName::EkfFull, &scenario));
        println!("{name}: {left:e} m");
        at_most(name, left, limit);
        caught(name, largest(&ukf, &positions(FilterName::Ekf, &scenario)), 1e-4);
        scenario.imu.gyroscope_density_degrees = 0.0;
        scenario.imu.accelerometer_density_micro_g = 0.0;
        let noiseless = [FilterName::Ukf, FilterName::EkfFull].map(|filter| positions(filter, &scenario));
        at_most(name, largest(&noiseless[0], &noiseless[1]), 1e-8);
    }
}

/// `prod sqrt(1 + T^2 |omega|^2)`: the growth of `R` by Euler's rule, the whole of the EKF's trouble.
#[test]
fn the_ekf_stretches_r_by_what_eulers_rule_says() {
    let expected =
        [("indoor-u", 1.261), ("indoor-zigzag", 1.653), ("indoor-bridge", 1.138), ("indoor-stair", 1.973)];
    for (name, growth) in expected {
        let mut scenario = indoor_preset(name).unwrap();
        scenario.filters.enabled = vec![FilterName::Ekf, FilterName::EkfRetraction];
        let report = IndoorMonteCarlo::new(&scenario, 2).unwrap().run().unwrap();
        let stretch = |i: usize| report.filters[i].summary.steps.last().unwrap().largest_singular_value.value;
        at_most(name, (stretch(0) / growth - 1.0).abs(), 2e-3);
        at_most(name, (stretch(1) - 1.0).abs(), 1e-12);
    }
}

/// At rest all filters are one.
#[test]
fn at_rest_all_filters_are_the_same() {
    let mut scenario = indoor_preset("indoor-static").unwrap();
    scenario.filters.retraction = Retraction::Qr;
    let filters: Vec<_> = FilterName::ALL.into_iter().filter(|name| *name != FilterName::Tight).collect();
    let all = errors(&scenario, &filters, Transport::Congruence);
    for (name, figures) in filters.iter().zip(&all) {
        at_most(&format!("{name}"), (figures[0] / all[0][0] - 1.0).abs(), 2e-3);
    }
}
