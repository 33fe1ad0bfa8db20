//! The fine grid: kernels fill it exactly, it is drawn over the coarse one where it is resolved, troubles are told.

use rangelab_scene::field::FieldData;
use rangelab_scene::{Offscreen, SceneData, SceneError};

use super::support::{BLUE_RGB, GREEN_RGB, HEIGHT_PX, Picture, RED_RGB, WIDTH_PX, field, plan_matrix, view};
use super::{empty, renderer};

/// A kernel that stores `body`'s value for the cell (x, y) of a grid of `size`; p is what it reads.
fn kernel(body: &str) -> String {
    format!(
        "@group(0) @binding(0) var<storage, read> parameters: array<f32>;
        @group(0) @binding(1) var values: texture_storage_2d<r32float, write>;
        @compute @workgroup_size(8, 8)
        fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
            let size = textureDimensions(values);
            if any(id.xy >= size) {{ return; }}
            let x = f32(id.x);
            let y = f32(id.y);
            let count = f32(arrayLength(&parameters));
            textureStore(values, id.xy, vec4({body}, 0.0, 0.0, 0.0));
        }}"
    )
}

/// Green in the left half, blue in the right one.
const HALVES: &str = "select(0.1, 1.0, 2.0 * x >= f32(size.x))";

/// Red everywhere.
fn coarse() -> FieldData {
    field(&[0.01; 4], [2, 2], 0.0)
}

fn picture(renderer: &mut Offscreen, field: FieldData) -> Picture {
    let data = SceneData { field, ..empty() };
    Picture { rgba: renderer.render(&view(plan_matrix()), &data).expect("sound data are drawn") }
}

/// Colours in the left and the right half.
fn halves(renderer: &mut Offscreen, field: FieldData) -> [[u8; 3]; 2] {
    let picture = picture(renderer, field);
    [picture.plan(-3.0, 1.0), picture.plan(3.0, 1.0)]
}

/// Sets the coarse field and fills a fine one of 16 x 16 cells.
fn refine(renderer: &mut Offscreen, body: &str) {
    renderer.set_field(&coarse()).expect("a sound field");
    renderer.set_field_kernel(&kernel(body)).expect("a sound kernel");
    renderer.compute_field(&[1.0], 16, 16).expect("a kernel runs");
}

#[test]
fn what_a_kernel_stores_is_read_back_exactly() {
    let mut renderer = renderer();
    assert!(renderer.can_compute());
    renderer.set_field(&coarse()).expect("a sound field");
    let body = "parameters[0] + parameters[1] * x + parameters[2] * y + 1000.0 * count";
    renderer.set_field_kernel(&kernel(body)).expect("a sound kernel");
    for [width, height] in [[13_u16, 7], [64, 8], [1, 1], [100, 3]] {
        let (columns, rows) = (u32::from(width), u32::from(height));
        renderer.compute_field(&[0.5, 1.0, -128.0], columns, rows).expect("a kernel runs");
        let expected: Vec<f32> = (0..height)
            .flat_map(|y| (0..width).map(move |x| 3000.5 + f32::from(x) - 128.0 * f32::from(y)))
            .collect();
        assert!(renderer.read_fine_field().expect("a filled grid") == expected, "{width} x {height}");
    }
    // Millions of parameters need no more than any device has.
    renderer.compute_field(&vec![1.0; 1 << 20], 2, 1).expect("a kernel runs");
    assert_eq!(renderer.read_fine_field(), Ok(vec![1000.0 * 1_048_576.0 + 2.0 - 1.0, 1_048_576_002.0]));
}

#[test]
fn the_fine_field_is_drawn_over_the_coarse_one_at_the_centres_of_its_cells() {
    let mut renderer = renderer();
    refine(&mut renderer, HALVES);
    assert_eq!(halves(&mut renderer, coarse()), [GREEN_RGB, BLUE_RGB]);
    // Rows run along the second edge, as those of the coarse field do.
    refine(&mut renderer, "select(0.1, 1.0, y < 8.0)");
    let rows = picture(&mut renderer, coarse());
    assert_eq!((rows.plan(0.0, -2.0), rows.plan(0.0, 2.0)), (BLUE_RGB, GREEN_RGB));
}

#[test]
fn where_the_fine_field_is_not_resolved_the_coarse_one_is_seen() {
    let mut renderer = renderer();
    refine(&mut renderer, "select(-1.0, 1.0, x >= 8.0)");
    assert_eq!(halves(&mut renderer, coarse()), [RED_RGB, BLUE_RGB]);
    let border = picture(&mut renderer, coarse());
    assert_eq!((border.plan(-0.15, 0.0), border.plan(0.15, 0.0)), (RED_RGB, BLUE_RGB), "at the border");
    refine(&mut renderer, "select(-1.0, 1.0e30, x >= 8.0)");
    let [left, [red, green, blue]] = halves(&mut renderer, coarse());
    assert!(left == RED_RGB && red == green && green == blue, "no bound in the right half");
}

#[test]
fn the_fine_field_stays_until_the_rectangle_changes_or_it_is_dropped() {
    let (mut renderer, fine) = (renderer(), [GREEN_RGB, BLUE_RGB]);
    refine(&mut renderer, HALVES);
    assert_eq!(halves(&mut renderer, field(&[0.01; 6], [3, 2], 0.0)), fine, "other values");
    let mut moved = coarse();
    moved.rectangle[2] = 0.5;
    assert_eq!(halves(&mut renderer, moved.clone()), [RED_RGB; 2], "another rectangle");
    assert!(matches!(renderer.read_fine_field(), Err(SceneError::FineField(_))));
    renderer.compute_field(&[1.0], 16, 16).expect("a kernel runs");
    assert_eq!(halves(&mut renderer, moved.clone()), fine, "computed again");
    renderer.drop_fine_field();
    assert_eq!(halves(&mut renderer, moved), [RED_RGB; 2], "dropped");
    refine(&mut renderer, HALVES);
    renderer.set_field(&FieldData::default()).expect("no field");
    assert_eq!(halves(&mut renderer, coarse()), [RED_RGB; 2], "removed and set again");
}

#[test]
fn a_broken_kernel_is_told_in_the_words_of_the_compiler_and_the_scene_goes_on() {
    let mut renderer = renderer();
    let write_only = "texture_storage_2d<r32float, write>";
    let cases = [
        (kernel("no_such_thing"), "no_such_thing"),
        (kernel("0.1").replace("fn main", "fn other"), "main"),
        (kernel("0.1").replace(write_only, "texture_storage_2d<r32uint, write>"), ""),
        ("what is this".into(), "expected global item"),
        (String::new(), "main"),
    ];
    for (wgsl, word) in cases {
        refine(&mut renderer, HALVES);
        let refused = renderer.set_field_kernel(&wgsl).expect_err("a broken kernel is refused");
        let message = refused.to_string();
        assert!(matches!(refused, SceneError::Kernel(_)) && message.contains(word), "{message}");
        assert!(message.starts_with("the kernel of the field was refused: "), "{message}");
        assert_eq!(halves(&mut renderer, coarse()), [RED_RGB; 2], "the coarse field is drawn");
        let refused = renderer.compute_field(&[1.0], 8, 8).map_err(|error| error.to_string());
        assert_eq!(refused, Err("no fine field: no kernel was accepted yet".into()));
    }
    refine(&mut renderer, HALVES);
    assert_eq!(halves(&mut renderer, coarse()), [GREEN_RGB, BLUE_RGB]);
}

#[test]
fn what_cannot_be_computed_is_refused_in_words_and_the_old_grid_stays() {
    let mut renderer = renderer();
    refine(&mut renderer, HALVES);
    let mut refusal = |parameters: &[f32], width, height| {
        renderer.compute_field(parameters, width, height).expect_err("refused").to_string()
    };
    assert_eq!(refusal(&[], 8, 8), "no fine field: the kernel has no parameters to read");
    assert_eq!(
        refusal(&[1.0, f32::NAN], 8, 8),
        "field parameters: record 1 has number = NaN, but it must be a finite number"
    );
    assert!(
        refusal(&[1.0], 8, 0).starts_with("a grid of 8 x 0 cells is impossible: this device holds 1 to ")
    );
    assert!(refusal(&[1.0], 1_000_000, 8).starts_with("a grid of 1000000 x 8 cells is impossible"));
    assert_eq!(halves(&mut renderer, coarse()), [GREEN_RGB, BLUE_RGB]);
    renderer.set_field(&FieldData::default()).expect("no field");
    let refused = renderer.compute_field(&[1.0], 8, 8).map_err(|error| error.to_string());
    assert_eq!(refused, Err("no fine field: there is no field to refine".into()));
}

#[test]
fn a_device_that_cannot_compute_says_so_and_draws() {
    let mut renderer = Offscreen::without_compute(WIDTH_PX, HEIGHT_PX).expect("a device");
    assert!(!renderer.can_compute());
    assert_eq!(halves(&mut renderer, coarse()), [RED_RGB; 2]);
    let cannot = SceneError::FineField("this device draws but cannot compute");
    assert_eq!(renderer.set_field_kernel(&kernel("0.1")), Err(cannot.clone()));
    assert_eq!(renderer.compute_field(&[1.0], 8, 8), Err(cannot.clone()));
    assert_eq!(cannot.to_string(), "no fine field: this device draws but cannot compute");
    assert!(renderer.read_fine_field().is_err());
    renderer.drop_fine_field();
    assert_eq!(halves(&mut renderer, coarse()), [RED_RGB; 2]);
}
