//! Shared by the tests: one law for both dimensions, honest random problems, and the papers' gain form as the reference.
#![allow(dead_code, reason = "each test file uses its own part of these helpers")]

pub mod dense;
pub mod gain_form;
pub mod sampling;

/// Turns generic functions `law::<D>()` into tests in the plane and in space, native and in the browser.
#[macro_export]
macro_rules! in_plane_and_space {
    ($($law:ident),* $(,)?) => {
        mod plane {
            $(
                #[cfg_attr(not(target_arch = "wasm32"), test)]
                #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
                fn $law() { super::$law::<2>(); }
            )*
        }
        mod space {
            $(
                #[cfg_attr(not(target_arch = "wasm32"), test)]
                #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
                fn $law() { super::$law::<3>(); }
            )*
        }
    };
}

/// Fails with both numbers unless `error <= limit`; NaN fails.
#[track_caller]
pub fn at_most(what: &str, error: f64, limit: f64) {
    assert!(error <= limit, "{what}: {error:e} is above {limit:e}");
}

/// Fails unless a check would have caught an error planted on purpose: `error > limit`.
#[track_caller]
pub fn caught(what: &str, error: f64, limit: f64) {
    assert!(error > limit, "{what}: the planted error shows as {error:e} only, the check needs {limit:e}");
}
