//! Draws plain data with wgpu.
