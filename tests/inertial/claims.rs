//! What the specification says beside its table: priors, gravity, lever arm, rest, and the presets' own lessons.

use rangelab::inertial::inertial_filter;
use rangelab::math::rotation::Rotation;
use rangelab::model::imu::{Convention, LeverArmCorrection};
use rangelab::model::indoor::filter_settings::{
    FilterName, FilterSettings, FrontEndKind, InputNoiseWeights, Retraction, TransmitterChoice, Transport,
};
use rangelab::model::indoor::presets::{INDOOR_PRESETS, indoor_preset};
use rangelab::model::indoor::{IndoorScenario, StartPrior};
use rangelab::simulate::indoor::simulate_indoor;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::indoor::report::IndoorSummary;
use rangelab::study::moments::{Estimate, Moments};

use FilterName::{Ekf, EkfRie, Mekf, Tight, UkfRie};

fn study<const N: usize>(
    scenario: &IndoorScenario,
    filters: [FilterName; N],
    trials: usize,
) -> [IndoorSummary; N] {
    let mut scenario = scenario.clone();
    scenario.filters.enabled = filters.to_vec();
    let report = IndoorMonteCarlo::new(&scenario, trials).unwrap().run().unwrap();
    let summaries: Vec<_> = report.filters.into_iter().map(|filter| filter.summary).collect();
    summaries.try_into().unwrap()
}

/// Within so many per cent, half a printed digit and four standard errors.
#[track_caller]
fn near(what: &str, found: &IndoorSummary, printed: f64, per_cent: f64) {
    let (value, error) = (found.position.value, found.position.standard_error);
    println!("{what}: {value:.4} +- {error:.4} m, printed {printed}");
    let allowed = 0.01 * per_cent * printed + 0.0005 + 4.0 * error;
    assert!(allowed < 0.3 * printed, "{what}: {allowed} allowed, which tells too little");
    assert!((value - printed).abs() <= allowed, "{what}: {value} +- {error}, printed {printed}");
}

#[test]
fn at_rest_the_figures_are_those_of_the_specification() {
    let scenario = indoor_preset("indoor-static").unwrap();
    let [ekf, mekf] = study(&scenario, [Ekf, Mekf], 60);
    near("EKF at rest", &ekf, 0.0255, 3.0);
    near("MEKF at rest", &mekf, 0.0255, 3.0);
    let degrees = ekf.angle.value.to_degrees();
    assert!((degrees / 0.0264 - 1.0).abs() < 0.05, "{degrees}");
}

/// `P0` from 1e-8 to 1 on the path U.
#[test]
fn a_wide_prior_costs_what_the_specification_says() {
    let rows = [
        (1e-8, [0.395, 0.358, 0.061]),
        (1e-4, [0.293, 0.263, 0.069]),
        (1e-2, [0.261, 0.216, 0.115]),
        (1.0, [1.448, 1.343, 0.158]),
    ];
    for (variance, printed) in rows {
        let mut scenario = indoor_preset("indoor-u").unwrap();
        scenario.start.prior = StartPrior::Isotropic { variance };
        scenario.filters.transport = Transport::Literal;
        let found = study(&scenario, [Ekf, EkfRie, Mekf], 80);
        for ((name, summary), printed) in ["EKF", "EKFRie", "MEKF"].into_iter().zip(&found).zip(printed) {
            near(&format!("{name}, P0 = {variance}"), summary, printed, 5.0);
        }
    }
}

/// The reading in which the updated block is carried.
#[test]
fn a_wide_prior_helps_the_unscented_filter_as_the_specification_says() {
    for (variance, printed) in [(1e-8, 0.358), (1e-4, 0.215), (1e-2, 0.132), (1.0, 0.200)] {
        let mut scenario = indoor_preset("indoor-u").unwrap();
        scenario.start.prior = StartPrior::Isotropic { variance };
        scenario.filters.transport = Transport::Block;
        let [found] = study(&scenario, [UkfRie], 80);
        near(&format!("UKFRie, P0 = {variance}"), &found, printed, 8.0);
    }
}

/// Three transmitters gain by averaging; on the path U as sampled, more than retraction does.
#[test]
fn one_transmitter_costs_what_the_specification_says() {
    let rows = [
        ("indoor-u", Convention::Sample, 40, [0.461, 0.421]),
        ("indoor-u", Convention::Disc, 40, [0.561, 0.062]),
        ("indoor-stair", Convention::Sample, 6, [0.725, 0.161]),
    ];
    for (path, convention, trials, printed) in rows {
        let mut scenario = indoor_preset(path).unwrap();
        scenario.imu.convention = convention;
        scenario.filters.transmitters = TransmitterChoice::First;
        let found = study(&scenario, [Ekf, EkfRie], trials);
        for ((name, summary), printed) in ["EKF", "EKFRie"].into_iter().zip(&found).zip(printed) {
            near(&format!("{name} with one transmitter on {path}, {convention:?}"), summary, printed, 5.0);
        }
    }
}

/// Step 5 as printed.
#[test]
fn squared_weights_cost_what_the_specification_says() {
    for (path, printed, degrees) in [("indoor-u", 2.66, 82.0), ("indoor-static", 0.371, 67.0)] {
        let mut scenario = indoor_preset(path).unwrap();
        scenario.filters.input_noise_weights = InputNoiseWeights::Squared;
        let [found] = study(&scenario, [FilterName::Ukf], 200);
        near(&format!("UKF with squared weights on {path}"), &found, printed, 5.0);
        let (angle, error) = (found.angle.value.to_degrees(), found.angle.standard_error.to_degrees());
        println!("{angle:.1} +- {error:.1} deg, printed {degrees}");
        assert!((angle - degrees).abs() < 0.05 * degrees + 4.0 * error, "{angle} +- {error}");
    }
}

#[test]
fn gravity_costs_what_the_specification_says() {
    for (path, printed) in [("indoor-u", [0.383, 0.352, 0.071]), ("indoor-bridge", [1.52, 0.261, 0.066])] {
        let mut scenario = indoor_preset(path).unwrap();
        scenario.imu.gravity = 9.81;
        let found = study(&scenario, [Ekf, EkfRie, Mekf], 40);
        for ((name, summary), printed) in ["EKF", "EKFRie", "MEKF"].into_iter().zip(&found).zip(printed) {
            near(&format!("{name} on {path}"), summary, printed, 4.0);
        }
    }
}

/// The printed formula is worse than none.
#[test]
fn a_lever_arm_costs_what_the_specification_says() {
    let rows = [
        (LeverArmCorrection::Corrected, 0.027),
        (LeverArmCorrection::Ignored, 0.058),
        (LeverArmCorrection::Printed, 0.065),
    ];
    let mut errors = Vec::new();
    for (correction, printed) in rows {
        let mut scenario = indoor_preset("indoor-u").unwrap();
        scenario.imu.convention = Convention::Mean;
        scenario.imu.rate_hz = 100.0;
        scenario.imu.lever_arm = [0.05, 0.02, -0.03];
        scenario.imu.lever_arm_correction = correction;
        let [found] = study(&scenario, [Mekf], 40);
        near(&format!("{correction:?}"), &found, printed, 5.0);
        errors.push(found.position.value);
    }
    // All three have the same random numbers.
    assert!(errors.is_sorted(), "{errors:?}");
}

/// More samples a second help less and less, and the gain of EKFRie shrinks with them.
#[test]
fn the_rate_of_the_imu_pays_as_the_specification_says() {
    for (rate_hz, printed) in
        [(5.0, [1.12, 1.01, 0.114]), (20.0, [0.238, 0.219, 0.043]), (100.0, [0.053, 0.050, 0.031])]
    {
        let mut scenario = indoor_preset("indoor-u").unwrap();
        scenario.ranging.sigma = 0.1_f64.sqrt();
        scenario.imu.rate_hz = rate_hz;
        let found = study(&scenario, [Ekf, EkfRie, Mekf], 40);
        for ((name, summary), printed) in ["EKF", "EKFRie", "MEKF"].into_iter().zip(&found).zip(printed) {
            near(&format!("{name} at {rate_hz} Hz"), summary, printed, 4.0);
        }
    }
}

/// Nine tenths of the trials on the bridge stay below this (sigma^2 = 1e-3).
#[test]
fn the_distribution_on_the_bridge_is_that_of_the_specification() {
    let rows = [
        (Convention::Sample, [0.146, 0.142, 0.149, 0.146]),
        (Convention::Disc, [0.051, 0.050, 0.015, 0.016]),
    ];
    for (convention, printed) in rows {
        let mut scenario = indoor_preset("indoor-bridge").unwrap();
        scenario.imu.convention = convention;
        scenario.ranging.sigma = 1e-3_f64.sqrt();
        let found = study(&scenario, [Ekf, FilterName::Ukf, EkfRie, UkfRie], 100);
        for (summary, printed) in found.iter().zip(printed) {
            let value = summary.position_distribution[89];
            println!("{convention:?}: {value:.4}, printed {printed}");
            assert!((value - printed).abs() < 0.03 * printed + 0.0015, "{value} {printed}");
        }
    }
}

/// The fit of the whole triangle makes better transmitters and no better filter.
#[test]
fn the_isosceles_front_end_does_not_help_the_filters() {
    let mut scenario = indoor_preset("indoor-u").unwrap();
    let filters = [Ekf, EkfRie, UkfRie, Mekf];
    let one_by_one = study(&scenario, filters, 40);
    scenario.filters.front_end = FrontEndKind::Isosceles;
    for (a, b) in one_by_one.iter().zip(&study(&scenario, filters, 40)) {
        let ratio = b.position.value / a.position.value;
        assert!((ratio - 1.0).abs() < 0.017, "{ratio}");
    }
}

/// Degrees left after ten fixes at rest, started 20 degrees off about the body's first axis, with their standard error.
fn left(name: FilterName, prior: StartPrior, settings: &FilterSettings) -> (f64, f64) {
    let mut scenario = indoor_preset("indoor-static").unwrap();
    scenario.ranging.sigma = 0.01;
    scenario.start.prior = prior;
    let mut squares = Moments::default();
    for trial in 0..100 {
        let mut recording = simulate_indoor(&scenario, trial).unwrap();
        let off = Rotation::exp(&[20.0_f64.to_radians(), 0.0, 0.0]);
        recording.start.state.rotation = recording.start.state.rotation.compose(&off);
        let mut filter = inertial_filter(name, settings, &recording.model, &recording.start).unwrap();
        let steps = recording.epochs.iter().map(|epoch| filter.step(epoch).unwrap());
        let last = steps.last().unwrap();
        let angle = last.rotation().inverse().compose(&recording.truth[0].rotation).angle().to_degrees();
        squares.push(angle * angle);
    }
    let Estimate { value, standard_error } = squares.root_mean();
    (value, standard_error)
}

/// Gram-Schmidt keeps the columns that the triangle does not see, and throws away the one with the lever.
#[test]
fn an_isotropic_prior_and_a_q_factor_undo_every_correction() {
    let isotropic = StartPrior::Isotropic { variance: 0.1 };
    let angle = (0.1_f64 / 2.0).sqrt();
    let tangent = StartPrior::Tangent { angle, position: 0.1_f64.sqrt(), velocity: 0.1_f64.sqrt() };
    let plain = FilterSettings::default();
    let literal = FilterSettings { transport: Transport::Literal, ..plain.clone() };
    let polar = FilterSettings { retraction: Retraction::Polar, ..plain.clone() };
    let projected = FilterSettings { tangent_correction: true, ..plain.clone() };
    let rows = [
        (EkfRie, isotropic, &plain, 20.2),
        (EkfRie, isotropic, &literal, 21.4),
        (UkfRie, isotropic, &plain, 20.3),
        (EkfRie, isotropic, &polar, 4.2),
        (EkfRie, isotropic, &projected, 4.3),
        (EkfRie, tangent, &plain, 1.85),
        (Mekf, isotropic, &plain, 1.87),
        (FilterName::LieKf, isotropic, &plain, 1.83),
        (Tight, isotropic, &plain, 1.88),
    ];
    for (name, prior, settings, printed) in rows {
        let (degrees, error) = left(name, prior, settings);
        println!("{name} {prior:?}: {degrees:.2} +- {error:.2} deg left, printed {printed}");
        assert!((degrees - printed).abs() < 0.05 * printed + 4.0 * error, "{name}: {degrees} +- {error}");
    }
}

/// Each summary of a preset says what its figures say.
#[test]
fn presets_teach_what_they_say() {
    let of = |name: &str, trials: usize| study(&indoor_preset(name).unwrap(), [Ekf, EkfRie, Mekf], trials);
    for preset in &INDOOR_PRESETS {
        let trials = if ["indoor-stair", "indoor-gravity"].contains(&preset.name) { 6 } else { 20 };
        let [ekf, rie, mekf] = of(preset.name, trials);
        let (a, b, c) = (ekf.position.value, rie.position.value, mekf.position.value);
        println!("{}: {a:.3} {b:.3} {c:.3} m, NEES/9 {:.2}", preset.name, mekf.nees.value);
        let right = match preset.name {
            "indoor-u" => (0.88..0.94).contains(&(b / a)) && (5.0..7.0).contains(&(b / c)),
            "indoor-zigzag" => b > 8.0 * c,
            "indoor-bridge" => (1.01..1.04).contains(&(b / a)),
            "indoor-stair" => (4.0..6.0).contains(&(a / b)),
            "indoor-static" => (a / b - 1.0).abs() < 1e-3 && (a / c - 1.0).abs() < 1e-2,
            "indoor-matched" => (7.5..9.5).contains(&(a / b)) && c > 4.0 * b,
            "indoor-delta" => (0.8..1.25).contains(&mekf.nees.value) && ekf.nees.value > 10.0,
            "indoor-gravity" => a > 1.0 && b > 1.0 && c < 0.2,
            "indoor-tumble" => rie.angle.value > 1.5 * ekf.angle.value,
            other => panic!("{other} teaches nothing that is tested"),
        };
        assert!(right, "{}: {a} {b} {c} m, NEES {} {}", preset.name, ekf.nees.value, mekf.nees.value);
    }
}
