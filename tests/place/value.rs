//! The value against the numbers that the field and the exploration of a pose give, and scenes at the edge of what
//! doubles hold.

use rangelab::bounds::field::field_of;
use rangelab::model::field_settings::Quantity;
use rangelab::model::noise::RangeNoise;
use rangelab::model::placement_settings::{Over, Target};
use rangelab::place::{advise, improve};
use rangelab::study::exploration::explore;

use crate::in_plane_and_space;
use crate::scenes::{CRITERIA, FORMS, OVERS, TARGETS, placement, random, typed};

in_plane_and_space!(
    the_value_is_that_of_the_field_and_of_exploration,
    scenes_at_the_edge_give_numbers_or_a_cause
);

fn the_value_is_that_of_the_field_and_of_exploration<const D: usize>() {
    for trial in 0..6 {
        for form in FORMS {
            let mut scenario = random::<D>(trial);
            (scenario.field.form, scenario.placement.region) = (form, None);
            for (target, quantity) in
                [(Target::Position, Quantity::Position), (Target::Orientation, Quantity::Orientation)]
            {
                (scenario.placement.target, scenario.field.quantity) = (target, quantity);
                let mut point = [0.0; 3];
                point[..D].copy_from_slice(&scenario.start.position);
                for headings in [1, 6] {
                    scenario.field.headings = headings;
                    let (value, field) = (
                        advise(&scenario).unwrap().value.unwrap(),
                        field_of::<D>(&scenario).unwrap().value(point),
                    );
                    assert!(
                        (value / field - 1.0).abs() < 1e-9,
                        "{trial} {form:?} {target:?}: {value} {field}"
                    );
                    let bound = explore(&scenario).unwrap().bound;
                    let sigma =
                        if target == Target::Position { bound.position_sigma } else { bound.angle_sigma };
                    let same = (value / sigma.unwrap() - 1.0).abs() < 1e-12;
                    assert!(same == (headings == 1), "{trial} {form:?} {target:?}: {value} {sigma:?}");
                }
            }
        }
    }
}

/// Criteria of one bound are ordered: the geometric mean lies below the largest deviation, that below the root of the
/// trace; and the worst place is no better than the mean.
#[test]
fn criteria_are_ordered() {
    for trial in 0..12 {
        let scenario = random::<3>(trial);
        let anchors = typed::<3>(&scenario.anchors);
        for target in TARGETS {
            let values = OVERS.map(|over| {
                CRITERIA.map(|criterion| {
                    let mut placement = placement::<3>(&scenario);
                    (placement.figure.criterion, placement.figure.target) = (criterion, target);
                    placement.over = over;
                    placement.value(&anchors).unwrap()
                })
            });
            for (over, [a, d, e]) in OVERS.into_iter().zip(values) {
                assert!(d < e && e < a && a < 6.0_f64.sqrt() * e, "{target:?} {over:?}: {a} {d} {e}");
            }
            let worse = |k: usize| values[1][k] > values[0][k];
            assert!(OVERS[1] == Over::Worst && (0..3).all(worse), "{target:?}: {values:?}");
        }
    }
}

fn scenes_at_the_edge_give_numbers_or_a_cause<const D: usize>() {
    let noises = [
        RangeNoise::Range { sigma: 1e-9 },
        RangeNoise::Range { sigma: 1e9 },
        RangeNoise::Toa { zeta_db: 300.0 },
    ];
    let anchors = [
        vec![vec![0.0; D]; D + 2],
        vec![vec![1e9; D]; 1],
        (0..=D + 1)
            .map(|m| (0..D).map(|i| if (m + i) % 2 == 0 { 1e9 } else { -1e9 / (m + 1) as f64 }).collect())
            .collect(),
        (0..=D + 1).map(|m| (0..D).map(|i| 1e-9 * ((m * m + i) % 5) as f64).collect()).collect(),
    ];
    let mut seen = 0;
    for (trial, anchors) in anchors.iter().enumerate() {
        for (noise, criterion) in noises.into_iter().zip(CRITERIA) {
            for over in OVERS {
                let mut scenario = random::<D>(trial);
                (scenario.anchors, scenario.noise, scenario.placement.over) = (anchors.clone(), noise, over);
                (scenario.placement.criterion, scenario.placement.limits) = (criterion, None);
                let Ok(found) = improve(&scenario, 1) else { continue };
                assert!(found.anchors.iter().flatten().all(|x| x.is_finite()));
                assert!(found.after.is_some() != found.cause.is_some());
                assert!(found.after.is_none_or(|after| after > 0.0 && after.is_finite()), "{found:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 12, "only {seen} of 24 were answered");
}
