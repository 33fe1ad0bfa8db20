//! Ranges that cannot be measured: too long, or behind something.

use nalgebra::{Vector2, Vector3};
use rangelab::math::pose::Pose;
use rangelab::model::availability::{Availability, Obstacle};
use rangelab::model::field_settings::FieldSettings;
use rangelab::model::presets::preset;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::simulate;

use super::{all_settings, compare};

fn wall(from: [f64; 2], to: [f64; 2], bottom: Option<f64>, top: Option<f64>) -> Obstacle {
    Obstacle::Wall { from: from.to_vec(), to: to.to_vec(), bottom, top }
}

fn block(low: [f64; 3], high: [f64; 3]) -> Obstacle {
    Obstacle::Box { low: low.to_vec(), high: high.to_vec() }
}

fn with(obstacles: Vec<Obstacle>) -> Availability<3> {
    let mut scenario = preset("room").unwrap();
    scenario.availability.obstacles = obstacles;
    scenario.setup::<3>().unwrap().availability
}

fn free(availability: &Availability<3>, from: [f64; 3], to: [f64; 3]) -> bool {
    availability.allows(0, &Vector3::from(from), &Vector3::from(to))
}

#[test]
fn walls_block_what_crosses_them_and_nothing_else() {
    let wall = with(vec![wall([1.0, 0.0], [1.0, 2.0], Some(0.0), Some(2.0))]);
    assert!(!free(&wall, [0.0, 1.0, 1.0], [2.0, 1.0, 1.0]), "straight through");
    assert!(!free(&wall, [0.0, 0.5, 0.5], [3.0, 2.5, 1.5]), "askew");
    assert!(free(&wall, [0.0, 1.0, 2.5], [2.0, 1.0, 2.5]), "above");
    assert!(free(&wall, [0.0, 3.0, 1.0], [2.0, 3.0, 1.0]), "beside");
    assert!(free(&wall, [0.0, 1.0, 1.0], [0.9, 1.0, 1.0]), "before");
    assert!(free(&wall, [1.0, -1.0, 1.0], [1.0, 3.0, 1.0]), "within its own plane");
    assert!(free(&wall, [1.0, 1.0, 1.0], [2.0, 1.3, 1.0]), "an anchor that hangs on it");
}

#[test]
fn boxes_block_what_passes_through_them() {
    let boxed = with(vec![block([1.0, 1.0, 0.0], [2.0, 2.0, 1.0])]);
    assert!(!free(&boxed, [0.0, 1.5, 0.5], [3.0, 1.5, 0.5]));
    assert!(!free(&boxed, [1.5, 1.5, 3.0], [1.5, 1.5, -1.0]), "from above");
    assert!(free(&boxed, [0.0, 1.5, 0.5], [1.0, 1.5, 0.5]), "up to its face");
    assert!(free(&boxed, [0.0, 1.5, 1.2], [3.0, 1.5, 1.2]), "over it");
    assert!(free(&boxed, [0.0, 0.0, 0.5], [0.9, 3.0, 0.5]), "past its corner");
}

/// Points of the segment, many of them, against the inside of the box: slow and sure.
#[test]
fn separating_axes_agree_with_walking_along_the_line() {
    let (low, high) = ([-0.3, -0.5, -0.2], [0.4, 0.6, 0.7]);
    let boxed = with(vec![block(low, high)]);
    let mut random = 12345_u64;
    let mut uniform = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 11) as f64 / (1_u64 << 53) as f64 * 3.0 - 1.5
    };
    let mut blocked = 0;
    for _ in 0..2000 {
        let (a, b) = ([uniform(), uniform(), uniform()], [uniform(), uniform(), uniform()]);
        let deepest = (0..=4000).map(|k| {
            let share = f64::from(k) / 4000.0;
            let inside = |i: usize| {
                let x = a[i] + share * (b[i] - a[i]);
                (x - low[i]).min(high[i] - x)
            };
            inside(0).min(inside(1)).min(inside(2))
        });
        let deepest = deepest.fold(f64::NEG_INFINITY, f64::max);
        // Lines that graze a face are neither.
        if deepest.abs() > 2e-3 {
            assert_eq!(free(&boxed, a, b), deepest < 0.0, "{a:?} to {b:?}, {deepest} deep");
            blocked += usize::from(deepest > 0.0);
        }
    }
    assert!(blocked > 200, "{blocked} blocked");
}

#[test]
fn in_the_plane_heights_mean_nothing() {
    let mut scenario = preset("planar").unwrap();
    scenario.availability.obstacles = vec![wall([1.0, 0.0], [1.0, 2.0], Some(5.0), Some(6.0))];
    let availability = scenario.setup::<2>().unwrap().availability;
    assert!(!availability.allows(0, &Vector2::new(0.0, 1.0), &Vector2::new(2.0, 1.0)));
    assert!(availability.allows(0, &Vector2::new(0.0, 3.0), &Vector2::new(2.0, 3.0)));
}

#[test]
fn anchors_reach_as_far_as_they_are_told() {
    let mut scenario = preset("room").unwrap();
    scenario.availability.max_ranges = vec![Some(2.0), None, None, None, None, None];
    let availability = scenario.setup::<3>().unwrap().availability;
    let (here, there) = (Vector3::zeros(), Vector3::new(2.5, 0.0, 0.0));
    assert!(!availability.allows(0, &here, &there));
    assert!(availability.allows(1, &here, &there));
    assert!(availability.allows(0, &here, &(0.8 * there)), "as far as that is not too far");
}

/// The room with a cupboard, a wall and one anchor that reaches 4 m.
fn obstructed() -> Scenario {
    let mut scenario = preset("room").unwrap();
    let reach = scenario.anchors.iter().enumerate().map(|(m, _)| (m == 1).then_some(4.0)).collect();
    scenario.availability.max_ranges = reach;
    let [x, y] = [scenario.start.position[0], scenario.start.position[1]];
    scenario.availability.obstacles = vec![
        wall([x + 0.8, y - 1.0], [x + 1.2, y + 1.5], None, Some(2.0)),
        block([x - 2.0, y - 2.0, 0.0], [x - 1.5, y + 1.0, 1.8]),
    ];
    scenario
}

#[test]
fn the_field_has_the_shadows_of_the_bound() {
    let scenario = obstructed();
    for settings in all_settings() {
        compare::<3>(&scenario, &settings);
    }
    // And they are not nothing.
    let settings = FieldSettings::default();
    let open = preset("room").unwrap();
    let value = |scenario: &Scenario| {
        let setup = scenario.setup::<3>().unwrap();
        let pose: Pose<3> = setup.start;
        super::bound_at(&setup.model, &setup.availability, &pose, &settings)
    };
    assert!(value(&scenario).is_none_or(|hindered| hindered > 1.02 * value(&open).unwrap()));
}

#[test]
fn a_simulation_misses_exactly_what_cannot_be_measured() {
    let (open, hindered) = (preset("room").unwrap(), obstructed());
    let setup = hindered.setup::<3>().unwrap();
    let (all, some) = (simulate::<3>(&open, 0).unwrap(), simulate::<3>(&hindered, 0).unwrap());
    let mut missing = 0;
    for (k, epoch) in some.epochs.iter().enumerate() {
        let pose = some.truth[k].unwrap();
        let measurable = setup.model.measurable(&pose, &setup.availability);
        for m in 0..epoch.ranges.anchors() {
            for n in 0..epoch.ranges.sensors() {
                let expected =
                    all.epochs[k].ranges.get(m, n).filter(|_| measurable[m * epoch.ranges.sensors() + n]);
                assert_eq!(epoch.ranges.get(m, n), expected, "the others are as they were");
                missing += usize::from(expected.is_none());
            }
        }
    }
    assert!(missing > 0);
}
