//! The class `Scene` in a browser: pictures on a canvas are read back, bad data and lost devices come back as errors.
#![cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl")))]

use js_sys::{Error, Float32Array, Function, Promise, Reflect};
use rangelab_scene::Scene;
use wasm_bindgen::{JsCast, JsError, JsValue};
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

wasm_bindgen_test_configure!(run_in_browser);

const SIZE_PX: u32 = 64;
const WHITE: [u8; 3] = [255; 3];
const RED: [u8; 3] = [255, 0, 0];
const GREEN: [u8; 3] = [0, 255, 0];
const BLUE: [u8; 3] = [0, 0, 255];

/// x and y from -1 to 1 across the picture, z from 0 (near) to 1.
const PLAIN: [f32; 16] = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

fn canvas() -> HtmlCanvasElement {
    let document = web_sys::window().and_then(|window| window.document()).expect("a page");
    document.create_element("canvas").expect("a canvas").unchecked_into()
}

fn numbers(values: &[f32]) -> Float32Array {
    Float32Array::from(values)
}

fn done<T>(result: Result<T, JsError>) -> T {
    result.unwrap_or_else(|error| panic!("{}", message(error)))
}

fn message(error: JsError) -> String {
    JsValue::from(error).unchecked_into::<Error>().message().into()
}

/// A white scene with the plain view on a new canvas.
async fn scene(canvas: &HtmlCanvasElement) -> Scene {
    let mut scene = done(Scene::create(canvas.clone()).await);
    done(scene.resize(SIZE_PX, SIZE_PX));
    done(scene.set_background(1.0, 1.0, 1.0));
    done(scene.set_view(&numbers(&PLAIN), SIZE_PX as f32, SIZE_PX as f32));
    scene
}

/// Draws and copies the canvas in the same task, before the browser clears it; returns a look-up by column and row.
fn picture(scene: &mut Scene, canvas: &HtmlCanvasElement) -> impl Fn(u32, u32) -> [u8; 3] + use<> {
    let copy = self::canvas();
    let context = copy.get_context("2d").ok().flatten().expect("a 2-D context");
    let context: CanvasRenderingContext2d = context.unchecked_into();
    done(scene.render());
    context.draw_image_with_html_canvas_element(canvas, 0.0, 0.0).expect("canvases can be copied");
    let size = f64::from(SIZE_PX);
    let rgba = context.get_image_data(0.0, 0.0, size, size).expect("pixels can be read").data().0;
    move |column, row| {
        let at = 4 * (row * SIZE_PX + column) as usize;
        [rgba[at], rgba[at + 1], rgba[at + 2]]
    }
}

/// A red line along the upper quarter, drawn as far as `end_x`.
fn line(end_x: f32) -> Float32Array {
    numbers(&[-1.0, 0.5, 0.5, end_x, 0.5, 0.5, 6.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0])
}

#[wasm_bindgen_test]
async fn one_of_everything_is_drawn_where_it_belongs() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    assert_eq!(scene.backend(), if cfg!(feature = "webgpu") { "WebGPU" } else { "WebGL2" });
    done(scene.set_segments(&line(1.0)));
    done(scene.set_points(&numbers(&[-0.5, -0.5, 0.2, 8.0, 0.0, 0.0, 1.0, 1.0, 2.0])));
    let axes = [0.3, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 0.1];
    done(scene.set_ellipsoids(&numbers(&[&[0.5, -0.5, 0.5], &axes[..], &[1.0, 0.0, 0.0, 0.5]].concat())));
    let corner = |x: f32, y: f32| [x, y, 0.9, 0.0, 0.0, 0.0, 0.5, 0.25, 0.75, 1.0];
    done(scene.set_triangles(&numbers(&[corner(-1.0, 1.0), corner(1.0, 1.0), corner(0.0, 0.7)].concat())));

    let at = picture(&mut scene, &canvas);
    assert_eq!((at(10, 16), at(50, 16), at(32, 24)), (RED, RED, WHITE), "the line at y = 0.5 and below it");
    assert_eq!((at(16, 48), at(16, 36)), (BLUE, WHITE), "the square and above it");
    let [red, green, _] = at(48, 48);
    assert!(red > 200 && (60..240).contains(&green), "the ellipsoid tints: {:?}", at(48, 48));
    assert_eq!((at(48, 34), at(62, 48)), (WHITE, WHITE), "around the ellipsoid");
    let [r, g, b] = at(32, 4);
    let exact = r.abs_diff(128) < 3 && g.abs_diff(64) < 3 && b.abs_diff(191) < 3;
    assert!(exact, "unshaded triangles keep their sRGB colour: {:?}", at(32, 4));
    assert!(!scene.lost());
}

#[wasm_bindgen_test]
async fn another_matrix_shows_another_picture() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    done(scene.set_segments(&line(1.0)));
    assert_eq!(picture(&mut scene, &canvas)(32, 16), RED);
    let mut upside_down = PLAIN;
    upside_down[5] = -1.0;
    done(scene.set_view(&numbers(&upside_down), SIZE_PX as f32, SIZE_PX as f32));
    let at = picture(&mut scene, &canvas);
    assert_eq!((at(32, 16), at(32, 48)), (WHITE, RED));
}

#[wasm_bindgen_test]
async fn bad_data_are_refused_in_words_and_the_old_are_kept() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    done(scene.set_segments(&line(1.0)));
    let refusals = [
        (scene.set_segments(&numbers(&[0.0; 14])), "segments: 14 numbers do not make whole records of 13"),
        (
            scene.set_segments(&line(f32::NAN)),
            "segments: record 0 has end x = NaN, but it must be a finite number",
        ),
        (scene.set_view(&numbers(&PLAIN[..9]), 64.0, 64.0), "view: a matrix has 16 numbers, not 9"),
        (
            scene.set_background(0.0, 0.0, 255.0),
            "background: record 0 has blue = 255, but it must be a number from 0 to 1",
        ),
    ];
    for (refusal, words) in refusals {
        assert_eq!(message(refusal.expect_err(words)), words);
    }
    let too_large = scene.resize(1_000_000, 64).expect_err("no device draws a million pixels across");
    assert!(message(too_large).starts_with("a picture of 1000000 x 64 pixels is too large"));
    let at = picture(&mut scene, &canvas);
    assert_eq!((at(32, 16), at(32, 40)), (RED, WHITE));
}

#[wasm_bindgen_test]
async fn an_empty_canvas_is_no_error_and_sizes_can_change() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    done(scene.set_segments(&line(1.0)));
    done(scene.resize(0, 0));
    done(scene.render());
    done(scene.resize(33, 17));
    done(scene.render());
    done(scene.resize(SIZE_PX, SIZE_PX));
    assert_eq!((canvas.width(), canvas.height()), (SIZE_PX, SIZE_PX));
    assert_eq!(picture(&mut scene, &canvas)(32, 16), RED);
}

/// Red at 0.01, green at 0.1, blue at 1, hatched black above 10, grey where no bound exists.
const STYLE: [f32; 20] =
    [0.01, 1.0, 10.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 3.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];

/// Sets a field that fills the picture, its first row at the bottom.
fn set_field(scene: &mut Scene, values: &[f32], [width, height]: [u32; 2]) -> Result<(), JsError> {
    let rectangle = [-1.0, -1.0, 0.5, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0];
    scene.set_field(&numbers(values), width, height, &numbers(&rectangle), &numbers(&STYLE))
}

#[wasm_bindgen_test]
async fn a_field_shows_its_cells_hatching_and_where_no_bound_exists() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    done(set_field(&mut scene, &[0.01, 0.1, 1.0, 1e30], [2, 2]));
    let at = picture(&mut scene, &canvas);
    assert_eq!((at(16, 48), at(48, 48), at(16, 16)), (RED, GREEN, BLUE));
    let grey = |[red, green, blue]: [u8; 3]| red == green && green == blue;
    let corner = || (33..64).flat_map(|column| (0..31).map(move |row| (column, row)));
    assert!(corner().all(|(column, row)| grey(at(column, row))), "colours where no bound exists");
    let of = |low: u8, high: u8| corner().filter(|&(c, r)| (low..=high).contains(&at(c, r)[0])).count();
    assert!(of(126, 129) > 400 && of(0, 40) > 40, "{} of the colour, {} hatched", of(126, 129), of(0, 40));

    done(set_field(&mut scene, &[0.01, 100.0], [1, 2]));
    done(scene.set_segments(&line(0.0)));
    let at = picture(&mut scene, &canvas);
    let dark = |row: u32| (34..64).filter(|&column| at(column, row).iter().all(|&part| part < 90)).count();
    let dark = |rows: std::ops::Range<u32>| rows.map(dark).sum::<usize>();
    assert_eq!((at(50, 48), at(10, 16)), (RED, RED), "the lower cell, the line over the upper one");
    assert!((20..120).contains(&dark(0..16)), "{} of 480 pixels are hatched above", dark(0..16));
    assert_eq!(dark(48..64), 0, "pixels are hatched below");
    done(set_field(&mut scene, &[], [0, 0]));
    assert_eq!(picture(&mut scene, &canvas)(50, 48), WHITE, "no field any more");
}

#[wasm_bindgen_test]
async fn bad_fields_are_refused_in_words_and_the_old_one_is_kept() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    done(set_field(&mut scene, &[0.1; 4], [2, 2]));
    let refusals = [
        (set_field(&mut scene, &[0.01; 5], [2, 2]), "field values: 5 numbers came, but there must be 4"),
        (
            set_field(&mut scene, &[0.01, f32::NAN], [2, 1]),
            "field values: record 1 has number = NaN, but it must be a positive number",
        ),
        (
            scene.set_field(&numbers(&[0.01]), 1, 1, &numbers(&[0.0; 9]), &numbers(&STYLE[..17])),
            "field style: 17 numbers came, but there must be 20",
        ),
    ];
    for (refusal, words) in refusals {
        assert_eq!(message(refusal.expect_err(words)), words);
    }
    assert_eq!(picture(&mut scene, &canvas)(32, 32), GREEN);
}

/// A kernel that stores the number that `body` makes of the cell `id`.
fn kernel(body: &str) -> String {
    format!(
        "@group(0) @binding(0) var<storage, read> parameters: array<f32>;
        @group(0) @binding(1) var values: texture_storage_2d<r32float, write>;
        @compute @workgroup_size(8, 8) fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
            textureStore(values, id.xy, vec4({body}, 0.0, 0.0, 0.0));
        }}"
    )
}

/// What a promise resolves to, or the words of its rejection.
async fn settled(promise: Promise) -> Result<JsValue, String> {
    JsFuture::from(promise).await.map_err(|error| error.unchecked_into::<Error>().message().into())
}

#[wasm_bindgen_test]
async fn a_kernel_fills_a_fine_field_where_the_device_can_compute() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    done(set_field(&mut scene, &[0.01; 4], [2, 2]));
    assert_eq!(scene.can_compute(), cfg!(feature = "webgpu"));
    // Not resolved in the left half, else the first parameter above and the second below.
    let body = "select(-1.0, parameters[u32(id.y < 10u)], id.x >= 7u)";
    let compiled = settled(scene.set_field_kernel(&kernel(body))).await;
    if cfg!(feature = "webgl") {
        let cannot = || Err("no fine field: this device draws but cannot compute".into());
        assert_eq!(compiled, cannot());
        assert_eq!(settled(scene.compute_field(&numbers(&[1.0, 0.1]), 14, 20)).await, cannot());
        assert!(settled(scene.read_fine_field()).await.is_err());
        assert_eq!(picture(&mut scene, &canvas)(48, 48), RED);
        return;
    }
    assert_eq!(compiled, Ok(JsValue::UNDEFINED));
    let filled = scene.compute_field(&numbers(&[1.0, 0.1]), 14, 20);
    // It is drawn at once, in the order of submission, while the promise is still pending.
    let at = picture(&mut scene, &canvas);
    assert_eq!((at(16, 16), at(48, 16), at(48, 48)), (RED, BLUE, GREEN));
    assert_eq!(settled(filled).await, Ok(JsValue::UNDEFINED));
    let stored = settled(scene.read_fine_field()).await.map(|value| Float32Array::from(value).to_vec());
    let cell = |x: u32, y: u32| if x < 7 { -1.0 } else { [1.0, 0.1][usize::from(y < 10)] };
    let expected: Vec<f32> = (0..20).flat_map(|y| (0..14).map(move |x| cell(x, y))).collect();
    assert_eq!(stored, Ok(expected));
    scene.drop_fine_field();
    assert_eq!(picture(&mut scene, &canvas)(48, 48), RED);
}

#[cfg(feature = "webgpu")]
#[wasm_bindgen_test]
async fn a_broken_kernel_rejects_with_the_words_of_the_compiler_and_the_scene_goes_on() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    done(set_field(&mut scene, &[0.01; 4], [2, 2]));
    assert_eq!(settled(scene.set_field_kernel(&kernel("1.0"))).await, Ok(JsValue::UNDEFINED));
    assert_eq!(settled(scene.compute_field(&numbers(&[1.0]), 8, 8)).await, Ok(JsValue::UNDEFINED));
    assert_eq!(picture(&mut scene, &canvas)(48, 48), BLUE);
    let refused = settled(scene.set_field_kernel(&kernel("no_such_thing"))).await.unwrap_err();
    assert!(refused.starts_with("the kernel of the field was refused: "), "{refused}");
    assert!(refused.contains("no_such_thing"), "{refused}");
    let refused = settled(scene.compute_field(&numbers(&[1.0]), 8, 8)).await;
    assert_eq!(refused, Err("no fine field: no kernel was accepted yet".into()));
    let refused = settled(scene.compute_field(&numbers(&[f32::NAN]), 8, 8)).await.unwrap_err();
    assert!(refused.starts_with("field parameters: record 0 has number = NaN"), "{refused}");
    assert_eq!(picture(&mut scene, &canvas)(48, 48), RED, "the coarse field is drawn, without a fault");
    assert!(!scene.lost());
}

/// Bytes of WebAssembly memory, which never shrinks.
fn memory_bytes() -> Option<f64> {
    let memory = wasm_bindgen::memory().unchecked_into::<js_sys::WebAssembly::Memory>();
    Reflect::get(&memory.buffer(), &"byteLength".into()).ok().and_then(|length| length.as_f64())
}

#[wasm_bindgen_test]
async fn frames_of_equal_size_need_no_more_memory() {
    let canvas = canvas();
    let mut scene = scene(&canvas).await;
    // 100 kB a frame: 200 leaked frames would be 20 MB. Out of sight, since a software adapter takes long to draw them.
    let aside = [5.0, 0.0, 0.5, 6.0, 0.0, 0.5, 2.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let track: Vec<f32> = (0..2000).flat_map(|_| aside).collect();
    let (track, field) = (numbers(&track), [0.1; 1024]);
    let mut warm = None;
    for frame in 0..220 {
        done(scene.set_segments(&track));
        done(set_field(&mut scene, &field, [32, 32]));
        done(scene.render());
        milliseconds(5).await;
        if frame == 20 {
            warm = memory_bytes();
        }
    }
    assert_eq!(memory_bytes(), warm);
}

/// Gives the browser a turn.
async fn milliseconds(count: u32) {
    let later = Function::new_with_args("count, done", "setTimeout(done, count)");
    let promise = Promise::new(&mut |resolve, _| {
        later.call2(&JsValue::NULL, &count.into(), &resolve).expect("timers work");
    });
    JsFuture::from(promise).await.expect("timers do not fail");
}

fn run(body: &str, argument: &JsValue) {
    Function::new_with_args("canvas", body).call1(&JsValue::NULL, argument).expect(body);
}

#[wasm_bindgen_test]
async fn a_lost_device_is_noticed() {
    let keep = "globalThis.request ??= GPUAdapter.prototype.requestDevice;
        GPUAdapter.prototype.requestDevice = async function (...a) {
            return (globalThis.device = await globalThis.request.apply(this, a));
        };";
    let webgpu = cfg!(feature = "webgpu");
    let canvas = canvas();
    if webgpu {
        run(keep, &canvas);
    }
    let mut scene = scene(&canvas).await;
    done(scene.render());
    assert!(!scene.lost());
    let lose = "canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()";
    run(if webgpu { "globalThis.device.destroy()" } else { lose }, &canvas);
    milliseconds(100).await;
    assert!(scene.lost());
    let error = scene.render().expect_err("nothing can be drawn any more");
    assert_eq!(message(error), "the graphics device was lost");
}

#[wasm_bindgen_test]
async fn a_browser_without_an_adapter_is_an_error_in_words() {
    let canvas = canvas();
    let hide = if cfg!(feature = "webgpu") {
        "globalThis.ask = GPU.prototype.requestAdapter; GPU.prototype.requestAdapter = async () => null"
    } else {
        "canvas.getContext = () => null"
    };
    run(hide, &canvas);
    let refused = Scene::create(canvas.clone()).await.err().map(message).unwrap_or_default();
    if cfg!(feature = "webgpu") {
        run("GPU.prototype.requestAdapter = globalThis.ask", &canvas);
    }
    assert!(refused.starts_with("no graphics device: "), "{refused}");
}

#[wasm_bindgen_test]
async fn a_canvas_that_is_already_in_use_is_an_error_in_words() {
    let canvas = canvas();
    canvas.get_context("2d").expect("a 2-D context");
    let refused = Scene::create(canvas).await.err().map(message).unwrap_or_default();
    assert!(refused.starts_with("no graphics device: "), "{refused}");
}
