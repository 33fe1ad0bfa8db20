//! NEES: with inputs that match, honest priors and honest covariances, the yardsticks are off by what they claim.

use rangelab::model::imu::Convention;
use rangelab::model::indoor::filter_settings::{FilterName, FixCovariance};
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::model::indoor::trajectory::IndoorPath;
use rangelab::model::indoor::{IndoorScenario, StartPrior};
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;

const FILTERS: [FilterName; 4] = [FilterName::Mekf, FilterName::LieKf, FilterName::Tight, FilterName::Ekf];

fn nees(scenario: &IndoorScenario, trials: usize) -> Vec<(f64, f64)> {
    let mut scenario = scenario.clone();
    scenario.filters.enabled = FILTERS.to_vec();
    let report = IndoorMonteCarlo::new(&scenario, trials).unwrap().run().unwrap();
    report
        .filters
        .iter()
        .map(|filter| (filter.summary.nees.value, filter.summary.nees.standard_error))
        .collect()
}

/// The preset's prior is 2 degrees wide: there the square of the angle, which no first-order filter knows of, is small
/// beside what the filters claim. At 5 degrees on the path U the MEKF stands at 1.16.
fn calibrated(path: IndoorPath, trials: usize) {
    let mut scenario = indoor_preset("indoor-delta").unwrap();
    scenario.path = path;
    scenario.beacons = indoor_preset(match path {
        IndoorPath::U => "indoor-u",
        IndoorPath::Stair => "indoor-stair",
        _ => "indoor-tumble",
    })
    .unwrap()
    .beacons;
    let figures = nees(&scenario, trials);
    for (name, (value, error)) in FILTERS[..3].iter().zip(&figures) {
        println!("{path:?} {name}: NEES/9 {value:.3} +- {error:.3}");
        assert!((0.9..=1.1).contains(value), "{path:?} {name}: NEES/9 {value:.3} +- {error:.3}");
    }
    assert!(figures[3].0 > 10.0, "the EKF is far off what it claims: {:?}", figures[3]);
}

#[test]
fn the_yardsticks_are_calibrated() {
    calibrated(IndoorPath::U, 200);
}

#[test]
#[ignore = "a minute"]
fn the_yardsticks_are_calibrated_on_all_paths() {
    calibrated(IndoorPath::U, 1000);
    calibrated(IndoorPath::Tumble, 1000);
    calibrated(IndoorPath::Stair, 300);
}

/// What is left falls with the square of the angle, as it must where it is the second order.
#[test]
fn a_wide_prior_bends() {
    let excess = |degrees: f64| {
        let mut scenario = indoor_preset("indoor-delta").unwrap();
        let angle = degrees.to_radians();
        scenario.start.prior = StartPrior::Tangent { angle, position: 0.1, velocity: 0.1 };
        nees(&scenario, 200)[0].0 - 1.0
    };
    let (narrow, wide) = (excess(4.0), excess(8.0));
    assert!((2.0..8.0).contains(&(wide / narrow)), "{narrow} {wide}");
}

/// The same comparison refuses a claim of too little and inputs that do not match.
#[test]
fn wrong_claims_are_seen() {
    let honest = indoor_preset("indoor-delta").unwrap();
    let mut sampled = honest.clone();
    sampled.imu.convention = Convention::Sample;
    let mut isotropic = honest;
    isotropic.filters.fix_covariance = FixCovariance::Isotropic;
    assert!(nees(&sampled, 40)[0].0 > 2.0);
    let figure = nees(&isotropic, 100)[0];
    assert!(!(0.9..=1.1).contains(&figure.0), "{figure:?}");
}
