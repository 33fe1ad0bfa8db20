//! The field: colours on a logarithmic scale, cells where they belong, hatching, and what lies over it.

use std::f32::consts::PI;

use glam::{Mat4, Vec3};
use rangelab_scene::field::FieldData;
use rangelab_scene::{SceneData, SceneError};

use super::support::{
    BLUE, BLUE_RGB, GREEN_RGB, GREY_RGB, HEIGHT_PX, Picture, RED_RGB, WHITE_RGB, WIDTH_PX, field,
    perspective_matrix, plan_matrix, point, rectangle, segment, view,
};
use super::{assert_seen_only_by_the_right_matrix, draw, empty, renderer};

fn scene(field: FieldData) -> SceneData {
    SceneData { field, ..empty() }
}

/// One number everywhere.
fn even(value: f32, worse_than: f32) -> SceneData {
    scene(field(&[value], [1, 1], worse_than))
}

#[test]
fn colours_are_interpolated_on_a_logarithmic_scale() {
    let half = 128;
    let cases = [
        (0.01, RED_RGB),
        (0.1, GREEN_RGB),
        (1.0, BLUE_RGB),
        (0.031_622_78, [half, half, 0]),
        (0.316_227_8, [0, half, half]),
        (0.001, RED_RGB),
        (50.0, BLUE_RGB),
        (f32::from_bits(1), RED_RGB),
    ];
    for (value, rgb) in cases {
        assert_seen_only_by_the_right_matrix(&even(value, 0.0), |picture| {
            for place in [(0.0, 0.0), (-5.9, -2.9), (5.9, -2.9), (-5.9, 4.9), (5.8, 4.8)] {
                picture.expect(&format!("the colour of {value}"), place, rgb)?;
            }
            [(-6.15, 0.0), (6.15, 0.0), (0.0, -3.15), (0.0, 5.15)]
                .into_iter()
                .try_for_each(|place| picture.expect("outside", place, WHITE_RGB))
        });
    }
    let linear = draw(plan_matrix(), &even(0.5, 0.0)).expect("linear", (0.0, 0.0), GREEN_RGB);
    assert!(linear.is_err(), "half way from 0.01 to 1 has the colour of the middle");
}

#[test]
fn cells_run_along_the_first_edge_and_rows_along_the_second() {
    let cells = field(&[0.01, 0.1, 1.0, 1.0, 0.01, 0.1], [3, 2], 0.0);
    let rows = [[RED_RGB, GREEN_RGB, BLUE_RGB], [BLUE_RGB, RED_RGB, GREEN_RGB]];
    let cell = |i: usize, j: usize| (-3.95 + 4.0 * i as f32, -0.95 + 4.0 * j as f32);
    assert_seen_only_by_the_right_matrix(&scene(cells.clone()), |picture| {
        let mut all = (0..2).flat_map(|j| (0..3).map(move |i| (i, j)));
        all.try_for_each(|(i, j)| near(picture, cell(i, j), rows[j][i]))
    });
    // Turned by a quarter: the first edge goes up, the second to the left.
    let turned = FieldData { rectangle: vec![4.0, -6.0, 0.0, 0.0, 12.0, 0.0, -8.0, 0.0, 0.0], ..cells };
    assert_seen_only_by_the_right_matrix(&scene(turned), |picture| {
        let mut all = (0..2).flat_map(|j| (0..3).map(move |i| (i, j)));
        all.try_for_each(|(i, j)| near(picture, (2.05 - 4.0 * j as f32, cell(i, 0).0), rows[j][i]))
    });
}

/// Errs unless the colour is the expected one within 20 of 255: pixels lie a little beside the centres of cells.
fn near(picture: &Picture, (x, y): (f32, f32), rgb: [u8; 3]) -> Result<(), String> {
    let seen = picture.plan(x, y);
    let alike = seen.iter().zip(rgb).all(|(&a, b)| a.abs_diff(b) <= 20);
    if alike { Ok(()) } else { Err(format!("({x}, {y}): {seen:?}, not {rgb:?}")) }
}

#[test]
fn logarithms_are_interpolated_between_the_centres_of_cells() {
    let data = scene(field(&[0.01, 1.0], [2, 1], 0.0));
    let half = 128;
    assert_seen_only_by_the_right_matrix(&data, |picture| {
        near(picture, (-5.9, 0.0), RED_RGB)?;
        near(picture, (-3.05, 0.0), RED_RGB)?;
        near(picture, (-1.5, 4.9), [half, half, 0])?;
        near(picture, (0.0, -2.9), GREEN_RGB)?;
        near(picture, (1.5, 0.0), [0, half, half])?;
        near(picture, (3.05, 0.0), BLUE_RGB)?;
        near(picture, (5.9, 0.0), BLUE_RGB)
    });
}

/// How much of the rectangle's middle is black, where the rest has another colour without blue or with half of each.
fn hatched(picture: &Picture, channel: usize, full: u8) -> f32 {
    let mut black = 0.0;
    for (column, row) in (60..140).flat_map(|column| (40..100).map(move |row| (column, row))) {
        black += 1.0 - f32::from(picture.pixel(column, row)[channel]) / f32::from(full);
    }
    black / (80.0 * 60.0)
}

#[test]
fn only_numbers_above_the_limit_are_hatched() {
    let share = |worse_than| hatched(&draw(plan_matrix(), &even(0.1, worse_than)), 1, 255);
    assert!((share(0.09) - 0.15).abs() < 0.01, "lines of 1.5 of 10 pixels cover {}", share(0.09));
    assert_eq!((share(0.11), share(0.0)), (0.0, 0.0));
    let both = draw(plan_matrix(), &scene(field(&[0.01, 1.0], [2, 1], 0.1)));
    let count_black = |columns: std::ops::Range<u32>| {
        let pixels = columns.flat_map(|column| (35..105).map(move |row| (column, row)));
        pixels.filter(|&(column, row)| both.pixel(column, row).iter().all(|&c| c < 90)).count()
    };
    assert_eq!(count_black(41..100), 0, "left of the limit");
    assert!(count_black(101..159) > 200, "{} black pixels right of the limit", count_black(101..159));
}

#[test]
fn hatching_is_diagonal_of_constant_size_and_moves_with_the_field() {
    let data = even(0.1, 0.05);
    let plain = draw(plan_matrix(), &data);
    let pixels = || (60..140).flat_map(|column| (40..100).map(move |row| (column, row)));
    assert!(pixels().all(|(c, r)| plain.pixel(c, r) == plain.pixel(c - 7, r + 7)), "not along one diagonal");
    assert!(pixels().any(|(c, r)| plain.pixel(c, r) != plain.pixel(c + 7, r + 7)), "along the other one too");
    let moved = draw(Mat4::from_translation(Vec3::new(0.06, 0.1, 0.0)) * plan_matrix(), &data);
    assert!(pixels().all(|(c, r)| plain.pixel(c, r) == moved.pixel(c + 6, r - 8)), "it swims");
    assert!(pixels().any(|(c, r)| plain.pixel(c, r) != moved.pixel(c, r)), "it did not move at all");
    let closer = hatched(&draw(Mat4::from_scale(Vec3::new(3.0, 3.0, 1.0)) * plan_matrix(), &data), 1, 255);
    let aslant = hatched(&draw(perspective_matrix(Vec3::new(0.0, -3.0, 5.0)), &data), 1, 255);
    assert!((closer - 0.15).abs() < 0.01 && (aslant - 0.15).abs() < 0.01, "{closer} close, {aslant} aslant");
}

#[test]
fn where_no_bound_exists_another_colour_is_cross_hatched() {
    for endless in [1e30, f32::MAX, f32::INFINITY] {
        let picture = draw(plan_matrix(), &even(endless, 0.0));
        let share = hatched(&picture, 0, GREY_RGB[0]);
        assert!((share - 0.2775).abs() < 0.02, "{share} of {endless} is hatched");
        let grey = (60..140).filter(|&column| picture.pixel(column, 80) == GREY_RGB).count();
        assert!(grey > 20, "{grey} pixels of 80 have the colour of no bound");
    }
    let below = draw(plan_matrix(), &even(9e29, 0.0));
    assert_eq!(below.expect("a huge bound", (0.0, 0.0), BLUE_RGB), Ok(()));
}

#[test]
fn next_to_a_place_without_a_bound_nothing_is_interpolated() {
    let picture = draw(plan_matrix(), &scene(field(&[0.01, 1e30], [2, 1], 0.0)));
    for x in [-5.5, -2.0, -0.15] {
        assert_eq!(picture.expect("with a bound", (x, 0.0), RED_RGB), Ok(()));
    }
    let coloured = |&column: &u32| {
        let [red, green, blue] = picture.pixel(column, 80);
        red != green || green != blue
    };
    assert_eq!((101..159).filter(coloured).count(), 0, "colours where no bound exists");
}

#[test]
fn the_field_is_translucent_unshaded_and_seen_from_both_sides() {
    let mut data = even(0.01, 0.0);
    data.field.style[3] = 0.25;
    let tint = [255, 191, 191];
    assert_eq!(draw(plan_matrix(), &data).expect("above", (0.0, 0.0), tint), Ok(()));
    let below = draw(plan_matrix() * Mat4::from_rotation_x(PI), &data);
    assert_eq!(below.expect("below", (0.0, 0.0), tint), Ok(()));
}

#[test]
fn everything_else_lies_over_the_field_whether_nearer_or_farther() {
    for z in [-3.0, 3.0] {
        let data = SceneData {
            triangles: rectangle([-5.0, -2.0], [-3.0, 3.0], z, [0.0; 3], BLUE),
            segments: segment([0.0, -5.0, z], [0.0, 5.0, z], 6.0, BLUE),
            points: point([4.0, 0.0, z], 12.0, BLUE, 0.0),
            ..even(0.01, 0.0)
        };
        assert_seen_only_by_the_right_matrix(&data, |picture| {
            for (what, place) in [("triangle", (-3.5, 0.0)), ("segment", (0.0, 0.0)), ("point", (4.05, 0.05))]
            {
                picture.expect(what, place, BLUE_RGB)?;
            }
            picture.expect("bare field", (2.0, 4.5), RED_RGB)
        });
    }
}

#[test]
fn fields_are_replaced_resized_and_removed() {
    let other = scene(field(&[0.1; 6], [3, 2], 0.0));
    let removed = FieldData { width: 0, ..other.field.clone() };
    let (mut renderer, view) = (renderer(), view(plan_matrix()));
    let mut middle = |data: &SceneData| {
        let rgba = renderer.render(&view, data).expect("sound data are drawn");
        Picture { rgba }.plan(0.0, 0.0)
    };
    assert_eq!(middle(&even(0.01, 0.0)), RED_RGB);
    assert_eq!(middle(&even(1.0, 0.0)), BLUE_RGB);
    assert_eq!(middle(&other), GREEN_RGB);
    assert_eq!(middle(&scene(removed)), WHITE_RGB);
    assert_eq!(middle(&even(0.01, 0.0)), RED_RGB);
    assert_eq!(middle(&empty()), WHITE_RGB);
}

#[test]
fn a_field_that_is_refused_leaves_the_old_one() {
    let (mut renderer, view) = (renderer(), view(plan_matrix()));
    renderer.render(&view, &even(0.01, 0.0)).expect("sound data are drawn");
    let nan = field(&[0.1, f32::NAN], [2, 1], 0.0);
    assert!(matches!(renderer.set_field(&nan), Err(SceneError::Value { record: 1, .. })));
    let wide = field(&vec![0.1; 1_000_000], [1_000_000, 1], 0.0);
    assert!(matches!(renderer.set_field(&wide), Err(SceneError::Grid { width: 1_000_000, height: 1, .. })));
    let bad = scene(field(&[0.1], [1, 2], 0.0));
    let refused = SceneError::Count { layout: "field values", length: 1, expected: 2 };
    assert_eq!(renderer.render(&view, &bad), Err(refused));
    let rgba = renderer.render(&view, &even(0.01, 0.0)).expect("the renderer survives bad data");
    assert_eq!(Picture { rgba }.pixel(WIDTH_PX / 2, HEIGHT_PX / 2), RED_RGB);
}

#[test]
fn a_viewer_close_to_the_field_or_in_its_plane_does_no_harm() {
    for eye in [Vec3::new(0.0, -3.0, 0.02), Vec3::new(0.0, -3.0, 0.0), Vec3::new(0.01, 0.0, 0.15)] {
        let picture = draw(perspective_matrix(eye), &even(0.1, 0.05));
        let strange = picture.rgba.chunks(4).find(|p| p[0] != p[2] || p[1] < p[0]);
        assert_eq!(strange, None, "seen from {eye}");
    }
}
