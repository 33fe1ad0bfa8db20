//! Draws plain data with wgpu: segments, points, ellipsoids, triangles and a field of numbers, seen through a matrix.
//!
//! It knows nothing of estimators nor of how a camera moves. For the page it is built twice (features `webgpu` and
//! `webgl`) and draws on a canvas through the class `Scene`; natively (feature `native`) `Offscreen` draws into memory.
//! [`data`] says what the numbers mean.

pub mod dash;
pub mod data;
mod error;
pub mod field;
mod view;

pub use error::SceneError;
pub use view::View;

#[cfg(any(
    all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl")),
    all(not(target_arch = "wasm32"), feature = "native")
))]
mod drawing;

#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl")))]
mod browser;
#[cfg(all(target_arch = "wasm32", any(feature = "webgpu", feature = "webgl")))]
pub use browser::Scene;

#[cfg(all(not(target_arch = "wasm32"), feature = "native"))]
mod offscreen;
#[cfg(all(not(target_arch = "wasm32"), feature = "native"))]
pub use offscreen::{Offscreen, SceneData};
