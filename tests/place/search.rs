//! What the search promises: never worse, a way out of what is not seen, the same bits again.

use rangelab::model::noise::RangeNoise;
use rangelab::model::placement_settings::{Over, Target};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::place::improve;

use crate::in_plane_and_space;
use crate::scenes::{CRITERIA, OVERS, TARGETS, cube, placement, random, scenario, typed};

in_plane_and_space!(never_worse_than_the_start, restarts_are_bits, what_is_found_is_what_it_is_worth);

fn never_worse_than_the_start<const D: usize>() {
    let mut gains = Vec::new();
    for trial in 0..12 {
        let mut scenario = random::<D>(trial);
        scenario.placement.criterion = CRITERIA[trial % 3];
        scenario.placement.target = TARGETS[(trial / 3) % 3];
        scenario.placement.over = OVERS[trial % 2];
        scenario.field.form = if trial % 4 < 2 { RangeForm::Raw } else { RangeForm::Projected };
        let found = improve(&scenario, 0).unwrap();
        let (before, after) = (found.before.unwrap(), found.after.unwrap());
        assert!(after <= before, "{trial}: {before} became {after}");
        gains.push(after / before);
    }
    let gained = gains.iter().filter(|gain| **gain < 0.9).count();
    assert!(gained > 8, "random anchors can be bettered by more than a tenth: {gains:?}");
}

fn what_is_found_is_what_it_is_worth<const D: usize>() {
    let scenario = random::<D>(1);
    let found = improve(&scenario, 2).unwrap();
    let moved = found.applied_to(&scenario);
    let value = placement::<D>(&moved).value(&typed(&moved.anchors)).unwrap();
    assert_eq!((Some(value), found.restart, found.cause.as_deref()), (found.after, 2, None));
    assert_eq!(improve(&moved, 0).unwrap().before, found.after);
}

fn restarts_are_bits<const D: usize>() {
    let scenario = random::<D>(3);
    let found: Vec<_> = (0..3).map(|restart| improve(&scenario, restart).unwrap()).collect();
    for restart in [2, 1, 0] {
        assert_eq!(improve(&scenario, restart as u64).unwrap(), found[restart]);
    }
    assert!(found[0].anchors != found[1].anchors && found[1].anchors != found[2].anchors);
    let other = Scenario { seed: scenario.seed + 1, ..scenario };
    assert_eq!(improve(&other, 0).unwrap(), found[0], "restart 0 draws nothing");
    assert_ne!(improve(&other, 1).unwrap(), found[1]);
}

/// Anchors at one height do not see the height once `||s||^2` is projected out, and by symmetry no slope shows the way.
#[test]
fn anchors_in_one_plane_leave_it() {
    let mut scenario = scenario(3, RangeNoise::Range { sigma: 0.02 });
    scenario.anchors = [[0.0, 0.0], [6.0, 0.0], [6.0, 5.0], [0.0, 5.0]].map(|p| vec![p[0], p[1], 3.0]).into();
    scenario.sensors = vec![vec![0.3, 0.0, 0.0], vec![-0.1, 0.3, 0.0], vec![-0.2, -0.3, 0.1]];
    scenario.start.position = vec![2.0, 2.0, 1.0];
    scenario.field.form = RangeForm::Projected;
    scenario.placement.limits = Some(cube(3, 8.0));
    for target in TARGETS {
        scenario.placement.target = target;
        let found = improve(&scenario, 0).unwrap();
        assert_eq!(found.before, None);
        assert!(found.after.is_some_and(|after| after < 1.0), "{target:?}: {found:?}");
    }
}

#[test]
fn what_no_anchors_can_see_has_its_cause_named() {
    let mut scenario = scenario(3, RangeNoise::Range { sigma: 0.02 });
    scenario.anchors = (0..6).map(|m| vec![f64::from(m), f64::from(m * m), f64::from(m % 2)]).collect();
    scenario.sensors = vec![vec![-0.5, 0.0, 0.0], vec![0.5, 0.0, 0.0], vec![0.1, 0.0, 0.0]];
    let found = improve(&scenario, 1).unwrap();
    assert_eq!((found.before, found.after), (None, None));
    assert!(found.cause.is_some_and(|cause| cause.contains("sensors lie on one line")));
}

/// The worst place counts: the search evens the places out, and is better there than the search for the mean.
#[test]
fn the_worst_place_is_bettered_most_where_it_counts() {
    let mut scenario = random::<2>(2);
    scenario.placement.target = Target::Position;
    scenario.placement.region = Some(cube(2, 4.0));
    let worst = |anchors: &[Vec<f64>]| {
        let mut judge = placement::<2>(&scenario);
        judge.over = Over::Worst;
        judge.value(&typed(anchors)).unwrap()
    };
    let best_of = |over: Over| {
        let mut chosen = scenario.clone();
        chosen.placement.over = over;
        let found = (0..6).map(|restart| improve(&chosen, restart).unwrap());
        found.min_by(|a, b| a.after.unwrap().total_cmp(&b.after.unwrap())).unwrap().anchors
    };
    let (mean, minimax) = (worst(&best_of(Over::Mean)), worst(&best_of(Over::Worst)));
    assert!(minimax < 0.98 * mean, "{minimax} for the worst, {mean} for the mean");
}
