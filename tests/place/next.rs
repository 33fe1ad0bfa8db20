//! One more anchor: its value, summed once and updated range by range, against the adviser's own with that anchor really
//! among the others.

use nalgebra::SVector;
use rangelab::bounds::field::{NONE, layout_of};
use rangelab::model::availability::AvailabilitySettings;
use rangelab::model::field_settings::Subject;
use rangelab::model::placement_settings::{Criterion, Over, Region, Target};
use rangelab::model::ranging::RangeForm;
use rangelab::model::scenario::Scenario;
use rangelab::place::{NextAnchor, advise, best_next, field_rows, next_at};

use crate::in_plane_and_space;
use crate::scenes::{CRITERIA, FORMS, OVERS, TARGETS, obstructed, placement, points, random, typed};
use crate::support::sampling::Sampler;

in_plane_and_space!(
    the_value_is_that_of_all_anchors_together,
    one_more_anchor_makes_seen_what_was_not,
    no_value_where_no_anchor_may_stand,
    the_best_place_is_better_than_every_cell
);

const TOLERANCE: f64 = 1e-9;

/// The scenario with anchors that reach as far as one likes, really among the others.
fn with<const D: usize>(scenario: &Scenario, more: &[Vec<f64>]) -> Scenario {
    let mut scenario = scenario.clone();
    scenario.anchors.extend_from_slice(more);
    if !scenario.availability.max_ranges.is_empty() {
        scenario.availability.max_ranges.resize(scenario.anchors.len(), None);
    }
    scenario
}

/// The adviser's value of all anchors.
fn value<const D: usize>(scenario: &Scenario) -> Option<f64> {
    placement::<D>(scenario).value(&typed(&scenario.anchors)).ok()
}

fn appended<const D: usize>(scenario: &Scenario, point: &[f64]) -> Option<f64> {
    value::<D>(&with::<D>(scenario, &[point.to_vec()]))
}

fn differ(one: f64, other: f64) -> bool {
    (one / other - 1.0).abs() > TOLERANCE
}

fn the_value_is_that_of_all_anchors_together<const D: usize>() {
    let (mut seen, mut blocked, mut doubled) = (0, 0, 0);
    for trial in 0..6 {
        let mut scenario = obstructed::<D>(trial);
        let candidates = points::<D>(&mut Sampler::new(100 + trial as u64), 6, 5.0);
        for choice @ (form, criterion, target, over) in every_choice() {
            scenario.field.form = form;
            (scenario.placement.criterion, scenario.placement.target) = (criterion, target);
            scenario.placement.over = over;
            let next = NextAnchor::<D>::of(&scenario).unwrap();
            let now = value::<D>(&scenario);
            let open = Scenario { availability: AvailabilitySettings::default(), ..scenario.clone() };
            for point in &candidates {
                let what = format!("{trial} {choice:?} {point:?}");
                let found = next.value(&SVector::from_column_slice(point));
                let Some(expected) = appended::<D>(&scenario, point) else {
                    assert_eq!(found.to_bits(), NONE.to_bits(), "{what}");
                    continue;
                };
                assert!(!differ(found, expected), "{what}: {found} {expected}");
                assert!(now.is_none_or(|now| found <= now * (1.0 + 1e-12)), "{what}: {found} {now:?}");
                let twice = value::<D>(&with::<D>(&scenario, &[point.clone(), point.clone()]));
                seen += 1;
                blocked += usize::from(appended::<D>(&open, point).is_some_and(|open| differ(found, open)));
                doubled += usize::from(twice.is_some_and(|twice| differ(found, twice)));
            }
        }
    }
    // Were walls forgotten, or the anchor counted twice, most values would show it.
    assert!(seen > 500 && 4 * blocked > 3 * seen && 4 * doubled > 3 * seen, "{seen} {blocked} {doubled}");
}

type Choice = (RangeForm, Criterion, Target, Over);

fn every_choice() -> Vec<Choice> {
    let mut choices = Vec::new();
    for form in FORMS {
        for criterion in CRITERIA {
            for target in TARGETS {
                choices.extend(OVERS.map(|over| (form, criterion, target, over)));
            }
        }
    }
    choices
}

/// Anchors in one line or plane, with what is normal to it projected out: nothing is seen along it, until one more
/// anchor stands beside it.
fn one_more_anchor_makes_seen_what_was_not<const D: usize>() {
    for trial in 0..3 {
        let mut scenario = random::<D>(trial);
        scenario.field.form = RangeForm::Projected;
        scenario.anchors.iter_mut().for_each(|anchor| anchor[D - 1] = 2.5);
        assert!(advise(&scenario).unwrap().value.is_none());
        let mut point = vec![0.5; D];
        let beside = next_at(&scenario, &point).unwrap();
        let (found, expected) = (beside.after.unwrap(), appended::<D>(&scenario, &point).unwrap());
        assert!(!differ(found, expected), "{trial}: {found} {expected}");
        assert_eq!((beside.before, beside.cause), (None, None));
        point[D - 1] = 2.5;
        let within = next_at(&scenario, &point).unwrap();
        assert_eq!(within.after, None);
        let cause = within.cause.unwrap();
        assert!(cause.contains("unitarily constrained bound"), "{cause}");
        assert!(best_next(&scenario).unwrap().unwrap().after.is_some());
    }
}

fn no_value_where_no_anchor_may_stand<const D: usize>() {
    let mut scenario = random::<D>(1);
    let (low, high) = (vec![1.0; D], vec![2.0; D]);
    scenario.placement.keep_out =
        vec![Region { low: vec![-9.0; D], high: vec![-8.0; D] }, Region { low, high }];
    let next = NextAnchor::<D>::of(&scenario).unwrap();
    for (coordinate, cause) in [
        (1.5, Some("no anchor may stand inside keep-out zone 2")),
        (5.5, Some("no anchor may stand outside the limits of the placement")),
        (2.5, None),
    ] {
        let value = next.value(&SVector::repeat(coordinate));
        assert_eq!(value < NONE, cause.is_none(), "{coordinate}: {value}");
        let place = next_at(&scenario, &vec![coordinate; D]).unwrap();
        assert_eq!((place.cause.as_deref(), place.after.is_some()), (cause, cause.is_none()));
    }
    scenario.placement.limits = None;
    let everywhere = NextAnchor::<D>::of(&scenario).unwrap();
    assert!(everywhere.value(&SVector::repeat(5.5)) < NONE, "without limits an anchor may stand anywhere");
    scenario.placement.limits = Some(Region { low: vec![100.0; D], high: vec![101.0; D] });
    assert_eq!(best_next(&scenario).unwrap(), None);
}

fn the_best_place_is_better_than_every_cell<const D: usize>() {
    for trial in 0..4 {
        let mut scenario = obstructed::<D>(trial);
        scenario.field.headings = 1;
        scenario.field.subject = Subject::NextAnchor;
        let best = best_next(&scenario).unwrap().unwrap();
        let after = best.after.unwrap();
        assert!(best.before.is_none_or(|before| after < before), "{trial}: {best:?}");
        assert!(!differ(after, appended::<D>(&scenario, &best.point).unwrap()));
        let layout = layout_of::<D>(&scenario, 60).unwrap();
        let values = field_rows(&scenario, &layout, 0, layout.height).unwrap();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(after <= least * 1.001, "{trial}: {after} {least}");
    }
}
