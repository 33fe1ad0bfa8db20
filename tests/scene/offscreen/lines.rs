//! Segments: where they are, how wide, how they join, dash, hide and come on top.

use glam::{Mat4, Vec3};
use rangelab_scene::SceneData;

use super::support::{
    BLUE, BLUE_RGB, HEIGHT_PX, Picture, RED, RED_RGB, WHITE_RGB, WIDTH_PX, dashed, perspective_matrix,
    plan_matrix, rectangle, segment,
};
use super::{assert_seen_only_by_the_right_matrix, draw, empty};

#[test]
fn a_line_has_its_width_and_round_ends() {
    let data = SceneData { segments: segment([-5.0, 2.0, 0.0], [5.0, 2.0, 0.0], 8.0, RED), ..empty() };
    assert_seen_only_by_the_right_matrix(&data, |picture| {
        picture.expect("its middle", (0.05, 2.0), RED_RGB)?;
        picture.expect("inside its edge", (0.05, 2.25), RED_RGB)?;
        picture.expect("inside its other edge", (0.05, 1.75), RED_RGB)?;
        picture.expect("above it", (0.05, 2.55), WHITE_RGB)?;
        picture.expect("below it", (0.05, 1.45), WHITE_RGB)?;
        picture.expect("in its cap", (5.25, 2.05), RED_RGB)?;
        picture.expect("beyond its cap", (5.55, 2.05), WHITE_RGB)?;
        picture.expect("beside its round cap", (5.35, 2.35), WHITE_RGB)
    });
}

#[test]
fn edges_of_slanted_lines_are_smooth() {
    let data = SceneData { segments: segment([-5.0, -3.0, 0.0], [5.0, 3.1, 0.0], 5.0, RED), ..empty() };
    let picture = draw(plan_matrix(), &data);
    let greens = picture.rgba.chunks(4).map(|pixel| pixel[1]);
    let mut shades: Vec<u8> = greens.filter(|&green| green != 0 && green != 255).collect();
    shades.sort_unstable();
    shades.dedup();
    assert!(shades.len() > 8, "only {} shades between line and background: {shades:?}", shades.len());
}

#[test]
fn hairlines_fade_instead_of_vanishing() {
    let data = SceneData { segments: segment([-5.0, 0.05, 0.0], [5.0, 0.05, 0.0], 0.5, RED), ..empty() };
    let [red, green, _] = draw(plan_matrix(), &data).plan(0.0, 0.05);
    assert!(red == 255 && (100..156).contains(&green), "green is {green}");
}

#[test]
fn the_width_does_not_depend_on_the_distance() {
    let wide = |y: f32| {
        let data = SceneData { segments: segment([-9.0, y, 0.0], [9.0, y, 0.0], 7.0, RED), ..empty() };
        let picture = draw(perspective_matrix(Vec3::new(0.0, -6.0, 5.0)), &data);
        // White is 255 green and red is 0: the missing green of a column adds up to the width.
        (0..HEIGHT_PX).map(|row| 1.0 - f32::from(picture.pixel(WIDTH_PX / 2, row)[1]) / 255.0).sum::<f32>()
    };
    for y in [-2.0, 0.0, 5.0] {
        assert!((wide(y) - 7.0).abs() < 0.3, "{} pixels wide at y = {y}", wide(y));
    }
}

/// A corner of two translucent lines, continued or (moved by a micrometre) not.
fn corner(gap: f32) -> Picture {
    let half = [1.0, 0.0, 0.0, 0.5];
    let first = segment([-4.0, -2.0, 0.0], [0.0, 2.0, 0.0], 20.0, half);
    let second = segment([gap, 2.0, 0.0], [4.0, -2.0, 0.0], 20.0, half);
    draw(plan_matrix(), &SceneData { segments: [first, second].concat(), ..empty() })
}

#[test]
fn joints_of_translucent_lines_are_painted_once() {
    let once = [255, 127, 127];
    for (x, y) in [(-2.0, 0.0), (0.05, 2.0), (0.05, 1.2), (-0.35, 1.85), (0.35, 1.85), (0.05, 2.7)] {
        assert_eq!(corner(0.0).expect("joint", (x, y), once), Ok(()));
    }
    assert!(corner(1e-6).expect("two lines", (0.05, 2.0), once).is_err(), "the check sees no overlap");
    assert_eq!(corner(0.0).expect("outside the round joint", (0.05, 3.15), WHITE_RGB), Ok(()));
}

#[test]
fn a_track_of_short_segments_is_one_even_line() {
    let half = [1.0, 0.0, 0.0, 0.5];
    let at = |i: u16| {
        let x = f32::from(i) / 50.0 - 6.0;
        [x, x * x / 12.0 - 2.0, 0.0]
    };
    let segments = (0..600).flat_map(|i| segment(at(i), at(i + 1), 6.0, half)).collect();
    let picture = draw(plan_matrix(), &SceneData { segments, ..empty() });
    for i in 1..599 {
        let [x, y, _] = at(i);
        assert_eq!(picture.expect("track", (x, y), [255, 127, 127]), Ok(()), "step {i}");
    }
}

#[test]
fn dashes_run_on_along_a_track_and_do_not_change_with_width() {
    for width_px in [2.0, 9.0] {
        let at = |i: u16| [f32::from(i) * 0.3 - 6.0, 2.05, 0.0];
        let segments: Vec<f32> = (0..40).flat_map(|i| dashed(at(i), at(i + 1), width_px, 8.0)).collect();
        assert_seen_only_by_the_right_matrix(&SceneData { segments, ..empty() }, |picture| {
            for period in 0..7_u8 {
                let start = -6.0 + 1.6 * f32::from(period);
                picture.expect("early in a dash", (start + 0.15, 2.05), RED_RGB)?;
                picture.expect("late in a dash", (start + 0.65, 2.05), RED_RGB)?;
                picture.expect("early in a gap", (start + 0.95, 2.05), WHITE_RGB)?;
                picture.expect("late in a gap", (start + 1.45, 2.05), WHITE_RGB)?;
            }
            Ok(())
        });
    }
}

#[test]
fn solids_hide_lines_except_those_of_the_overlay() {
    let solid = rectangle([-2.0, 2.0], [-2.0, 2.0], 1.0, [0.0; 3], BLUE);
    let seen = |z: f32, overlay: f32| {
        let mut segments = segment([-5.0, 0.0, z], [5.0, 0.0, z], 6.0, RED);
        segments[12] = overlay;
        let picture = draw(plan_matrix(), &SceneData { segments, triangles: solid.clone(), ..empty() });
        assert_eq!(picture.plan(4.0, 0.0), RED_RGB);
        picture.plan(0.0, 0.0)
    };
    assert_eq!(seen(0.0, 0.0), BLUE_RGB, "a line behind");
    assert_eq!(seen(2.0, 0.0), RED_RGB, "a line in front");
    assert_eq!(seen(1.0, 0.0), RED_RGB, "a line on the surface");
    assert_eq!(seen(0.0, 1.0), RED_RGB, "a line of the overlay");
}

#[test]
fn the_overlay_comes_last_whatever_the_order() {
    let mut top = segment([-5.0, 0.0, 0.0], [5.0, 0.0, 0.0], 6.0, RED);
    top[12] = 1.0;
    let below = segment([0.0, -5.0, 5.0], [0.0, 5.0, 5.0], 6.0, BLUE);
    let picture = draw(plan_matrix(), &SceneData { segments: [top, below].concat(), ..empty() });
    assert_eq!((picture.plan(0.0, 0.0), picture.plan(0.0, 3.0)), (RED_RGB, BLUE_RGB));
}

#[test]
fn lines_through_the_viewer_are_cut_at_the_near_plane() {
    // Along y, from far ahead to far behind the viewer and half a metre below.
    let matrix = perspective_matrix(Vec3::new(0.0, -5.0, 0.0));
    let line = |from: f32, to: f32| segment([0.0, from, -0.5], [0.0, to, -0.5], 6.0, RED);
    for segments in [line(20.0, -40.0), line(-40.0, 20.0)] {
        let picture = draw(matrix, &SceneData { segments, ..empty() });
        assert_eq!(picture.pixel(WIDTH_PX / 2, HEIGHT_PX - 5), RED_RGB, "below the middle");
        for row in 0..HEIGHT_PX / 2 - 10 {
            assert_eq!(picture.pixel(WIDTH_PX / 2, row), WHITE_RGB, "row {row}, above the horizon");
        }
        assert_eq!(picture.pixel(WIDTH_PX / 4, HEIGHT_PX - 5), WHITE_RGB, "aside");
    }
    let behind = SceneData { segments: line(-6.0, -40.0), ..empty() };
    assert!(draw(matrix, &behind).rgba.iter().all(|&value| value == 255), "a line behind the viewer is seen");
    let turned = draw(matrix * Mat4::from_rotation_z(3.1), &behind);
    assert!(turned.rgba.iter().any(|&value| value != 255), "the line is never seen");
}
