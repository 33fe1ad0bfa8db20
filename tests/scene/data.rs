//! What the scene accepts, what it refuses and with which words; the geometry that it computes itself.

#![allow(clippy::float_cmp, reason = "numbers that are passed on unchanged are the very same")]

mod support;

use glam::{Mat4, Vec3};
use rangelab_scene::data::{ELLIPSOIDS, Layout, MAX_RECORDS, POINTS, SEGMENTS, TRIANGLES};
use rangelab_scene::field::FieldData;
use rangelab_scene::{SceneError, View, dash};
use support::{
    RED, dashed, ellipsoid, field, perspective_matrix, plan_matrix, point, rectangle, segment, view,
};

fn good() -> [(&'static Layout, Vec<f32>); 4] {
    let axes = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0; 3]];
    [
        (&SEGMENTS, segment([0.0; 3], [1.0; 3], 2.0, RED)),
        (&POINTS, point([0.0; 3], 5.0, RED, 3.0)),
        (&ELLIPSOIDS, ellipsoid([0.0; 3], axes, RED)),
        (&TRIANGLES, rectangle([0.0, 1.0], [0.0, 1.0], 0.0, [0.0, 0.0, 1.0], RED)),
    ]
}

#[test]
fn strides_are_what_the_page_was_told() {
    assert_eq!([&SEGMENTS, &POINTS, &ELLIPSOIDS, &TRIANGLES].map(Layout::stride), [13, 9, 16, 10]);
    assert_eq!(TRIANGLES.shape_stride(), 30);
}

#[test]
fn good_and_empty_arrays_pass() {
    for (layout, values) in good() {
        assert_eq!(layout.check(&values), Ok(()));
        assert_eq!(layout.check(&[]), Ok(()));
    }
}

#[test]
fn lengths_that_make_no_whole_shape_are_refused() {
    for (layout, values) in good() {
        let length = values.len() - 1;
        let refused = SceneError::Length { layout: layout.name, length, record: layout.shape_stride() };
        assert_eq!(layout.check(&values[..length]), Err(refused));
    }
    let two_vertices = &good()[3].1[..20];
    let message = TRIANGLES.check(two_vertices).expect_err("two vertices make no triangle").to_string();
    assert_eq!(message, "triangles: 20 numbers do not make whole records of 30");
}

#[test]
fn every_number_must_be_finite() {
    for (layout, values) in good() {
        for (index, bad) in
            (0..values.len()).flat_map(|i| [f32::NAN, f32::INFINITY, -f32::INFINITY].map(|b| (i, b)))
        {
            let mut spoiled = values.clone();
            spoiled[index] = bad;
            let Err(SceneError::Value { record, component, .. }) = layout.check(&spoiled) else {
                panic!("{}: {bad} at {index} passed", layout.name);
            };
            assert_eq!(record, index / layout.stride());
            assert_eq!(component, layout.components[index % layout.stride()].name);
        }
    }
}

#[test]
fn numbers_outside_their_interval_are_refused() {
    let cases: [(&Layout, usize, f32); 9] = [
        (&SEGMENTS, 6, -1.0),
        (&SEGMENTS, 7, -0.5),
        (&SEGMENTS, 8, 255.0),
        (&SEGMENTS, 12, 0.5),
        (&POINTS, 3, 1e9),
        (&POINTS, 8, 6.0),
        (&POINTS, 8, 1.5),
        (&ELLIPSOIDS, 15, -0.1),
        (&TRIANGLES, 9, 1.5),
    ];
    for (layout, index, bad) in cases {
        let mut values = good().into_iter().find(|(l, _)| l.name == layout.name).expect("each has one").1;
        values[index] = bad;
        assert!(
            matches!(layout.check(&values), Err(SceneError::Value { value, .. }) if value == bad),
            "{bad}"
        );
    }
    let values = [point([0.0; 3], 5.0, RED, 0.0), point([0.0; 3], 5.0, RED, 6.0)].concat();
    let message = POINTS.check(&values).expect_err("there is no shape 6").to_string();
    assert_eq!(message, "points: record 1 has shape = 6, but it must be a whole number from 0 to 5");
}

#[test]
fn endless_arrays_are_refused_before_they_are_read() {
    assert_eq!(POINTS.check_length(9 * MAX_RECORDS), Ok(()));
    let records = MAX_RECORDS + 1;
    let refused = SceneError::TooMany { layout: "points", records, limit: MAX_RECORDS };
    assert_eq!(POINTS.check_length(9 * records), Err(refused));
}

#[test]
fn splitting_keeps_the_order_within_both_groups() {
    let shapes = [1.0, 0.0, 2.0, 5.0, 0.0].map(|shape| point([shape, 0.0, 0.0], 1.0, RED, shape)).concat();
    let mut sorted = vec![7.0];
    let first = POINTS.split(&shapes, &mut sorted, |record| record[8] == 0.0);
    let order: Vec<f32> = sorted[1..].chunks(9).map(|record| record[0]).collect();
    assert_eq!((first, sorted[0], order), (2, 7.0, vec![0.0, 0.0, 1.0, 2.0, 5.0]));
}

/// A field of 3 x 2 cells with one array spoiled, and the words that refuse it.
fn refusal(spoil: impl Fn(&mut FieldData)) -> String {
    let mut spoiled = field(&[0.1; 6], [3, 2], 0.5);
    assert_eq!(spoiled.check(), Ok(()));
    spoil(&mut spoiled);
    spoiled.check().expect_err("a spoiled field").to_string()
}

#[test]
fn fields_of_the_wrong_lengths_are_refused() {
    let count =
        |what, length, expected| format!("field {what}: {length} numbers came, but there must be {expected}");
    assert_eq!(refusal(|field| field.values.truncate(5)), count("values", 5, 6));
    assert_eq!(refusal(|field| field.height = 3), count("values", 6, 9));
    assert_eq!(refusal(|field| field.rectangle.truncate(8)), count("rectangle", 8, 9));
    assert_eq!(refusal(|field| field.rectangle.extend([0.0; 9])), count("rectangle", 18, 9));
    assert_eq!(refusal(|field| field.style.truncate(10)), count("style", 10, 17));
    assert_eq!(refusal(|field| field.style.truncate(19)), count("style", 19, 20));
    assert_eq!(refusal(|field| field.style[10] = 4.0), count("style", 20, 23));
    assert_eq!(
        refusal(|field| (field.width, field.height) = (u32::MAX, u32::MAX)),
        count("values", 6, (u32::MAX as usize).saturating_mul(u32::MAX as usize))
    );
}

#[test]
fn numbers_that_no_field_can_show_are_refused() {
    for bad in [f32::NAN, -0.1, 0.0, -f32::INFINITY] {
        let words = format!("field values: record 4 has number = {bad}, but it must be a positive number");
        assert_eq!(refusal(|field| field.values[4] = bad), words);
    }
    for (at, name) in [(0, "corner x"), (5, "edge u z"), (6, "edge v x")] {
        let words = format!("field rectangle: record 0 has {name} = NaN, but it must be a finite number");
        assert_eq!(refusal(|field| field.rectangle[at] = f32::NAN), words);
    }
    let style = [
        (0, 0.0, "low = 0, but it must be a number from 0.000000001 to 1000000000"),
        (1, 0.01, "high = 0.01, but it must be a number above low = 0.01"),
        (2, -1.0, "worse_than = -1, but it must be a number from 0 to 1000000000"),
        (3, 1.5, "opacity = 1.5, but it must be a number from 0 to 1"),
        (6, f32::NAN, "hatch blue = NaN, but it must be a number from 0 to 1"),
        (8, 255.0, "no-bound green = 255, but it must be a number from 0 to 1"),
        (10, 17.0, "count of stops = 17, but it must be a whole number from 2 to 16"),
        (10, 1.0, "count of stops = 1, but it must be a whole number from 2 to 16"),
        (10, 2.5, "count of stops = 2.5, but it must be a whole number from 2 to 16"),
    ];
    for (at, bad, words) in style {
        assert_eq!(refusal(|field| field.style[at] = bad), format!("field style: record 0 has {words}"));
    }
    let words = "field stops: record 2 has blue = -0.5, but it must be a number from 0 to 1";
    assert_eq!(refusal(|field| field.style[19] = -0.5), words);
}

#[test]
fn fields_may_be_absent_unbounded_and_of_many_colours() {
    assert_eq!(FieldData::default().check(), Ok(()));
    assert_eq!(FieldData { width: 0, ..field(&[f32::NAN], [1, 1], 0.0) }.check(), Ok(()));
    assert_eq!(field(&[1e30, f32::MAX, f32::INFINITY, f32::from_bits(1)], [2, 2], 0.0).check(), Ok(()));
    let mut colourful = field(&[1.0], [1, 1], 0.0);
    colourful.style[10] = 16.0;
    colourful.style.extend([0.25; 39]);
    assert_eq!(colourful.check(), Ok(()));
    let uniform = colourful.uniform();
    assert_eq!((uniform[19], uniform[24], uniform[84..87].to_vec()), (16.0, 1.0, vec![0.25; 3]));
}

#[test]
fn the_eye_is_where_the_matrix_looks_from() {
    let place = Vec3::new(3.0, -4.0, 2.5);
    let [x, y, z, w] = view(perspective_matrix(place)).eye();
    assert!(w == 1.0 && Vec3::new(x, y, z).distance(place) < 1e-5, "({x}, {y}, {z}, {w})");
    let [x, y, z, w] = view(plan_matrix()).eye();
    assert!(w == 0.0 && Vec3::new(x, y, z).distance(Vec3::Z) < 1e-6, "({x}, {y}, {z}, {w})");
}

#[test]
fn views_that_show_nothing_are_refused() {
    let sound = plan_matrix().to_cols_array();
    let mut spoiled = sound;
    spoiled[5] = f32::NAN;
    let flat = (plan_matrix() * Mat4::from_scale(Vec3::new(1.0, 0.0, 0.0))).to_cols_array();
    let cases: [(&[f32], f32, &str); 6] = [
        (&sound[..15], 10.0, "view: a matrix has 16 numbers, not 15"),
        (&spoiled, 10.0, "view: number 5 of the matrix is NaN"),
        (&sound, 0.0, "view: a picture cannot be 0 x 10 pixels"),
        (&sound, f32::INFINITY, "view: a picture cannot be inf x 10 pixels"),
        (&[0.0; 16], 10.0, "view: the matrix flattens the world, nothing could be seen"),
        (&flat, 10.0, "view: the matrix flattens the world, nothing could be seen"),
    ];
    for (matrix, width_px, message) in cases {
        let error = View::new(matrix, width_px, 10.0).expect_err(message);
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn lengths_are_measured_on_the_screen() {
    let plan = view(plan_matrix());
    let length = plan.length_px([0.0, 0.0, 3.0], [3.0, 4.0, -5.0]);
    assert!((length - 50.0).abs() < 1e-3, "{length}");
    // From z = -20 to the near plane at z = 10 and beyond it: only what is in front counts.
    let length = plan.length_px([4.0, 0.0, 20.0], [0.0, 0.0, 0.0]);
    assert!((length - 20.0).abs() < 1e-3, "{length}");
    assert!(plan.length_px([4.0, 0.0, 20.0], [0.0, 0.0, 11.0]).abs() < 1e-6);
}

#[test]
fn dashes_run_on_only_where_a_track_does() {
    let at = |x: f32| [x, 0.0, 0.0];
    let segments = [
        dashed(at(0.0), at(1.0), 2.0, 8.0),
        dashed(at(1.0), at(1.5), 2.0, 8.0),
        dashed(at(1.5), at(2.0), 4.0, 8.0),
        dashed(at(2.0), at(3.0), 4.0, 3.0),
        dashed(at(3.0), at(4.0), 4.0, 0.0),
        dashed(at(4.0), at(5.0), 4.0, 8.0),
        dashed(at(5.5), at(6.0), 4.0, 8.0),
    ]
    .concat();
    let mut phases = vec![9.0];
    dash::phases(&segments, &view(plan_matrix()), &mut phases);
    // 10 pixels, then 5 more, modulo 16; new dash lengths, solid lines and gaps start anew.
    let expected = [0.0, 10.0, 15.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(phases.len(), expected.len());
    assert!(phases.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{phases:?}");
    assert!(dash::any_dashed(&segments) && !dash::any_dashed(&segments[4 * 13..5 * 13]));
}
