//! The textures that a picture is drawn into before it reaches the canvas: samples and depth.

use wgpu::{
    Device, Extent3d, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView,
};

use super::pipelines::DEPTH_FORMAT;

/// Colour samples (when multisampling) and depth of one size.
pub(crate) struct Targets {
    pub(crate) width_px: u32,
    pub(crate) height_px: u32,
    pub(crate) samples: Option<TextureView>,
    pub(crate) depth: TextureView,
}

impl Targets {
    /// Textures for pictures of this size.
    pub(crate) fn new(
        device: &Device,
        format: TextureFormat,
        sample_count: u32,
        (width_px, height_px): (u32, u32),
    ) -> Self {
        let texture = |label, format| {
            let descriptor = TextureDescriptor {
                label: Some(label),
                size: Extent3d { width: width_px, height: height_px, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count,
                dimension: TextureDimension::D2,
                format,
                usage: TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            };
            device.create_texture(&descriptor).create_view(&wgpu::TextureViewDescriptor::default())
        };
        let samples = (sample_count > 1).then(|| texture("scene samples", format));
        Self { width_px, height_px, samples, depth: texture("scene depth", DEPTH_FORMAT) }
    }
}
