//! Bad data: a typed error or a documented skip, never NaN, and the state from before the step is kept.

use nalgebra::Vector3;
use rangelab::Error;
use rangelab::inertial::filter::{InertialFilter, InertialStep};
use rangelab::inertial::front_end::FrontEnd;
use rangelab::inertial::inertial_filter;
use rangelab::inertial::nearest::nearest_positive_definite;
use rangelab::inertial::riemannian::retract;
use rangelab::inertial::trilateration::trilaterate;
use rangelab::model::indoor::epoch::{IndoorEpoch, IndoorRecording};
use rangelab::model::indoor::filter_settings::{FilterName, FilterSettings, FrontEndKind, Retraction};
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::model::indoor::{IndoorScenario, StartPrior};
use rangelab::simulate::indoor::simulate_indoor;
use rangelab::study::indoor::block::IndoorBlock;

use crate::support::at_most;
use crate::support::sampling::Sampler;

fn recording() -> IndoorRecording {
    simulate_indoor(&indoor_preset("indoor-tumble").unwrap(), 0).unwrap()
}

fn filter(name: FilterName, recording: &IndoorRecording) -> Box<dyn InertialFilter + Send> {
    inertial_filter(name, &FilterSettings::default(), &recording.model, &recording.start).unwrap()
}

fn finite(step: &InertialStep) -> bool {
    let numbers = step.orientation.iter().chain(&step.position).chain(&step.velocity).chain(&step.covariance);
    numbers.copied().all(f64::is_finite)
}

/// A spoiled epoch is refused, and the steps after it are as if it had never been.
fn refused(what: &str, spoil: impl Fn(&mut IndoorEpoch)) {
    let recording = recording();
    for name in FilterName::ALL {
        let (mut spoiled, mut clean) = (filter(name, &recording), filter(name, &recording));
        for (k, epoch) in recording.epochs.iter().take(20).enumerate() {
            if k == 10 {
                let mut bad = epoch.clone();
                spoil(&mut bad);
                let error = spoiled.step(&bad).expect_err(what);
                assert!(matches!(error, Error::Number { .. }), "{name}, {what}: {error}");
            }
            assert_eq!(spoiled.step(epoch).unwrap(), clean.step(epoch).unwrap(), "{name}, {what}");
        }
    }
}

#[test]
fn numbers_that_mean_nothing_are_refused() {
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        refused("angular velocity", |epoch| epoch.sample.angular_velocity[1] = bad);
        refused("acceleration", |epoch| epoch.sample.acceleration[2] = bad);
        refused("next angular velocity", |epoch| epoch.next_angular_velocity[0] = bad);
    }
    for bad in [0.0, -0.1, f64::NAN, f64::INFINITY, 61.0] {
        refused("interval", |epoch| epoch.interval = bad);
    }
    for bad in [f64::NAN, f64::NEG_INFINITY] {
        refused("range", |epoch| epoch.ranges = vec![[Some(3.0), Some(bad), None]; 4]);
    }
}

/// A gap in the samples is a longer interval over which the last sample is held.
#[test]
fn a_gap_is_a_longer_interval() {
    let recording = recording();
    for name in FilterName::ALL {
        let mut filter = filter(name, &recording);
        let mut grown = 0.0;
        for (k, epoch) in recording.epochs.iter().enumerate() {
            let interval = if k == 14 { 3.0 } else { epoch.interval };
            let step = filter.step(&IndoorEpoch { interval, ..epoch.clone() }).unwrap();
            assert!(finite(&step), "{name} at {k}");
            if k == 13 {
                grown = step.covariance.trace();
            }
            assert!(k != 14 || step.covariance.trace() > 2.0 * grown, "{name}: a gap must be felt");
        }
    }
}

/// No ranges for seconds: it goes on by the IMU alone, ever less sure.
#[test]
fn without_ranges_the_imu_goes_on_alone() {
    let recording = recording();
    for name in FilterName::ALL {
        let mut filter = filter(name, &recording);
        let mut before = 0.0;
        for epoch in &recording.epochs {
            let step = filter.step(&IndoorEpoch { ranges: Vec::new(), ..epoch.clone() }).unwrap();
            assert!(step.fix.is_none() && finite(&step), "{name}");
            let position = step.covariance.fixed_view::<3, 3>(3, 3).trace();
            assert!(position > before, "{name}");
            before = position;
        }
    }
}

/// Fewer than four ranges to a transmitter: it is left out, and the filter on ranges uses what there is.
#[test]
fn transmitters_with_few_ranges_are_left_out() {
    let mut recording = recording();
    let first = recording.epochs[0].ranges.clone();
    let lose = |lost: &[usize]| {
        let mut ranges = first.clone();
        for &i in lost {
            ranges[0][i] = None;
        }
        ranges
    };
    for (lost, coordinates) in [(&[][..], 9), (&[1][..], 6), (&[0, 2][..], 3), (&[0, 1, 2][..], 0)] {
        recording.epochs[0].ranges = lose(lost);
        for name in FilterName::ALL {
            let step = filter(name, &recording).step(&recording.epochs[0]).unwrap();
            let found = step.fix.map_or(0, |fix| fix.degrees_of_freedom);
            let expected = if name == FilterName::Tight { 12 - lost.len() } else { coordinates };
            assert_eq!(found, expected, "{name} without {lost:?}");
            assert!(finite(&step));
        }
    }
}

/// A beacon where a transmitter is believed to be.
#[test]
fn a_beacon_on_a_transmitter_is_left_out() {
    for kind in [FrontEndKind::GaussNewton, FrontEndKind::Isosceles] {
        let mut recording = recording();
        let on = recording.start.state.act(&recording.model.transmitters[0]);
        recording.model.beacons[0] = on;
        let settings = FilterSettings { front_end: kind, ..FilterSettings::default() };
        for name in FilterName::ALL {
            let mut filter = inertial_filter(name, &settings, &recording.model, &recording.start).unwrap();
            // It stands still for the first step, so the transmitter stays on the beacon.
            let mut epoch = recording.epochs[0].clone();
            epoch.sample.angular_velocity = Vector3::zeros();
            epoch.sample.acceleration = Vector3::zeros();
            epoch.ranges[0] = [Some(0.0), Some(0.3), Some(0.3)];
            let step = filter.step(&epoch).unwrap();
            assert!(finite(&step), "{name}, {kind:?}");
        }
    }
    let beacon = Vector3::new(1.0, 2.0, 3.0);
    let error = trilaterate(&[(&beacon, 1.0); 4].into_iter(), &beacon).unwrap_err();
    assert!(matches!(error, Error::Number { .. }), "{error}");
}

#[test]
fn beacons_in_a_line_are_no_fix() {
    let beacons: Vec<_> = (0..4).map(|i| Vector3::new(f64::from(i), 0.0, 0.0)).collect();
    let on_the_line = Vector3::new(1.5, 0.0, 0.0);
    let ranges = beacons.iter().map(|beacon| (beacon, (beacon - on_the_line).norm()));
    let error = trilaterate(&ranges, &on_the_line).unwrap_err();
    assert!(matches!(error, Error::Unobservable { .. }), "{error}");
    let mut recording = recording();
    recording.model.beacons = beacons;
    let fix = FrontEnd::new(&FilterSettings::default()).fix(
        &recording.model,
        &recording.epochs[0].ranges,
        &[on_the_line; 3],
    );
    assert_eq!(fix, None);
}

#[test]
fn a_prior_that_is_no_covariance_is_refused() {
    let mut recording = recording();
    for variance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        recording.start.prior = StartPrior::Isotropic { variance };
        for name in FilterName::ALL {
            let result =
                inertial_filter(name, &FilterSettings::default(), &recording.model, &recording.start);
            assert!(
                matches!(result.err(), Some(Error::NotPositiveDefinite { .. })),
                "{name} with {variance}"
            );
        }
    }
}

/// The front end that fits the triangle gives a triangle that is congruent, and is better than one by one.
#[test]
fn the_triangle_is_kept_and_helps() {
    let recording = recording();
    let model = &recording.model;
    let fix = |kind, k: usize| {
        let settings = FilterSettings { front_end: kind, ..FilterSettings::default() };
        let truth = model.transmitters.map(|c| recording.truth[k].act(&c));
        let fix = FrontEnd::new(&settings).fix(model, &recording.epochs[k].ranges, &truth).unwrap();
        (fix.transmitters.map(|found| found.unwrap().0), truth)
    };
    let mut errors = [0.0; 2];
    for k in (0..100).step_by(10) {
        for (error, kind) in errors.iter_mut().zip([FrontEndKind::GaussNewton, FrontEndKind::Isosceles]) {
            let (found, truth) = fix(kind, k);
            *error += found.iter().zip(&truth).map(|(a, b)| (a - b).norm_squared()).sum::<f64>();
            if kind == FrontEndKind::Isosceles {
                for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                    let side = (model.transmitters[i] - model.transmitters[j]).norm();
                    at_most("a side", ((found[i] - found[j]).norm() - side).abs(), 1e-12);
                }
            }
        }
    }
    assert!(errors[1] < 0.9 * errors[0], "{errors:?}");
}

#[test]
fn retractions_end_on_rotations() {
    let mut sampler = Sampler::new(6);
    for kind in [Retraction::Qr, Retraction::Polar, Retraction::Exponential] {
        for size in [1e-3, 0.1, 3.0] {
            let r = *sampler.rotation::<3>().matrix();
            let turned = retract(kind, &r, &sampler.matrix(size)).unwrap().rotation;
            at_most(
                "R^T R - I",
                (turned.transpose() * turned - nalgebra::Matrix3::identity()).norm(),
                1e-14 * 10.0,
            );
            at_most("det - 1", (turned.determinant() - 1.0).abs(), 1e-14 * 10.0);
        }
    }
    let identity = nalgebra::Matrix3::identity();
    let mirror = nalgebra::Matrix3::from_diagonal(&Vector3::new(0.0, 0.0, -2.0));
    let mirrored = retract(Retraction::Qr, &identity, &mirror).unwrap();
    assert!(mirrored.reflected && mirrored.rotation == identity, "a reflection is turned and told");
    assert!(retract(Retraction::Qr, &identity, &-identity).is_err(), "zero has no Q-factor");
}

#[test]
fn the_nearest_positive_definite_matrix_is_near_and_positive() {
    let mut sampler = Sampler::new(7);
    let a = nalgebra::SMatrix::<f64, 15, 15>::from_fn(|_, _| sampler.normal());
    let mut p = a * a.transpose();
    let (same, _) = nearest_positive_definite(&p).unwrap();
    at_most("one that is", (same - p).norm() / p.norm(), 1e-13);
    p[(3, 3)] = -5.0;
    let (repaired, factor) = nearest_positive_definite(&p).unwrap();
    at_most("L L^T", (factor.lower() * factor.lower().transpose() - repaired).norm() / p.norm(), 1e-13);
    // No nearer one: the distance is the norm of the negative eigenvalues.
    let negative: f64 = p.symmetric_eigenvalues().iter().filter(|x| **x < 0.0).map(|x| x * x).sum();
    at_most("distance", (repaired - p).norm() - negative.sqrt(), 1e-9);
    p[(0, 0)] = f64::NAN;
    assert!(nearest_positive_definite(&p).is_err());
}

#[test]
fn scenarios_list_all_their_problems() {
    let read = |text: &str| IndoorScenario::from_json(text);
    let problems = |text: &str| match read(text) {
        Err(Error::Invalid { problems, .. }) => {
            problems.into_iter().map(|problem| problem.path).collect::<Vec<_>>()
        }
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(problems(r#"{"version": 1, "imu": {"rate_hz": 0}}"#), ["imu.rate_hz"]);
    assert_eq!(problems(r#"{"version": 1, "imu": {"rate_hz": 1e5}}"#), ["imu.rate_hz"]);
    assert_eq!(
        problems(r#"{"version": 1, "ranging": {"sigma": 0, "interval": 0.01}}"#),
        ["ranging.sigma", "ranging.interval"]
    );
    assert_eq!(problems(r#"{"version": 1, "transmitters": [[0,0,0],[1,0,0],[2,0,0]]}"#), ["transmitters"]);
    assert_eq!(problems(r#"{"version": 1, "transmitters": [[0,0,0],[1,0,0]]}"#), ["transmitters"]);
    assert_eq!(
        problems(r#"{"version": 1, "start": {"prior": {"kind": "isotropic", "variance": -1}}}"#),
        ["start.prior.variance"]
    );
    assert_eq!(problems(r#"{"version": 1, "filters": {"enabled": ["ekf", "ekf"]}}"#), ["filters.enabled[1]"]);
    assert!(matches!(read(r#"{"version": 1, "moon": 1}"#), Err(Error::Syntax { .. })));
    assert!(matches!(read(r#"{"version": 2}"#), Err(Error::Version { .. })));
    let scenario = read(r#"{"version": 1}"#).unwrap();
    assert_eq!(read(&scenario.to_json()).unwrap(), scenario);
}

/// A filter that reaches the end of no trial has no figures: an error of zero would be the best of all.
#[test]
fn a_study_of_nothing_but_failures_has_no_curve() {
    let scenario = indoor_preset("indoor-u").unwrap();
    let mut recording = simulate_indoor(&scenario, 0).unwrap();
    let mut block = IndoorBlock::new(&scenario, 0);
    recording.epochs[5].interval = 100.0;
    block.push(&recording, &scenario.filters).unwrap();
    for index in 0..scenario.filters.enabled.len() {
        let summary = block.filter(index);
        assert_eq!((summary.trials, summary.failures, summary.steps.len()), (0, 1, 0));
    }
    recording.epochs[5].interval = 0.1;
    block.push(&recording, &scenario.filters).unwrap();
    let summary = block.filter(0);
    assert_eq!((summary.trials, summary.failures, summary.steps.len()), (1, 1, recording.epochs.len()));
}
