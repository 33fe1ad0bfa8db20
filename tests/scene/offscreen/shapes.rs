//! Points, ellipsoids and triangles: where they are seen and where not, how they hide and shine through.

use glam::Vec3;
use rangelab_scene::SceneData;

use super::support::{
    BLUE, BLUE_RGB, HEIGHT_PX, Picture, RED, RED_RGB, WHITE_RGB, WIDTH_PX, ellipsoid, perspective_matrix,
    plan_matrix, point, rectangle, segment,
};
use super::{assert_seen_only_by_the_right_matrix, draw, empty};

/// Whether a marker of 30 pixels radius at (1, 2) shows its fill at these fractions of the radius from its centre.
fn assert_marker(shape: f32, filled: &[(f32, f32)], bare: &[(f32, f32)]) {
    let data = SceneData { points: point([1.0, 2.0, 0.0], 30.0, RED, shape), ..empty() };
    let at = |(x, y): (f32, f32)| (1.05 + 3.0 * x, 2.05 + 3.0 * y);
    assert_seen_only_by_the_right_matrix(&data, |picture| {
        for &place in filled {
            picture.expect("filled", at(place), RED_RGB)?;
        }
        for &place in bare {
            picture.expect("bare", at(place), WHITE_RGB)?;
        }
        Ok(())
    });
}

#[test]
fn markers_have_their_shapes() {
    let beyond = [(1.55, 0.0), (0.0, 1.55), (-1.55, 0.0), (1.1, -1.1)];
    let and = |bare: &[(f32, f32)]| [&beyond[..], bare].concat();
    let (disc, ring, square, triangle, diamond, cross) = (0.0, 1.0, 2.0, 3.0, 4.0, 5.0);
    assert_marker(disc, &[(0.0, 0.0), (0.9, 0.0), (0.0, -0.9), (0.6, 0.6)], &and(&[(0.9, 0.9)]));
    assert_marker(ring, &[(0.82, 0.0), (0.0, 0.82), (-0.58, 0.58)], &and(&[(0.0, 0.0), (0.3, 0.0)]));
    assert_marker(square, &[(0.0, 0.0), (0.75, 0.75), (-0.75, 0.75), (0.75, -0.75)], &beyond);
    assert_marker(
        triangle,
        &[(0.0, 0.0), (0.0, 1.0), (0.8, -0.5), (-0.8, -0.5)],
        &and(&[(0.8, 0.6), (0.0, -0.9)]),
    );
    assert_marker(
        diamond,
        &[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.0, -1.0)],
        &and(&[(0.8, 0.8), (-0.8, -0.8)]),
    );
    assert_marker(cross, &[(0.0, 0.0), (0.65, 0.65), (-0.65, 0.65)], &and(&[(0.0, 0.85), (0.85, 0.0)]));
}

#[test]
fn markers_have_an_outline_that_contrasts_with_the_fill() {
    let outline = |rgba: [f32; 4]| {
        let data = SceneData {
            points: point([0.0, 0.0, 0.0], 20.0, rgba, 0.0),
            background: [rgba[0], rgba[1], rgba[2]],
            ..empty()
        };
        draw(plan_matrix(), &data).plan(2.15, 0.05)
    };
    assert!(outline([1.0, 1.0, 0.6, 1.0])[0] < 40, "light fill, dark outline");
    assert!(outline([0.1, 0.1, 0.3, 1.0])[0] > 215, "dark fill, light outline");
}

/// How many pixels of a picture are red enough.
fn red_pixels(picture: &Picture) -> usize {
    picture.rgba.chunks(4).filter(|pixel| pixel[0] > 200 && pixel[1] < 60).count()
}

#[test]
fn the_size_of_markers_does_not_depend_on_the_distance() {
    let count = |y: f32| {
        let data = SceneData { points: point([0.0, y, 0.0], 10.0, RED, 0.0), ..empty() };
        red_pixels(&draw(perspective_matrix(Vec3::new(0.0, -6.0, 3.0)), &data))
    };
    let expected = 314;
    for y in [-2.0, 0.0, 10.0] {
        assert!(count(y).abs_diff(expected) < 30, "{} pixels at y = {y}", count(y));
    }
    assert_eq!(count(-7.0), 0, "a marker behind the viewer is seen");
}

#[test]
fn solids_hide_markers_behind_but_not_those_on_them() {
    let solid = rectangle([-9.0, 9.0], [-9.0, 9.0], 0.0, [0.0; 3], BLUE);
    let data = |z: f32| SceneData {
        points: point([0.0, 0.0, z], 12.0, RED, 0.0),
        triangles: solid.clone(),
        ..empty()
    };
    // Seen from 30 degrees above, most of the lower half of a marker on the surface would sink into it.
    let seen = |z: f32| red_pixels(&draw(perspective_matrix(Vec3::new(0.0, -17.0, 10.0)), &data(z)));
    assert_eq!(seen(-4.0), 0);
    assert!(seen(0.0) > 400 && seen(0.0).abs_diff(seen(3.0)) < 8, "{} on, {} above", seen(0.0), seen(3.0));
}

const HALF_RED: [f32; 4] = [1.0, 0.0, 0.0, 0.5];

/// How much of a white ground a red tint takes away, 0..1.
fn tint(picture: &Picture, x: f32, y: f32) -> f32 {
    1.0 - f32::from(picture.plan(x, y)[1]) / 255.0
}

#[test]
fn an_ellipsoid_reaches_as_far_as_its_axes_and_is_densest_at_the_rim() {
    // Semi-axes of 4 m and 2 m, turned by the angle whose tangent is 3/4.
    let axes = [[3.2, 2.4, 0.0], [-1.2, 1.6, 0.0], [0.0, 0.0, 1.0]];
    let data = SceneData { ellipsoids: ellipsoid([1.0, -1.0, 0.0], axes, HALF_RED), ..empty() };
    assert_seen_only_by_the_right_matrix(&data, |picture| {
        let at = |along: f32, aside: f32| (1.0 + 0.8 * along - 0.6 * aside, -1.0 + 0.6 * along + 0.8 * aside);
        for (along, aside) in [(0.0, 0.0), (3.85, 0.0), (-3.85, 0.0), (0.0, 1.85), (0.0, -1.85)] {
            let (x, y) = at(along, aside);
            if tint(picture, x, y) < 0.2 {
                return Err(format!("tint {} at ({x}, {y})", tint(picture, x, y)));
            }
        }
        for (along, aside) in [(4.2, 0.0), (-4.2, 0.0), (0.0, 2.2), (0.0, -2.2), (3.0, 1.7)] {
            picture.expect("beyond", at(along, aside), WHITE_RGB)?;
        }
        let (rim, middle) = (at(0.0, 1.92), at(0.0, 0.0));
        let (rim, middle) = (tint(picture, rim.0, rim.1), tint(picture, middle.0, middle.1));
        if rim > middle + 0.1 { Ok(()) } else { Err(format!("rim {rim}, middle {middle}")) }
    });
}

#[test]
fn a_flat_ellipse_is_seen_and_a_line_or_point_of_no_area_does_no_harm() {
    let axis = |x: f32, y: f32| [x, y, 0.0];
    let flat = ellipsoid([0.0; 3], [axis(3.0, 0.0), axis(0.0, 2.0), [0.0; 3]], HALF_RED);
    let line = ellipsoid([0.0, 5.0, 0.0], [axis(3.0, 0.0), [0.0; 3], [0.0; 3]], HALF_RED);
    let nothing = ellipsoid([0.0, -5.0, 0.0], [[0.0; 3]; 3], HALF_RED);
    let picture = draw(plan_matrix(), &SceneData { ellipsoids: [flat, line, nothing].concat(), ..empty() });
    let inside = tint(&picture, 0.0, 0.0);
    assert!(inside > 0.2 && inside < 0.9, "{inside}");
    assert!((tint(&picture, 2.7, 0.0) - inside).abs() < 0.02, "a flat ellipse is evenly tinted");
    assert_eq!((picture.plan(3.3, 0.0), picture.plan(0.0, -5.0)), (WHITE_RGB, WHITE_RGB));
}

#[test]
fn small_ellipsoids_are_shaded_like_large_ones() {
    let middle = |scale: f32| {
        let axes = [[scale, 0.0, 0.0], [0.0, scale, 0.0], [0.0, 0.0, scale]];
        let data = SceneData { ellipsoids: ellipsoid([0.0; 3], axes, HALF_RED), ..empty() };
        let closer = glam::Mat4::from_scale(Vec3::new(4.0 / scale, 4.0 / scale, 1.0));
        let picture = draw(closer * plan_matrix(), &data);
        [picture.plan(0.05, 0.05), picture.plan(3.0, 0.05)]
    };
    assert_eq!(middle(4.0), middle(0.001));
}

#[test]
fn ellipsoids_shine_through_but_solids_hide_them() {
    let axes = [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
    let ball = ellipsoid([0.0; 3], axes, HALF_RED);
    let line = segment([-6.0, 0.0, -5.0], [6.0, 0.0, -5.0], 6.0, BLUE);
    let data = SceneData { ellipsoids: ball.clone(), segments: line, ..empty() };
    let [_, _, blue] = draw(plan_matrix(), &data).plan(0.0, 0.0);
    assert!(blue > 100, "the line behind is gone");
    let solid = rectangle([0.0, 5.0], [-5.0, 5.0], 5.0, [0.0; 3], BLUE);
    let picture = draw(plan_matrix(), &SceneData { ellipsoids: ball, triangles: solid, ..empty() });
    assert_eq!(picture.plan(1.0, 0.0), BLUE_RGB, "behind a solid");
    assert!(tint(&picture, -1.0, 0.0) > 0.2, "beside the solid");
}

#[test]
fn triangles_cover_their_area_and_near_ones_hide_far_ones() {
    let near = rectangle([-4.0, 1.0], [1.0, 5.0], 1.0, [0.0; 3], RED);
    let far = rectangle([-1.0, 4.0], [2.0, 6.0], 0.0, [0.0; 3], BLUE);
    for triangles in [[near.clone(), far.clone()].concat(), [far, near].concat()] {
        assert_seen_only_by_the_right_matrix(&SceneData { triangles, ..empty() }, |picture| {
            picture.expect("only the near one", (-3.9, 1.15), RED_RGB)?;
            picture.expect("both", (0.0, 3.0), RED_RGB)?;
            picture.expect("only the far one", (3.9, 5.9), BLUE_RGB)?;
            picture.expect("left of both", (-4.15, 3.0), WHITE_RGB)?;
            picture.expect("above both", (0.0, 6.15), WHITE_RGB)
        });
    }
}

#[test]
fn unshaded_and_translucent_colours_come_out_as_given() {
    let plain = rectangle([-4.0, 0.0], [-4.0, 4.0], 0.0, [0.0; 3], [0.5, 0.25, 0.75, 1.0]);
    let glass = rectangle([0.0, 4.0], [-4.0, 4.0], 0.0, [0.0; 3], [0.0, 0.0, 1.0, 0.25]);
    let picture = draw(plan_matrix(), &SceneData { triangles: [glass, plain].concat(), ..empty() });
    assert_eq!(picture.expect("plain", (-2.0, 0.0), [128, 64, 191]), Ok(()));
    assert_eq!(picture.expect("glass", (2.0, 0.0), [191, 191, 255]), Ok(()));
}

#[test]
fn shading_is_the_same_from_both_sides_and_depends_on_the_normal() {
    let grey = |normal: [f32; 3]| {
        let triangles = rectangle([-4.0, 4.0], [-4.0, 4.0], 0.0, normal, [0.8, 0.8, 0.8, 1.0]);
        let picture = draw(plan_matrix(), &SceneData { triangles, ..empty() });
        picture.pixel(WIDTH_PX / 2, HEIGHT_PX / 2)[0]
    };
    let (up, down, long) = (grey([0.0, 0.0, 1.0]), grey([0.0, 0.0, -1.0]), grey([0.0, 0.0, 7.0]));
    assert!(up == down && up == long, "{up} {down} {long}");
    let aslant = grey([-0.8, 0.3, 0.5]);
    assert!(up > aslant + 20 && aslant > 80 && up < 204, "up {up}, aslant {aslant}");
}
