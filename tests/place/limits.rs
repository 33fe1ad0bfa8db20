//! Where anchors may stand.

use nalgebra::SVector;
use rangelab::Error;
use rangelab::model::availability::Obstacle;
use rangelab::model::placement_settings::Region;
use rangelab::model::scenario::Scenario;
use rangelab::place::{Zone, improve};

use crate::in_plane_and_space;
use crate::scenes::{cube, placement, random, typed};
use crate::support::sampling::Sampler;

in_plane_and_space!(
    fixed_anchors_do_not_move,
    limits_and_keep_out_zones_are_kept,
    places_are_projected_into_the_zone,
    anchors_outside_are_moved_inside
);

fn inside(region: &Region, point: &[f64], open: bool) -> bool {
    let axes = point.iter().zip(region.low.iter().zip(&region.high));
    let within = |(x, (low, high)): (&f64, (&f64, &f64))| {
        if open { low < x && x < high } else { low <= x && x <= high }
    };
    axes.into_iter().all(within)
}

/// Two zones that overlap and one at the rim of the limits.
fn with_zones<const D: usize>(trial: usize) -> Scenario {
    let mut scenario = random::<D>(trial);
    let zone = |low: f64, high: f64| Region { low: vec![low; D], high: vec![high; D] };
    scenario.placement.keep_out = vec![zone(-4.0, -1.0), zone(-2.0, 1.0), zone(3.0, 7.0)];
    scenario
}

fn fixed_anchors_do_not_move<const D: usize>() {
    for trial in 0..4 {
        let mut scenario = random::<D>(trial);
        scenario.placement.fixed = vec![0, 2];
        for restart in 0..3 {
            let found = improve(&scenario, restart).unwrap();
            for (m, (before, after)) in scenario.anchors.iter().zip(&found.anchors).enumerate() {
                assert_eq!(
                    before == after,
                    m == 0 || m == 2,
                    "anchor {m} of trial {trial}, restart {restart}"
                );
            }
        }
        scenario.placement.fixed = (0..scenario.anchors.len()).collect();
        assert_eq!(improve(&scenario, 1).unwrap().anchors, scenario.anchors);
    }
}

fn limits_and_keep_out_zones_are_kept<const D: usize>() {
    let (mut at_the_rim, mut at_a_face) = (0, 0);
    for trial in 0..6 {
        let scenario = with_zones::<D>(trial);
        for restart in 0..3 {
            for anchor in improve(&scenario, restart).unwrap().anchors {
                assert!(inside(&cube(D, 5.0), &anchor, false), "{anchor:?}");
                let keep_out = &scenario.placement.keep_out;
                assert!(!keep_out.iter().any(|zone| inside(zone, &anchor, true)), "{anchor:?}");
                at_the_rim += usize::from(anchor.iter().any(|x| x.abs() >= 5.0));
                at_a_face += usize::from(anchor.iter().any(|x| [-4.0, -2.0, -1.0, 1.0, 3.0].contains(x)));
            }
        }
    }
    assert!(
        at_the_rim > 0 && at_a_face > 0,
        "what was never reached was not tried: {at_the_rim} {at_a_face}"
    );
}

fn places_are_projected_into_the_zone<const D: usize>() {
    let scenario = with_zones::<D>(0);
    let zone = Zone::<D>::new(&scenario.placement, &typed(&scenario.anchors)).unwrap();
    let mut sampler = Sampler::new(1);
    for _ in 0..1000 {
        let point = SVector::from_fn(|_, _| sampler.uniform(-8.0, 8.0));
        let place = zone.project(&point).expect("there is room");
        assert!(zone.allows(&place), "{point:?} went to {place:?}");
        assert_eq!(zone.project(&place), Some(place), "what is inside stays");
    }
}

fn anchors_outside_are_moved_inside<const D: usize>() {
    let mut scenario = random::<D>(2);
    scenario.anchors[1] = vec![50.0; D];
    let found = improve(&scenario, 0).unwrap();
    assert!(inside(&cube(D, 5.0), &found.anchors[1], false));
}

#[test]
fn without_limits_anchors_stay_in_their_box() {
    let mut scenario = random::<3>(0);
    scenario.placement.limits = None;
    for anchor in improve(&scenario, 1).unwrap().anchors {
        for i in 0..3 {
            let along = || scenario.anchors.iter().map(|anchor| anchor[i]);
            assert!(anchor[i] >= along().fold(f64::INFINITY, f64::min));
            assert!(anchor[i] <= along().fold(f64::NEG_INFINITY, f64::max));
        }
    }
}

#[test]
fn zones_that_leave_no_place_are_refused() {
    let mut scenario = random::<2>(0);
    scenario.placement.keep_out = vec![cube(2, 6.0)];
    let Err(Error::Invalid { problems, .. }) = improve(&scenario, 0) else { panic!("refused") };
    assert_eq!(problems[0].path, "placement.keep_out");
    scenario.placement.fixed = (0..scenario.anchors.len()).collect();
    assert_eq!(improve(&scenario, 0).unwrap().anchors, scenario.anchors);
}

/// A range that cannot be measured is as good as no anchor; walls and reach count.
#[test]
fn ranges_that_are_not_available_do_not_count() {
    let mut scenario = random::<2>(0);
    scenario.anchors =
        vec![vec![-4.0, 4.5], vec![4.5, 4.0], vec![4.0, -4.5], vec![-4.5, -4.0], vec![0.0, 4.9]];
    let value = |scenario: &Scenario| placement::<2>(scenario).value(&typed(&scenario.anchors)).unwrap();
    let all = value(&scenario);
    let mut without = scenario.clone();
    without.anchors.pop();
    let wall = Obstacle::Wall { from: vec![-1.0, 4.5], to: vec![1.0, 4.5], bottom: None, top: None };
    let mut walled = scenario.clone();
    walled.availability.obstacles = vec![wall];
    assert!(value(&walled) > 1.01 * all);
    assert_eq!(value(&walled).to_bits(), value(&without).to_bits());
    scenario.availability.max_ranges = vec![None, None, None, None, Some(0.5)];
    assert_eq!(value(&scenario).to_bits(), value(&without).to_bits());
    let found = improve(&scenario, 0).unwrap();
    assert!(found.after < found.before, "{found:?}");
}

#[test]
fn where_nothing_is_measured_nothing_moves_and_the_cause_is_named() {
    let mut scenario = random::<3>(0);
    scenario.availability.max_ranges = vec![Some(1e-3); scenario.anchors.len()];
    let found = improve(&scenario, 0).unwrap();
    assert_eq!((found.before, found.after), (None, None));
    assert!(found.cause.is_some_and(|cause| cause.contains("No range was measured")));
}
