//! Optima that are known. Ranges of constant sigma see only directions: a body that is small beside its distance is seen
//! best where the directions to M anchors balance, `sum e e^T = M/D I`, with `J = M N/(D sigma^2) I` about the position.
//! A regular polygon does it in the plane, a regular solid in space.

use core::f64::consts::TAU;

use rangelab::math::float::{cos, sin};
use rangelab::model::noise::RangeNoise;
use rangelab::model::placement_settings::{Criterion, Target};
use rangelab::model::scenario::Scenario;
use rangelab::place::improve;

use crate::scenes::{CRITERIA, FORMS, cube, placement, points, scenario, typed};
use crate::support::sampling::Sampler;

const SIGMA: f64 = 0.1;
const SENSORS: usize = 4;

/// A body of a centimetre at the origin, anchors within 10 m of it along each axis.
fn small_body(dimension: usize, anchors: Vec<Vec<f64>>) -> Scenario {
    let mut scenario = scenario(dimension, RangeNoise::Range { sigma: SIGMA });
    let sensors = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    scenario.sensors = sensors.map(|c| c[..dimension].iter().map(|x| 0.005 * x).collect()).into();
    scenario.placement.limits = Some(cube(dimension, 10.0));
    scenario.anchors = anchors;
    scenario
}

/// `sqrt(tr C)`, geometric mean and largest of `D` equal standard deviations `sigma sqrt(D/(M N))`.
fn optimum(dimension: usize, criterion: Criterion, anchors: usize) -> f64 {
    let one = SIGMA * (dimension as f64 / (anchors * SENSORS) as f64).sqrt();
    if criterion == Criterion::A { one * (dimension as f64).sqrt() } else { one }
}

#[test]
fn regular_polygons_have_the_value_that_is_known() {
    for count in 3..=6 {
        let corner = |m: usize| {
            let angle = TAU * m as f64 / count as f64 + 0.2;
            vec![5.0 * cos(angle), 5.0 * sin(angle)]
        };
        for form in FORMS {
            for criterion in CRITERIA {
                let mut scenario = small_body(2, (0..count).map(corner).collect());
                (scenario.field.form, scenario.placement.criterion) = (form, criterion);
                let value = placement::<2>(&scenario).value(&typed(&scenario.anchors)).unwrap();
                let ratio = value / optimum(2, criterion, count);
                assert!((ratio - 1.0).abs() < 1e-4, "{count} {form:?} {criterion:?}: {ratio}");
                let after = improve(&scenario, 0).unwrap().after.unwrap();
                assert!(after <= value && after > value * (1.0 - 1e-3), "nothing is better: {after} {value}");
            }
        }
    }
}

/// Anchors anywhere find the optimum, or at least the best of few restarts does.
fn search_finds_the_optimum<const D: usize>(count: usize, restarts: u64) {
    let mut sampler = Sampler::new(count as u64);
    for form in FORMS {
        for criterion in CRITERIA {
            let mut scenario = small_body(D, points::<D>(&mut sampler, count, 10.0));
            (scenario.field.form, scenario.placement.criterion) = (form, criterion);
            let found = (0..restarts).map(|restart| improve(&scenario, restart).unwrap());
            let ratios: Vec<f64> =
                found.map(|found| found.after.unwrap() / optimum(D, criterion, count)).collect();
            let best = ratios.iter().copied().fold(f64::INFINITY, f64::min);
            assert!((best - 1.0).abs() < 0.01, "{count} {form:?} {criterion:?}: {ratios:?}");
        }
    }
}

#[test]
fn three_four_and_five_anchors_in_the_plane() {
    for count in 3..=5 {
        search_finds_the_optimum::<2>(count, 4);
    }
}

#[test]
fn four_and_six_anchors_in_space() {
    for count in [4, 6] {
        search_finds_the_optimum::<3>(count, 4);
    }
}

/// A rod along x turns as its ends move along y: anchors on the y axis see it best, `J = M sum |c|^2/sigma^2`, and each
/// shares its anchors with the position so little that it is not seen along the rod; orientation alone is asked for.
#[test]
fn a_rod_is_turned_best_by_anchors_across_it() {
    let mut scenario =
        small_body(2, vec![vec![3.0, 8.0], vec![-7.0, -2.0], vec![1.0, -6.0], vec![-4.0, 5.0]]);
    scenario.sensors = vec![vec![-0.005, 0.0], vec![0.005, 0.0]];
    scenario.placement.target = Target::Orientation;
    let found = improve(&scenario, 0).unwrap();
    let best = SIGMA / (4.0 * 2.0 * 0.005_f64 * 0.005).sqrt();
    assert_eq!(found.unit, "rad");
    let ratio = found.after.unwrap() / best;
    assert!((0.999..1.01).contains(&ratio), "{ratio}: {:?}", found.anchors);
}
