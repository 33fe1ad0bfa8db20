//! Sensors off their places on the body: drawn by their law, measured to, and told to no estimator.

use nalgebra::{SMatrix, SVector};
use rangelab::math::float::sqrt;
use rangelab::math::pose::Theta;
use rangelab::model::epoch::{Epoch, Recording};
use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::preset;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::mounting::mounting_cloud;
use rangelab::track::filter::Estimator;
use rangelab::track::kalman::KalmanFilter;

use super::drawn;
use super::statistics::{LIMIT, Sample, correlation_deviation};

const SIGMA_E: f64 = 0.02;

/// The displacements of the sensors in some trials, each a standard normal number where `sigma` is the one drawn with.
fn displacements(scenario: &Scenario, trials: u64, sigma: f64) -> Vec<f64> {
    let places = mounting_cloud::<3>(scenario, trials).unwrap();
    let given = scenario.sensors.iter().cycle();
    let each = places.iter().zip(given).flat_map(|(place, c)| place.iter().zip(c));
    each.map(|(x, c)| (x - c) / sigma).collect()
}

#[test]
fn sensors_are_displaced_by_their_law_and_each_on_its_own() {
    let scenario = Scenario { mounting_sigma: SIGMA_E, ..preset("room").unwrap() };
    let all = displacements(&scenario, 4000, SIGMA_E);
    let sample = Sample::new(all.iter().copied());
    assert!(sample.is_standard_normal(), "{:?}", sample.standard_normal_deviations());
    let spoiled = Sample::new(all.iter().map(|x| 1.05 * x));
    assert!(!spoiled.is_standard_normal(), "5 % more must be refuted");
    // From coordinate to coordinate, from sensor to sensor, from trial to trial.
    for lag in [1, 3, 3 * scenario.sensors.len()] {
        let deviation = correlation_deviation(&all[lag..], &all[..all.len() - lag]);
        assert!(deviation.abs() < LIMIT, "lag {lag}: {deviation}");
    }
}

#[test]
fn ranges_are_measured_to_the_displaced_sensors_of_the_trial_and_estimators_are_not_told() {
    let sigma = 1e-9;
    let noise = RangeNoise::Range { sigma };
    let scenario = Scenario { mounting_sigma: SIGMA_E, steps: 3, noise, ..preset("room").unwrap() };
    let sensors = scenario.sensors.len();
    let cloud = mounting_cloud::<3>(&scenario, 4).unwrap();
    for trial in 0..4 {
        let recording = drawn::<3>(&scenario, trial);
        assert_eq!(recording.model, scenario.setup().unwrap().model, "the model is the one given");
        let farthest = |places: &[SVector<f64, 3>]| {
            let mut farthest: f64 = 0.0;
            for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
                let pose = truth.unwrap();
                for (m, a) in recording.model.anchors().positions().iter().enumerate() {
                    for (n, place) in places.iter().enumerate() {
                        let range = sqrt(epoch.ranges.get(m, n).unwrap());
                        farthest = farthest.max((range - (a - pose.act(place)).norm()).abs());
                    }
                }
            }
            farthest
        };
        let at = usize::try_from(trial).unwrap() * sensors;
        assert!(farthest(&cloud[at..at + sensors]) < 10.0 * sigma);
        assert!(farthest(recording.model.topology().sensors()) > SIGMA_E, "not to the places given");
    }
}

#[test]
fn a_mounting_error_moves_no_other_draw_and_none_at_all_no_bit() {
    let scenario = Scenario { missing_probability: 0.3, ..preset("room").unwrap() };
    let mounted = Scenario { mounting_sigma: SIGMA_E, ..scenario.clone() };
    let (plain, displaced) = (drawn::<3>(&scenario, 2), drawn::<3>(&mounted, 2));
    assert_eq!(plain.truth, displaced.truth);
    let there = |recording: &Recording<3>| -> Vec<bool> {
        let pairs = |m: usize| (0..scenario.sensors.len()).map(move |n| (m, n));
        let all = |epoch: &Epoch<3>| -> Vec<bool> {
            (0..scenario.anchors.len())
                .flat_map(pairs)
                .map(|(m, n)| epoch.ranges.get(m, n).is_some())
                .collect()
        };
        recording.epochs.iter().flat_map(all).collect()
    };
    assert_eq!(there(&plain), there(&displaced), "the same ranges go missing");
    assert_ne!(plain.epochs, displaced.epochs);
    let none = Scenario { mounting_sigma: 0.0, ..mounted.clone() };
    assert_eq!(drawn::<3>(&none, 2), plain);
    assert_eq!(mounting_cloud::<3>(&none, 1).unwrap(), plain.model.topology().sensors());
    // Twice the error displaces each sensor twice as far; a sensor more leaves the others where they were.
    let twice = Scenario { mounting_sigma: 2.0 * SIGMA_E, ..mounted.clone() };
    let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-12);
    let first = displacements(&mounted, 1, SIGMA_E);
    assert!(close(&first, &displacements(&twice, 1, 2.0 * SIGMA_E)));
    let mut more = mounted;
    more.sensors.push(vec![0.1, 0.2, 0.3]);
    assert!(close(&first, &displacements(&more, 1, SIGMA_E)));
}

#[test]
fn a_cloud_that_would_fill_the_memory_is_refused_with_a_sentence() {
    let error = mounting_cloud::<3>(&preset("room").unwrap(), u64::MAX).unwrap_err().to_string();
    assert!(error.contains("at most 1000000"), "{error}");
    assert!(mounting_cloud::<2>(&preset("room").unwrap(), 1).is_err());
}

/// Without noise to speak of, least squares gives the pose that fits the displaced sensors best: off by
/// `Q (E C^T (C C^T)^-1)` and by `Q E 1 / N`. Its position has the error floor `sigma_e sqrt(3/N)` of \[L\] Sec. VII.
#[test]
fn the_mounting_error_is_the_floor_of_what_least_squares_finds() {
    let mut scenario = Scenario { mounting_sigma: SIGMA_E, steps: 1, ..preset("tracking-paper").unwrap() };
    scenario.noise = RangeNoise::Range { sigma: 1e-6 };
    scenario.initial.covariance = 1e10;
    let topology = scenario.setup::<3>().unwrap().model.topology().clone();
    assert!(topology.is_centred());
    let inverse = topology.gram().try_inverse().unwrap();
    let (sensors, trials) = (topology.len(), 500);
    let cloud = mounting_cloud::<3>(&scenario, trials).unwrap();
    let mut shifts = Vec::new();
    for (trial, places) in (0..trials).zip(cloud.chunks(sensors)) {
        let recording = drawn::<3>(&scenario, trial);
        let mut filter = KalmanFilter::new(recording.model.clone(), &recording.initial, recording.process);
        let found = filter.step(&recording.epochs[0]).unwrap().posterior;
        let truth = Theta::from(recording.truth[0].unwrap());
        let errors = places.iter().zip(topology.sensors()).map(|(place, c)| place - c);
        let (mut turned, mut shifted) = (SMatrix::<f64, 3, 3>::zeros(), SVector::<f64, 3>::zeros());
        for (e, c) in errors.zip(topology.sensors()) {
            turned += e * c.transpose();
            shifted += e / sensors as f64;
        }
        let shift = found.position - truth.position;
        let turn = found.orientation - truth.orientation;
        assert!((turn - truth.orientation * turned * inverse).norm() < 0.01 * SIGMA_E, "trial {trial}");
        assert!((shift - truth.orientation * shifted).norm() < 0.01 * SIGMA_E, "trial {trial}");
        shifts.extend(shift.iter().map(|x| x * sqrt(sensors as f64) / SIGMA_E));
    }
    let sample = Sample::new(shifts);
    assert!(sample.is_standard_normal(), "{:?}", sample.standard_normal_deviations());
}
