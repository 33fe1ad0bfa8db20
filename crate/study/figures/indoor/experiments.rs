//! What is simulated for the figures of \[I\]: scenarios at one or all points of a sweep.

use alloc::vec;
use alloc::vec::Vec;

use crate::math::float::sqrt;
use crate::model::imu::{Convention, STANDARD_GRAVITY};
use crate::model::indoor::filter_settings::FilterName::{
    self, Ekf, EkfFull, EkfRetraction, EkfRie, Mekf, Ukf, UkfRie,
};
use crate::model::indoor::filter_settings::{
    FrontEndKind, InputNoiseWeights, Retraction, TransmitterChoice, Transport,
};
use crate::model::indoor::presets::indoor_preset;
use crate::model::indoor::{IndoorScenario, StartPrior};
use crate::study::figures::experiment::Experiment;
use crate::study::indoor::sweep::{IndoorSweep, Swept};

type Experiments = Vec<(&'static str, Experiment)>;

/// The filters of the paper.
pub(super) const PAPER: [FilterName; 4] = [Ekf, EkfRie, Ukf, UkfRie];
/// The paper's and, beside them, the yardstick.
const WITH_YARDSTICK: [FilterName; 5] = [Ekf, EkfRie, Ukf, UkfRie, Mekf];

/// Where the sweeps of Fig. 4 are.
pub(super) const REST: usize = 0;
pub(super) const REST_ISOSCELES: usize = 1;
pub(super) const REST_SQUARED: usize = 2;

/// Where those of Fig. 5 and 6 are that are drawn.
pub(super) const U: usize = 0;
pub(super) const STAIR: usize = 1;
pub(super) const U_ISOSCELES: usize = 2;
pub(super) const U_MATCHED: usize = 3;
pub(super) const STAIR_MATCHED: usize = 4;
/// Where those are that are for claims alone: first those of both figures,
pub(super) const ZIGZAG: usize = 5;
pub(super) const BRIDGE: usize = 6;
pub(super) const TUMBLE: usize = 7;
pub(super) const U_EXPONENTIAL: usize = 8;
pub(super) const U_MATCHED_EXPONENTIAL: usize = 9;
pub(super) const TUMBLE_EXPONENTIAL: usize = 10;
/// then those of Fig. 5.
pub(super) const BRIDGE_MATCHED: usize = 11;
pub(super) const U_SINGLE: usize = 12;
pub(super) const U_MATCHED_SINGLE: usize = 13;
pub(super) const STAIR_SINGLE: usize = 14;
pub(super) const U_PRINTED: usize = 15;
pub(super) const U_PRINTED_UNSURE: usize = 16;
pub(super) const U_CONGRUENCE: usize = 17;
pub(super) const U_FULL: usize = 18;
pub(super) const STAIR_PRINTED_NOISE: usize = 19;
pub(super) const BRIDGE_GRAVITY: usize = 20;

/// Where those of Fig. 7 to 9 are.
pub(super) const SAMPLED: usize = 0;
pub(super) const MATCHED: usize = 1;

/// Of a range, dB: the one of which the paper gives numbers.
pub(super) const PRINTED_DB: f64 = 20.0;
/// Samples of the IMU in a second.
pub(super) const RATES_HZ: [f64; 7] = [5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0];
/// `sigma_r^2` of 1e-3 and 1e-1, dB.
pub(super) const FINE_DB: f64 = 30.0;
pub(super) const COARSE_DB: f64 = 10.0;

pub(super) fn figure_4() -> Experiments {
    vec![
        ("at rest", over_noise("indoor-static", &WITH_YARDSTICK, |_| ())),
        ("at rest, Iso", over_noise("indoor-static", &PAPER, isosceles)),
        ("at rest, weights squared", at_20_db("indoor-static", &[Ukf], squared)),
    ]
}

/// Fig. 5: beside what both have one transmitter instead of three, the transport and the noise as printed, what the UKF
/// comes to, and gravity.
pub(super) fn figure_5() -> Experiments {
    let mut experiments = figure_6();
    experiments.extend([
        ("bridge, matched", over_noise("indoor-bridge", &PAPER, matched)),
        ("U, one transmitter", at_20_db("indoor-u", &[EkfRie], single)),
        ("U, matched, one transmitter", at_20_db("indoor-u", &[EkfRie], matched_single)),
        ("stair, one transmitter", at_20_db("indoor-stair", &[EkfRie], single)),
        ("U, transport as printed, P0 1e-4", at_20_db("indoor-u", &[UkfRie], |it| printed(it, 1e-4))),
        ("U, transport as printed, P0 1", at_20_db("indoor-u", &[EkfRie, Mekf], |it| printed(it, 1.0))),
        ("U, P0 1e-4", at_20_db("indoor-u", &[UkfRie], |it| prior(it, 1e-4))),
        ("U, full Jacobian", at_20_db("indoor-u", &[EkfFull, Ukf], |_| ())),
        ("stair, sigma_a^2 as printed", at_20_db("indoor-stair", &[Ekf, EkfRie], printed_noise)),
        ("bridge, gravity", at_20_db("indoor-bridge", &[Ekf, EkfRie, Mekf], gravity)),
    ]);
    experiments
}

/// Fig. 6: beside what is drawn the other paths, turns about three axes, and the exponential map.
pub(super) fn figure_6() -> Experiments {
    let mut experiments = drawn();
    experiments.extend([
        ("zigzag", over_noise("indoor-zigzag", &PAPER, |_| ())),
        ("bridge", over_noise("indoor-bridge", &PAPER, |_| ())),
        ("tumble", at_20_db("indoor-tumble", &PAPER, |_| ())),
        ("U, exponential map", at_20_db("indoor-u", &[EkfRie], exponential)),
        ("U, matched, exponential map", at_20_db("indoor-u", &[EkfRie], matched_exponential)),
        ("tumble, exponential map", at_20_db("indoor-tumble", &[EkfRie], exponential)),
    ]);
    experiments
}

pub(super) fn figure_7() -> Experiments {
    over_rates(COARSE_DB)
}

pub(super) fn figure_8() -> Experiments {
    over_rates(FINE_DB)
}

pub(super) fn figure_9() -> Experiments {
    let noises = vec![FINE_DB, COARSE_DB];
    let bridge = |change: fn(&mut IndoorScenario)| {
        sweep(scenario("indoor-bridge", &WITH_YARDSTICK, change), Swept::Accuracy, noises.clone())
    };
    vec![("bridge", bridge(|_| ())), ("bridge, matched", bridge(matched))]
}

fn drawn() -> Experiments {
    let all = [Ekf, EkfRetraction, EkfRie, Ukf, UkfRie, Mekf];
    vec![
        ("U", over_noise("indoor-u", &all, |_| ())),
        ("stair", over_some_noise("indoor-stair", &all, |_| ())),
        ("U, Iso", over_noise("indoor-u", &PAPER, isosceles)),
        ("U, matched", over_noise("indoor-u", &PAPER, matched)),
        ("stair, matched", over_some_noise("indoor-stair", &PAPER, matched)),
    ]
}

fn over_rates(accuracy_db: f64) -> Experiments {
    let at_rates = |change: fn(&mut IndoorScenario)| {
        let scenario =
            IndoorSweep::new(scenario("indoor-u", &WITH_YARDSTICK, change), Swept::Accuracy, Vec::new());
        sweep(scenario.at(accuracy_db), Swept::ImuRate, RATES_HZ.to_vec())
    };
    vec![("U", at_rates(|_| ())), ("U, matched", at_rates(matched))]
}

/// From 0 to 40 dB.
fn over_noise(preset: &str, filters: &[FilterName], change: fn(&mut IndoorScenario)) -> Experiment {
    let points = (0..=8).map(|k| 5.0 * f64::from(k)).collect();
    sweep(scenario(preset, filters, change), Swept::Accuracy, points)
}

/// The same in wider steps, for the stairs take long.
fn over_some_noise(preset: &str, filters: &[FilterName], change: fn(&mut IndoorScenario)) -> Experiment {
    let points = (0..=4).map(|k| 10.0 * f64::from(k)).collect();
    sweep(scenario(preset, filters, change), Swept::Accuracy, points)
}

fn at_20_db(preset: &str, filters: &[FilterName], change: fn(&mut IndoorScenario)) -> Experiment {
    sweep(scenario(preset, filters, change), Swept::Accuracy, vec![PRINTED_DB])
}

fn sweep(scenario: IndoorScenario, swept: Swept, points: Vec<f64>) -> Experiment {
    Experiment::Indoor(IndoorSweep::new(scenario, swept, points))
}

fn scenario(preset: &str, filters: &[FilterName], change: fn(&mut IndoorScenario)) -> IndoorScenario {
    let mut scenario = indoor_preset(preset).expect("the preset exists");
    scenario.filters.enabled = filters.to_vec();
    change(&mut scenario);
    scenario
}

/// Inputs for which the paper's discretization is exact.
fn matched(scenario: &mut IndoorScenario) {
    scenario.imu.convention = Convention::Disc;
}

fn isosceles(scenario: &mut IndoorScenario) {
    scenario.filters.front_end = FrontEndKind::Isosceles;
}

fn single(scenario: &mut IndoorScenario) {
    scenario.filters.transmitters = TransmitterChoice::First;
}

fn matched_single(scenario: &mut IndoorScenario) {
    matched(scenario);
    single(scenario);
}

fn squared(scenario: &mut IndoorScenario) {
    scenario.filters.input_noise_weights = InputNoiseWeights::Squared;
}

fn exponential(scenario: &mut IndoorScenario) {
    scenario.filters.retraction = Retraction::Exponential;
}

fn matched_exponential(scenario: &mut IndoorScenario) {
    matched(scenario);
    exponential(scenario);
}

/// The variance that \[I\] prints is ten times that of its data sheet at its rate, 10 Hz.
fn printed_noise(scenario: &mut IndoorScenario) {
    scenario.imu.accelerometer_density_micro_g *= sqrt(10.0);
}

fn gravity(scenario: &mut IndoorScenario) {
    scenario.imu.gravity = STANDARD_GRAVITY;
}

fn prior(scenario: &mut IndoorScenario, variance: f64) {
    scenario.start.prior = StartPrior::Isotropic { variance };
}

/// Steps 7 and 16 as printed.
fn printed(scenario: &mut IndoorScenario, variance: f64) {
    prior(scenario, variance);
    scenario.filters.transport = Transport::Literal;
}
