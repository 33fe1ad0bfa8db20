//! What is simulated for the figures of \[A\]: its network at some numbers of stamps.

use alloc::vec;
use alloc::vec::Vec;

use crate::model::kinematics::KinematicsScenario;
use crate::model::kinematics::presets::kinematics_preset;
use crate::model::kinematics::settings::KinematicsName::{
    self, Algorithm1Literal, Algorithm1Rank1, Algorithm1So, Algorithm2Literal, Algorithm2Rank1, Algorithm2So,
    MaximumLikelihood, MaximumLikelihoodAccelerometers, MultidimensionalScaling, RangePolynomial,
    SnapshotSync,
};
use crate::model::kinematics::stamps::Stamps;
use crate::study::figures::experiment::Experiment;
use crate::study::kinematics::sweep::KinematicsSweep;

type Experiments = Vec<(&'static str, Experiment)>;

/// Numbers of stamps at which curves are drawn. The paper does not say its own.
pub(super) const STAMPS: [usize; 7] = [10, 20, 50, 100, 200, 500, 1000];
/// Where one number of stamps is spoken of.
pub(super) const TEN: usize = 10;
pub(super) const HUNDRED: usize = 100;
pub(super) const THOUSAND: usize = 1000;

/// Where the experiments of Fig. 1 are: the interval of the paper, and with range polynomials of other degrees.
pub(super) const PAPER: usize = 0;
pub(super) const DEGREE_2: usize = 1;
pub(super) const DEGREE_3: usize = 2;
pub(super) const DEGREE_5: usize = 3;
pub(super) const DEGREE_6: usize = 4;
/// Where those are with another interval.
pub(super) const SHORT: usize = 5;
pub(super) const SHORTEST: usize = 6;
pub(super) const LONG: usize = 7;
pub(super) const ONE_SIDED: usize = 8;

/// Where those of Fig. 2b are beside the one of the paper.
pub(super) const MANY_STAMPS: usize = 1;
pub(super) const LITTLE_NOISE: usize = 2;

/// Instants of Fig. 2b, one every quarter of a second.
const INSTANTS: usize = 41;

pub(super) fn figure_1() -> Experiments {
    let of_ranges = |degree| sweep(&STAMPS, |it| polynomials(it, &[], degree));
    let on = |first: f64, last: f64, names: &[KinematicsName], degree| {
        sweep(&[HUNDRED], |it| {
            it.stamps = Stamps::Regular { first, last, count: HUNDRED };
            polynomials(it, names, degree);
        })
    };
    let algorithms = [Algorithm1Rank1, Algorithm2Rank1];
    vec![
        ("-5 to 5 s, range polynomial of degree 4", sweep(&STAMPS, |it| polynomials(it, &algorithms, 4))),
        ("-5 to 5 s, range polynomial of degree 2", of_ranges(2)),
        ("-5 to 5 s, range polynomial of degree 3", of_ranges(3)),
        ("-5 to 5 s, range polynomial of degree 5", of_ranges(5)),
        ("-5 to 5 s, range polynomial of degree 6", of_ranges(6)),
        ("-3 to 3 s, range polynomial of degree 3", on(-3.0, 3.0, &algorithms[..1], 3)),
        ("-1 to 1 s, range polynomial of degree 2", on(-1.0, 1.0, &algorithms[..1], 2)),
        ("-10 to 10 s, range polynomial of degree 4", on(-10.0, 10.0, &algorithms[..1], 4)),
        ("0 to 10 s, range polynomial of degree 4", on(0.0, 10.0, &algorithms, 4)),
    ]
}

pub(super) fn figure_2a() -> Experiments {
    let names = [
        Algorithm1Literal,
        Algorithm1Rank1,
        Algorithm1So,
        Algorithm2Literal,
        Algorithm2Rank1,
        Algorithm2So,
        SnapshotSync,
        MaximumLikelihood,
        MaximumLikelihoodAccelerometers,
    ];
    vec![("-5 to 5 s", sweep(&STAMPS, |it| it.estimators.enabled = names.to_vec()))]
}

pub(super) fn figure_2b() -> Experiments {
    let names = [
        Algorithm1Rank1,
        Algorithm2Rank1,
        Algorithm2So,
        SnapshotSync,
        MaximumLikelihood,
        MaximumLikelihoodAccelerometers,
        MultidimensionalScaling,
    ];
    let over_time = |stamps, names: &[KinematicsName], parts: f64| {
        sweep(&[stamps], |it| {
            it.steps = INSTANTS;
            it.estimators.enabled = names.to_vec();
            it.noise.sigma_distance *= parts;
            it.noise.sigma_acceleration *= parts;
        })
    };
    vec![
        ("100 stamps", over_time(HUNDRED, &names, 1.0)),
        ("1000 stamps", over_time(THOUSAND, &[Algorithm1Rank1, Algorithm2So], 1.0)),
        (
            "100 stamps, a thousandth of the noise",
            over_time(HUNDRED, &[Algorithm1Rank1, Algorithm2Rank1], 1e-3),
        ),
    ]
}

fn polynomials(scenario: &mut KinematicsScenario, others: &[KinematicsName], degree: usize) {
    scenario.estimators.enabled = [others, &[RangePolynomial]].concat();
    scenario.estimators.range_degree = degree;
}

/// With positions compared at the ends and in the middle, where it is not said otherwise.
fn sweep(stamps: &[usize], change: impl Fn(&mut KinematicsScenario)) -> Experiment {
    let mut scenario = kinematics_preset("kinematics-paper").expect("the preset exists");
    scenario.steps = 3;
    change(&mut scenario);
    Experiment::Kinematics(KinematicsSweep::new(scenario, stamps).expect("the scenario is valid"))
}
