//! Where the grid lies.

use rangelab::bounds::field::FieldLayout;
use rangelab::math::float::{cos, sin};
use rangelab::model::field_settings::FieldPlane;
use rangelab::model::presets::{PRESETS, preset};
use rangelab::with_dimension;

fn layout<const D: usize>(
    scenario: &rangelab::model::scenario::Scenario,
    plane: FieldPlane,
    resolution: usize,
) -> FieldLayout {
    let setup = scenario.setup::<D>().unwrap();
    FieldLayout::new(setup.model.anchors(), &setup.start, &plane, resolution).unwrap()
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn the_grid_covers_anchors_and_body_with_cells_as_wide_as_high() {
    for each in PRESETS {
        let scenario = each.scenario();
        let found =
            with_dimension!(scenario.dimension, D => Ok(layout::<D>(&scenario, FieldPlane::Level, 128)))
                .unwrap();
        assert_eq!(found.width.max(found.height), 128, "{}", each.name);
        let cell = length(found.u) / found.width as f64 * found.height as f64 / length(found.v);
        assert!((cell - 1.0).abs() < 0.02, "{}: cells of {cell}", each.name);
        for point in scenario.anchors.iter().chain([&scenario.start.position]) {
            for axis in 0..2 {
                let (low, high) = (found.corner[axis], found.corner[axis] + found.u[axis] + found.v[axis]);
                assert!(low < point[axis] && point[axis] < high, "{}: {point:?}", each.name);
            }
        }
    }
}

#[test]
fn planes_lie_where_they_are_told() {
    let scenario = preset("room").unwrap();
    let level = layout::<3>(&scenario, FieldPlane::Level, 10);
    assert_eq!(level.corner[2], scenario.start.position[2]);
    let raised = layout::<3>(&scenario, FieldPlane::Horizontal { height: 1.25 }, 10);
    assert_eq!((raised.corner[2], raised.u[2], raised.v[2]), (1.25, 0.0, 0.0));
    let heading = 0.5;
    let upright = layout::<3>(&scenario, FieldPlane::Vertical { heading, offset: 2.0 }, 10);
    let across = -upright.corner[0] * sin(heading) + upright.corner[1] * cos(heading);
    assert!((across - 2.0).abs() < 1e-12, "{across} m off the origin");
    assert!((upright.u[1] * cos(heading) - upright.u[0] * sin(heading)).abs() < 1e-12);
    assert_eq!((upright.v[0], upright.v[1]), (0.0, 0.0));
    let own = layout::<3>(&scenario, FieldPlane::Body, 10);
    let setup = scenario.setup::<3>().unwrap();
    let normal = setup.start.rotation.matrix().column(2).into_owned();
    let off = (0..3).map(|i| (own.corner[i] - setup.start.position[i]) * normal[i]).sum::<f64>();
    assert!(off.abs() < 1e-9, "{off} m off the body");
}

#[test]
fn a_small_move_leaves_the_grid_where_it_is() {
    let mut scenario = preset("room").unwrap();
    let before = layout::<3>(&scenario, FieldPlane::Level, 64);
    scenario.anchors[0][0] += 0.01;
    assert_eq!(layout::<3>(&scenario, FieldPlane::Level, 64), before);
    scenario.anchors[0][0] += 100.0;
    assert_ne!(layout::<3>(&scenario, FieldPlane::Level, 64), before);
}

#[test]
fn impossible_resolutions_are_refused() {
    let scenario = preset("room").unwrap();
    let setup = scenario.setup::<3>().unwrap();
    for resolution in [0, 1025] {
        let refused = FieldLayout::new(setup.model.anchors(), &setup.start, &FieldPlane::Level, resolution);
        assert!(refused.unwrap_err().to_string().contains(&resolution.to_string()));
    }
}
