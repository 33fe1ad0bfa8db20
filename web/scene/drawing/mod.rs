//! The renderer, the same in the page and offscreen.

mod buffers;
pub(crate) mod device;
mod layers;
mod paint;
mod pipelines;
pub(crate) mod renderer;
mod sphere;
mod targets;
