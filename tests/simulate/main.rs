//! Simulated data against the laws they are drawn from: moments within their standard errors, draws that are common.

mod mounting;
#[path = "../support/statistics.rs"]
mod statistics;

use rangelab::math::float::{ratio_from_db, sqrt};
use rangelab::math::pose::Theta;
use rangelab::math::rotation::{defect, rotation_angles};
use rangelab::model::epoch::Recording;
use rangelab::model::noise::RangeNoise;
use rangelab::model::presets::{PRESETS, preset};
use rangelab::model::ranging::Weighting;
use rangelab::model::scenario::{RedrawAnchors, Scenario, WeightSource};
use rangelab::simulate::simulate;
use statistics::{LIMIT, Sample, correlation_deviation};

const STEPS: usize = 4000;

/// A body at rest close to its anchors, so that the ranges of its sensors to one anchor differ by tens of percent.
fn at_rest(noise: RangeNoise, weighting: Weighting) -> Scenario {
    let mut scenario = preset("tracking-paper").unwrap();
    scenario.anchors =
        vec![vec![2.0, 0.0, 0.5], vec![-1.5, 1.5, 0.0], vec![0.0, -2.0, 1.0], vec![0.5, 0.5, 3.0]];
    scenario.motion.sigma_omega = 0.0;
    scenario.motion.sigma_t = 0.0;
    scenario.motion.velocity = vec![0.0; 3];
    scenario.motion.angular_velocity = vec![0.0; 3];
    Scenario { noise, weighting, steps: STEPS, ..scenario }
}

/// Every range as a standard normal number under the law `read(measured d, exact d, exact d of the first sensor)`.
fn residuals<const D: usize>(recording: &Recording<D>, read: impl Fn(f64, f64, f64) -> f64) -> Vec<f64> {
    let mut all = Vec::new();
    for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
        let exact = recording.model.exact_ranges(&Theta::from(truth.unwrap())).unwrap();
        for m in 0..exact.anchors() {
            for n in 0..exact.sensors() {
                if let Some(d) = epoch.ranges.get(m, n) {
                    all.push(read(d, exact.get(m, n).unwrap(), exact.get(m, 0).unwrap()));
                }
            }
        }
    }
    all
}

fn drawn<const D: usize>(scenario: &Scenario, trial: u64) -> Recording<D> {
    simulate(scenario, trial).unwrap()
}

#[test]
fn squared_range_noise_has_the_variance_of_the_paper_and_no_other() {
    let sigma = 0.0316;
    for weighting in [Weighting::Common, Weighting::PerPair] {
        let recording = drawn::<3>(&at_rest(RangeNoise::SquaredRange { sigma }, weighting), 0);
        let law = |of_first: bool| {
            Sample::new(residuals(&recording, |d, exact, first| {
                (d - exact) / (sigma * sqrt(if of_first { first } else { exact }))
            }))
        };
        assert!(law(false).is_standard_normal(), "{:?}", law(false).standard_normal_deviations());
        assert!(
            !law(true).is_standard_normal(),
            "{weighting:?}: the law of the first sensor must be refuted"
        );
    }
}

#[test]
fn range_and_arrival_noise_have_their_laws() {
    let (sigma, zeta_db) = (0.05, 40.0);
    let zeta = ratio_from_db(zeta_db);
    let range = |d: f64, exact: f64, _: f64| (sqrt(d) - sqrt(exact)) / sigma;
    let arrival = |d: f64, exact: f64, _: f64| (sqrt(d) / sqrt(exact) - 1.0) * sqrt(zeta);
    for weighting in [Weighting::Common, Weighting::PerPair] {
        let ranges = drawn::<3>(&at_rest(RangeNoise::Range { sigma }, weighting), 0);
        let arrivals = drawn::<3>(&at_rest(RangeNoise::Toa { zeta_db }, weighting), 0);
        for (recording, right, wrong) in [
            (&ranges, Sample::new(residuals(&ranges, range)), Sample::new(residuals(&ranges, arrival))),
            (&arrivals, Sample::new(residuals(&arrivals, arrival)), Sample::new(residuals(&arrivals, range))),
        ] {
            let noise = recording.model.noise();
            assert!(right.is_standard_normal(), "{noise:?}: {:?}", right.standard_normal_deviations());
            assert!(!wrong.is_standard_normal(), "{noise:?}: the other law must be refuted");
        }
    }
}

#[test]
fn a_sigma_five_percent_off_is_refuted() {
    let recording = drawn::<3>(&at_rest(RangeNoise::Range { sigma: 0.05 }, Weighting::Common), 0);
    let off = residuals(&recording, |d, exact, _| (sqrt(d) - sqrt(exact)) / (0.05 * 1.05));
    assert!(!Sample::new(off).is_standard_normal());
}

/// Disturbances of each step as standard normal numbers: one list a coordinate, rotation first.
fn disturbances<const D: usize>(scenario: &Scenario, trial: u64) -> Vec<Vec<f64>> {
    let setup = scenario.setup::<D>().unwrap();
    let (interval, motion) = (scenario.interval, &scenario.motion);
    let mut before = setup.start;
    let mut lists = vec![Vec::new(); rotation_angles(D) + D];
    for truth in drawn::<D>(scenario, trial).truth {
        let truth = truth.unwrap();
        let turn = truth.rotation.compose(&before.rotation.inverse()).log();
        let shift = truth.position - before.position;
        for i in 0..rotation_angles(D) {
            lists[i].push((turn[i] / interval - motion.angular_velocity[i]) / motion.sigma_omega);
        }
        for i in 0..D {
            lists[rotation_angles(D) + i].push((shift[i] - interval * motion.velocity[i]) / motion.sigma_t);
        }
        before = truth;
    }
    lists
}

/// A long walk without ranges to speak of.
fn long_walk(name: &str) -> Scenario {
    let mut scenario = preset(name).unwrap();
    scenario.anchors.truncate(1);
    scenario.sensors.truncate(1);
    Scenario { steps: 10_000, ..scenario }
}

fn motion_has_its_law<const D: usize>(name: &str) {
    let scenario = long_walk(name);
    let lists = disturbances::<D>(&scenario, 0);
    for (i, list) in lists.iter().enumerate() {
        let sample = Sample::new(list.iter().copied());
        assert!(sample.is_standard_normal(), "{name} {i}: {:?}", sample.standard_normal_deviations());
        let doubled = Sample::new(list.iter().map(|x| 1.1 * x));
        assert!(!doubled.is_standard_normal(), "{name} {i}: 10 % more must be refuted");
        for other in &lists[..i] {
            assert!(correlation_deviation(list, other).abs() < LIMIT, "{name}: coordinates are independent");
        }
        let lagged = correlation_deviation(&list[1..], &list[..list.len() - 1]);
        assert!(lagged.abs() < LIMIT, "{name} {i}: steps are independent");
    }
}

#[test]
fn motion_is_disturbed_as_in_equations_11_and_14() {
    motion_has_its_law::<3>("room");
    motion_has_its_law::<2>("planar");
}

#[test]
fn the_truth_stays_a_rotation_over_ten_thousand_steps() {
    let recording = drawn::<3>(&long_walk("room"), 0);
    let last = recording.truth[9_999].unwrap();
    assert!(defect(last.rotation.matrix()) < 3e-15, "{}", defect(last.rotation.matrix()));
}

#[test]
fn trials_seeds_and_neighbouring_streams_are_independent() {
    use rangelab::simulate::random::{Part, Stream};
    let normals = |seed, trial, part| {
        let mut stream = Stream::new(seed, trial, part);
        (0..20_000).map(|_| stream.normal()).collect::<Vec<_>>()
    };
    let mut streams = Vec::new();
    for (seed, trial) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (u64::MAX, 7)] {
        for part in [Part::Anchors, Part::Motion, Part::Epoch(0), Part::Epoch(1), Part::Mounting] {
            streams.push(normals(seed, trial, part));
        }
    }
    for (i, stream) in streams.iter().enumerate() {
        let sample = Sample::new(stream.iter().copied());
        assert!(sample.is_standard_normal(), "{i}: {:?}", sample.standard_normal_deviations());
        for (j, other) in streams.iter().enumerate().take(i) {
            assert!(correlation_deviation(stream, other).abs() < LIMIT, "streams {i} and {j}");
        }
    }
    let twice = correlation_deviation(&streams[0], &normals(0, 0, Part::Anchors));
    assert!(twice > 10.0 * LIMIT, "the same stream must be seen to be dependent");
}

/// The first draw of many streams, which is where a poor mix of seed and trial would show.
#[test]
fn first_draws_of_many_trials_are_uniform_and_uncorrelated() {
    use rangelab::simulate::random::{Part, Stream};
    for by_seed in [false, true] {
        let first = |i: u64| {
            let (seed, trial) = if by_seed { (i, 3) } else { (3, i) };
            Stream::new(seed, trial, Part::Motion).uniform()
        };
        let draws: Vec<f64> = (0..50_000).map(first).collect();
        let deviations = Sample::new(draws.iter().copied()).uniform_deviations();
        assert!(deviations.iter().all(|x| x.abs() < LIMIT), "{deviations:?}");
        let standard: Vec<f64> = draws.iter().map(|u| (u - 0.5) * sqrt(12.0)).collect();
        for lag in 1..=8 {
            let deviation = correlation_deviation(&standard[lag..], &standard[..standard.len() - lag]);
            assert!(deviation.abs() < LIMIT, "lag {lag}: {deviation}");
        }
    }
}

#[test]
fn ranges_go_missing_as_often_as_asked_and_the_same_ones_first() {
    let with = |missing_probability: f64| {
        let scenario = at_rest(RangeNoise::Range { sigma: 0.05 }, Weighting::Common);
        drawn::<3>(&Scenario { missing_probability, ..scenario }, 0)
    };
    let count = |r: &Recording<3>| r.epochs.iter().map(|epoch| epoch.ranges.missing()).sum::<usize>() as f64;
    let pairs = (STEPS * 20) as f64;
    let (few, many) = (with(0.2), with(0.3));
    for (recording, p) in [(&few, 0.2), (&many, 0.3)] {
        let deviation = (count(recording) - p * pairs) / sqrt(pairs * p * (1.0 - p));
        assert!(deviation.abs() < LIMIT, "{p}: {deviation}");
    }
    for (a, b) in few.epochs.iter().zip(&many.epochs) {
        for (m, n) in (0..4).flat_map(|m| (0..5).map(move |n| (m, n))) {
            assert!(b.ranges.get(m, n).is_none() || b.ranges.get(m, n) == a.ranges.get(m, n));
        }
    }
    assert_eq!((count(&with(0.0)), count(&with(1.0))), (0.0, pairs));
}

/// The normal numbers behind the ranges of a scenario whose noise is `Range`.
fn normals(scenario: &Scenario, sigma: f64) -> Vec<f64> {
    residuals(&drawn::<3>(scenario, 5), |d, exact, _| (sqrt(d) - sqrt(exact)) / sigma)
}

#[test]
fn draws_are_common_to_scenarios_that_differ_in_geometry_and_noise() {
    let scenario = Scenario { steps: 30, ..preset("room").unwrap() };
    let (anchors, sensors) = (scenario.anchors.len(), scenario.sensors.len());
    let close =
        |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-9);
    let before = normals(&scenario, 0.01);
    let mut moved = scenario.clone();
    moved.anchors[2] = vec![5.0, 4.0, 2.0];
    moved.start.position[0] += 0.2;
    moved.noise = RangeNoise::Range { sigma: 0.04 };
    assert!(close(&before, &normals(&moved, 0.04)), "an anchor moved");
    let longer = Scenario { steps: 40, ..scenario.clone() };
    assert!(close(&before, &normals(&longer, 0.01)[..before.len()]), "more steps");
    let mut more = scenario.clone();
    more.anchors.push(vec![3.0, 2.5, 2.6]);
    let with_one_more = normals(&more, 0.01);
    for k in 0..30 {
        let (old, new) = (k * anchors * sensors, k * (anchors + 1) * sensors);
        let size = anchors * sensors;
        assert!(close(&before[old..old + size], &with_one_more[new..new + size]), "an anchor more, step {k}");
    }
    let other_seed = Scenario { seed: 2, ..scenario };
    assert!(!close(&before, &normals(&other_seed, 0.01)));
}

#[test]
fn redrawn_anchors_fill_the_cube_and_leave_the_track_alone() {
    let half_width = 1000.0;
    let fixed = Scenario { steps: 1, ..preset("tracking-paper").unwrap() };
    let redrawn = Scenario { redraw_anchors: Some(RedrawAnchors { half_width }), ..fixed.clone() };
    let mut coordinates = Vec::new();
    for trial in 0..4000 {
        let recording = drawn::<3>(&redrawn, trial);
        coordinates.extend(recording.model.anchors().positions().iter().flat_map(|a| a.iter().copied()));
        assert_eq!(recording.truth, drawn::<3>(&fixed, trial).truth);
    }
    let unit = coordinates.iter().map(|x| 0.5 + 0.5 * x / half_width);
    assert!(unit.clone().all(|u| (0.0..1.0).contains(&u)));
    let deviations = Sample::new(unit).uniform_deviations();
    assert!(deviations.iter().all(|x| x.abs() < LIMIT), "{deviations:?}");
}

#[test]
fn true_weights_come_with_the_exact_ranges_and_measured_ones_without() {
    let scenario = preset("tracking-paper").unwrap();
    assert!(drawn::<3>(&scenario, 0).epochs.iter().all(|epoch| epoch.true_ranges.is_none()));
    let recording = drawn::<3>(&Scenario { weights: WeightSource::True, ..scenario }, 0);
    for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
        let exact = recording.model.exact_ranges(&truth.unwrap().into()).unwrap();
        assert_eq!(epoch.true_ranges.as_ref(), Some(&exact));
        assert_ne!(epoch.ranges, exact);
    }
}

fn stays_between<const D: usize>(name: &str, most: [f64; D]) {
    for trial in 0..100 {
        for pose in drawn::<D>(&preset(name).unwrap(), trial).truth {
            for (i, &x) in pose.unwrap().position.iter().enumerate() {
                assert!(0.3 < x && x < most[i] - 0.3, "{name}, trial {trial}: coordinate {i} is {x}");
            }
        }
    }
}

#[test]
fn indoor_presets_stay_indoors() {
    for each in PRESETS {
        match each.name {
            "planar" => stays_between("planar", [10.0, 8.0]),
            "figure-eight" => stays_between("figure-eight", [22.0, 8.0]),
            "corridor" => stays_between("corridor", [32.0, 3.0]),
            "towers" => (),
            paper if paper.contains("-paper") => (),
            name => stays_between(name, [6.0, 5.0, 2.8]),
        }
    }
}

#[test]
fn every_preset_can_be_simulated() {
    for each in PRESETS {
        let scenario = each.scenario();
        assert_eq!(scenario.name, each.name);
        let epochs = rangelab::with_dimension!(scenario.dimension, D => {
            simulate::<D>(&scenario, 0).map(|recording| recording.epochs.len())
        });
        assert_eq!(epochs, Ok(scenario.steps), "{}", each.name);
    }
}
