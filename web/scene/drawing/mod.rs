//! The renderer, the same in the page and offscreen.

mod buffers;
mod compute;
pub(crate) mod device;
mod field;
mod layers;
mod paint;
mod pipelines;
pub(crate) mod readback;
pub(crate) mod renderer;
mod sphere;
mod targets;
