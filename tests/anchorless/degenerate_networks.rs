//! Networks and records in which there is little to be seen: an error that says so, or finite numbers.

use rangelab::Error;
use rangelab::anchorless::estimate;
use rangelab::bounds::kinematics::{KinematicsBound, KinematicsDesign};
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::coefficients::RelativeKinematics;
use rangelab::model::kinematics::distance_record::{DistanceRecord, pair_count};
use rangelab::model::kinematics::estimate::KinematicsEstimate;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::model::kinematics::stamps::{LEAST_SPREAD, Stamps};
use rangelab::simulate::kinematics::simulate_kinematics;
use rangelab::study::kinematics::bounds::kinematics_bounds;
use rangelab::study::kinematics::errors::Yardstick;

use crate::networks::{exact, motion, paper, random};

/// All numbers of an estimate are numbers.
pub fn is_finite(found: &KinematicsEstimate) -> bool {
    let motion = found.kinematics.iter().flat_map(RelativeKinematics::coefficients);
    let all = motion.chain(&found.gram).chain(found.snapshots.iter().flatten()).chain(&found.rotation);
    all.flat_map(|matrix| matrix.iter()).all(|value| value.is_finite()) && found.cost.is_finite()
}

#[track_caller]
fn sound(what: &str, scenario: &KinematicsScenario, record: &DistanceRecord) {
    for name in KinematicsName::ALL {
        match estimate(name, &scenario.estimators, record) {
            Ok(found) => assert!(is_finite(&found), "{what}, {name}: not finite"),
            Err(error) => {
                let sentence = error.to_string();
                assert!(!sentence.contains("NaN"), "{what}, {name}: {sentence}");
            }
        }
    }
}

#[track_caller]
fn simulated(what: &str, scenario: &KinematicsScenario) {
    for scenario in [scenario.clone(), exact(scenario.clone())] {
        sound(what, &scenario, &simulate_kinematics(&scenario, 0).unwrap().record);
    }
}

#[track_caller]
fn without_bound(scenario: &KinematicsScenario) {
    let stamps = scenario.setup().unwrap().stamps;
    let bound =
        KinematicsBound::new(&motion(scenario), &KinematicsDesign::distances(&stamps, &scenario.noise));
    assert!(matches!(bound, Err(Error::Degenerate { .. })), "{bound:?}");
}

fn changed(change: impl Fn(&mut KinematicsScenario)) -> KinematicsScenario {
    let mut scenario = paper(20);
    change(&mut scenario);
    scenario
}

#[test]
fn nothing_moves() {
    let still =
        changed(|scenario| scenario.coefficients[1..].iter_mut().flatten().flatten().for_each(|y| *y = 0.0));
    simulated("still", &still);
    without_bound(&still);
}

#[test]
fn constant_velocities() {
    let constant = changed(|scenario| scenario.coefficients[2].iter_mut().flatten().for_each(|y| *y = 0.0));
    simulated("constant", &constant);
    without_bound(&constant);
}

#[test]
fn nodes_on_a_line_and_in_a_plane() {
    let flat = |scenario: &mut KinematicsScenario| {
        scenario.coefficients.iter_mut().flatten().for_each(|point| *point.last_mut().unwrap() = 0.0);
    };
    let line = changed(flat);
    simulated("line", &line);
    without_bound(&line);
    let mut plane = random(40, 3, 8, 2);
    flat(&mut plane);
    simulated("plane", &plane);
    without_bound(&plane);
}

#[test]
fn nodes_that_are_one() {
    let twins =
        changed(|scenario| scenario.coefficients.iter_mut().for_each(|points| points[1] = points[0].clone()));
    simulated("twins", &twins);
    without_bound(&twins);
    let heap = changed(|scenario| {
        scenario.coefficients.iter_mut().for_each(|points| {
            let first = points[0].clone();
            points.fill(first);
        });
    });
    simulated("heap", &heap);
    without_bound(&heap);
}

#[test]
fn stamps_that_are_one_or_nearly() {
    for times in [vec![1.0; 8], (0..8).map(|k| 1.0 + 1e-6 * f64::from(k)).collect()] {
        simulated("stamps", &changed(|scenario| scenario.stamps = Stamps::Listed { times: times.clone() }));
    }
}

/// A document may not ask for them, a record that is put together by hand may.
#[test]
fn stamps_closer_than_any_clock() {
    for gap in [1e-9, 1e-19, 1e-80, 1e-200, 1e-310] {
        for (first, range_degree, degree) in [(0.0, 4, 2), (0.0, 16, 3), (0.5, 4, 2)] {
            let close = changed(|scenario| {
                let times = (0..18).map(|k| first + gap * f64::from(k)).collect();
                scenario.stamps = Stamps::Listed { times };
                (scenario.estimators.range_degree, scenario.estimators.degree) = (range_degree, degree);
            });
            let stamps = close.stamps.times();
            if !(stamps[17] > stamps[0]) {
                continue;
            }
            let [problem] = &close.validate()[..] else { panic!("{gap:e}: {:?}", close.validate()) };
            assert!(problem.to_string().starts_with("stamps is "), "{problem}");
            let wide = simulate_kinematics(&paper(18), 0).unwrap().record;
            let distances = (0..18).flat_map(|k| wide.distances(k).to_vec()).collect();
            let record = DistanceRecord::new(2, 10, stamps.clone(), distances, 0.01).unwrap();
            let record = record.with_accelerometers(wide.accelerometers().unwrap().clone()).unwrap();
            sound(&format!("{gap:e} s"), &close, &record);
            for design in [
                KinematicsDesign::distances(&stamps, &close.noise),
                KinematicsDesign::with_accelerometers(&stamps, &close.noise),
            ] {
                let bound = KinematicsBound::new(&motion(&paper(18)), &design);
                assert!(matches!(bound, Err(Error::Number { .. })), "{gap:e} s: {bound:?}");
            }
        }
    }
}

/// The shortest time that a document may take.
#[test]
fn stamps_as_close_as_they_may_be() {
    for first in [0.0, 999_999.0] {
        let close = changed(|scenario| {
            let times = (0..18).map(|k| first + LEAST_SPREAD * 1.01 * f64::from(k) / 17.0).collect();
            scenario.stamps = Stamps::Listed { times };
            (scenario.estimators.range_degree, scenario.estimators.degree) = (16, 8);
        });
        assert_eq!(close.validate(), []);
        simulated("close", &close);
        let (setup, noise) = (close.setup().unwrap(), close.noise);
        for report in kinematics_bounds(&close, &setup, &Yardstick::new(&close, &setup)) {
            let lists = [report.coefficients, report.gram, report.positions, report.aligned_positions];
            assert!(lists.iter().flatten().all(|value| value.is_finite()), "{first} s, {noise:?}");
        }
    }
}

#[test]
fn noise_that_drowns_everything() {
    simulated("noise", &changed(|scenario| scenario.noise.sigma_distance = 1e4));
    simulated("accelerations", &changed(|scenario| scenario.noise.sigma_acceleration = 1e4));
}

#[test]
fn distances_of_zero_and_none_at_all() {
    let scenario = paper(20);
    let stamps = scenario.setup().unwrap().stamps;
    for distance in [Some(0.0), None, Some(1e150), Some(1e300)] {
        let distances = vec![distance; pair_count(10) * stamps.len()];
        let record = DistanceRecord::new(2, 10, stamps.clone(), distances, 0.01).unwrap();
        sound("zero or none", &scenario, &record);
    }
}

#[test]
fn a_pair_that_never_measures() {
    let scenario = paper(20);
    let drawn = simulate_kinematics(&scenario, 0).unwrap().record;
    let distances = (0..20)
        .flat_map(|k| {
            drawn.distances(k).iter().enumerate().map(|(pair, d)| d.filter(|_| pair != 3)).collect::<Vec<_>>()
        })
        .collect();
    let record = DistanceRecord::new(2, 10, drawn.stamps().to_vec(), distances, 0.01).unwrap();
    sound("a pair", &scenario, &record);
}
