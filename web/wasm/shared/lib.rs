//! What the WebAssembly modules of rangelab share.

use serde::Serialize;

/// Lets a panic in any module say on the console where it happened.
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen::prelude::wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}

/// The JSON of a document of the crate.
///
/// # Panics
/// Never for these: numbers, names and sentences always have a JSON form.
pub fn json<T: Serialize + ?Sized>(value: &T) -> String {
    serde_json::to_string(value).expect("numbers, names and sentences always have a JSON form")
}
