//! What the WebAssembly modules of rangelab share.

mod complaints;

use serde::Serialize;

pub use complaints::complaints;

/// What people and files call an estimator or a bound.
#[derive(Serialize)]
pub struct Named<'a> {
    /// In files.
    pub name: &'a str,
    /// For people.
    pub label: &'a str,
}

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

/// `steps` rows of `width` numbers; what is missing becomes NaN.
pub fn padded<'a, T: 'a>(
    steps: usize,
    width: usize,
    entries: impl Iterator<Item = Option<&'a T>>,
    write: impl Fn(&T, &mut Vec<f64>),
) -> Vec<f64> {
    let mut numbers = Vec::with_capacity(steps * width);
    for (k, entry) in entries.enumerate() {
        if let Some(entry) = entry {
            write(entry, &mut numbers);
        }
        numbers.resize((k + 1) * width, f64::NAN);
    }
    numbers.resize(steps * width, f64::NAN);
    numbers
}
