//! Pictures drawn offscreen on whatever Vulkan device there is (Mesa's lavapipe will do), read pixel by pixel.

mod field;
mod fine_field;
mod lines;
mod shapes;
#[path = "../support.rs"]
mod support;

use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use glam::{Mat4, Vec3};
use rangelab_scene::{Offscreen, SceneData, SceneError};
use support::{HEIGHT_PX, Picture, RED, WIDTH_PX, plan_matrix, point, view};

/// One for all tests: opening a device takes longer than drawing.
fn renderer() -> MutexGuard<'static, Offscreen> {
    static RENDERER: LazyLock<Mutex<Offscreen>> = LazyLock::new(|| {
        let renderer = Offscreen::new(WIDTH_PX, HEIGHT_PX);
        Mutex::new(renderer.expect("a Vulkan device; Debian has one in mesa-vulkan-drivers"))
    });
    let mut renderer = RENDERER.lock().unwrap_or_else(PoisonError::into_inner);
    renderer.drop_fine_field();
    renderer
}

/// Nothing yet, on white.
fn empty() -> SceneData {
    SceneData { background: [1.0; 3], ..SceneData::default() }
}

fn draw(clip_from_world: Mat4, data: &SceneData) -> Picture {
    Picture { rgba: renderer().render(&view(clip_from_world), data).expect("sound data are drawn") }
}

/// A check of a plan must pass with the right matrix and fail with each of several wrong ones.
fn assert_seen_only_by_the_right_matrix(data: &SceneData, check: impl Fn(&Picture) -> Result<(), String>) {
    assert_eq!(check(&draw(plan_matrix(), data)), Ok(()));
    let wrong = [
        ("shifted", plan_matrix() * Mat4::from_translation(Vec3::new(1.5, 0.0, 0.0))),
        ("mirrored", Mat4::from_scale(Vec3::new(1.0, -1.0, 1.0)) * plan_matrix()),
        ("halved", Mat4::from_scale(Vec3::new(0.5, 0.5, 1.0)) * plan_matrix()),
        ("turned away", plan_matrix() * Mat4::from_translation(Vec3::new(0.0, 0.0, 30.0))),
    ];
    for (name, matrix) in wrong {
        assert!(check(&draw(matrix, data)).is_err(), "the {name} picture passes too");
    }
}

#[test]
fn an_empty_scene_is_background_and_opaque() {
    let data = SceneData { background: [0.2, 0.4, 0.6], ..SceneData::default() };
    let rgba = renderer().render(&view(plan_matrix()), &data).expect("nothing can be drawn");
    assert_eq!(rgba.len(), 4 * (WIDTH_PX * HEIGHT_PX) as usize);
    assert!(rgba.chunks(4).all(|pixel| pixel == [51, 102, 153, 255]), "{:?}", &rgba[..4]);
}

#[test]
fn impossible_sizes_and_bad_data_are_errors() {
    for (width_px, height_px) in [(0, 10), (10, 0), (1_000_000, 10)] {
        let error = Offscreen::new(width_px, height_px).err();
        assert!(matches!(error, Some(SceneError::Size { .. } | SceneError::Device(_))), "{error:?}");
    }
    let mut renderer = renderer();
    let bad = SceneData { points: point([f32::NAN; 3], 5.0, RED, 0.0), ..empty() };
    assert!(matches!(renderer.render(&view(plan_matrix()), &bad), Err(SceneError::Value { .. })));
    let bad = SceneData { background: [0.0, 2.0, 0.0], ..empty() };
    assert!(matches!(renderer.render(&view(plan_matrix()), &bad), Err(SceneError::Value { .. })));
    renderer.render(&view(plan_matrix()), &empty()).expect("the renderer survives bad data");
}

#[test]
fn pictures_do_not_depend_on_what_was_drawn_before() {
    let few = SceneData { points: point([1.0, 2.0, 0.0], 9.0, RED, 0.0), ..empty() };
    let mut many = few.clone();
    for i in 0..5000_u16 {
        let (x, y) = (f32::from(i % 100) / 5.0 - 10.0, f32::from(i / 100) / 3.0 - 8.0);
        many.points.extend(point([x, y, 0.0], 2.0, RED, 0.0));
        many.segments.extend(support::dashed([x, y, 0.0], [y, x, 0.0], 1.0, 5.0));
    }
    let (mut renderer, view) = (renderer(), view(plan_matrix()));
    let mut render = |data| renderer.render(&view, data).expect("sound data are drawn");
    let (first, crowded, again) = (render(&few), render(&many), render(&few));
    assert!(first != crowded, "5000 points and lines change nothing");
    assert!(first == again, "buffers that have grown change the picture");
}
