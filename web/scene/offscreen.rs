//! The same renderer without a window: pictures for tests and for the README.

use wgpu::{
    Buffer, BufferDescriptor, BufferUsages, CommandEncoderDescriptor, Extent3d, MapMode, PollType,
    TexelCopyBufferInfo, TexelCopyBufferLayout, Texture, TextureDescriptor, TextureDimension, TextureFormat,
    TextureUsages, TextureViewDescriptor,
};

use crate::drawing::device::{self, Gpu};
use crate::drawing::renderer::Renderer;
use crate::error::SceneError;
use crate::view::View;

/// All that one picture shows; the layouts of the arrays are in [`crate::data`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SceneData {
    /// Colour (sRGB) where nothing is drawn.
    pub background: [f32; 3],
    /// See [`crate::data::SEGMENTS`].
    pub segments: Vec<f32>,
    /// See [`crate::data::POINTS`].
    pub points: Vec<f32>,
    /// See [`crate::data::ELLIPSOIDS`].
    pub ellipsoids: Vec<f32>,
    /// See [`crate::data::TRIANGLES`].
    pub triangles: Vec<f32>,
}

/// Draws pictures of one size on a graphics device of this machine (a software one will do).
pub struct Offscreen {
    gpu: Gpu,
    renderer: Renderer,
    texture: Texture,
    readback: Buffer,
    row_bytes: u32,
}

impl Offscreen {
    /// Opens a device for pictures of this size in pixels.
    ///
    /// # Errors
    /// [`SceneError::Device`] without a Vulkan device, [`SceneError::Size`] for an impossible size.
    pub fn new(width_px: u32, height_px: u32) -> Result<Self, SceneError> {
        pollster::block_on(async {
            let gpu = Gpu::open(&device::instance(), None).await?;
            let limit_px = gpu.device.limits().max_texture_dimension_2d;
            if width_px.min(height_px) == 0 || width_px.max(height_px) > limit_px {
                return Err(SceneError::Size { width_px, height_px, limit_px });
            }
            let renderer = Renderer::new(&gpu, TextureFormat::Rgba8Unorm).await?;
            let texture = texture(&gpu, width_px, height_px);
            let row_bytes = (4 * width_px).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
            let readback = gpu.device.create_buffer(&BufferDescriptor {
                label: Some("picture"),
                size: u64::from(row_bytes) * u64::from(height_px),
                usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
                mapped_at_creation: false,
            });
            Ok(Self { gpu, renderer, texture, readback, row_bytes })
        })
    }

    /// Draws one picture; returns its RGBA bytes, row by row from the top.
    ///
    /// # Errors
    /// Whatever [`crate::data::Layout::check`] refuses, or a failure of the device.
    pub fn render(&mut self, view: &View, data: &SceneData) -> Result<Vec<u8>, SceneError> {
        self.renderer.set_background(data.background)?;
        self.renderer.set_triangles(&data.triangles)?;
        self.renderer.set_ellipsoids(&data.ellipsoids)?;
        self.renderer.set_segments(&data.segments)?;
        self.renderer.set_points(&data.points)?;
        self.renderer.set_view(view.clone());
        let size_px = (self.texture.width(), self.texture.height());
        self.renderer.render(&self.texture.create_view(&TextureViewDescriptor::default()), size_px)?;
        self.read_pixels()
    }

    fn read_pixels(&self) -> Result<Vec<u8>, SceneError> {
        let failed = |reason: &dyn std::fmt::Display| SceneError::Device(reason.to_string());
        let mut encoder = self.gpu.device.create_command_encoder(&CommandEncoderDescriptor::default());
        let layout =
            TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(self.row_bytes), rows_per_image: None };
        let copy = TexelCopyBufferInfo { buffer: &self.readback, layout };
        encoder.copy_texture_to_buffer(self.texture.as_image_copy(), copy, self.texture.size());
        self.gpu.queue.submit([encoder.finish()]);
        let (sender, receiver) = std::sync::mpsc::channel();
        self.readback.slice(..).map_async(MapMode::Read, move |result| {
            // The receiver waits below; it cannot be gone.
            sender.send(result).ok();
        });
        self.gpu.device.poll(PollType::wait_indefinitely()).map_err(|error| failed(&error))?;
        receiver.recv().map_err(|error| failed(&error))?.map_err(|error| failed(&error))?;
        let width = 4 * self.texture.width() as usize;
        let mapped = self.readback.slice(..).get_mapped_range().map_err(|error| failed(&error))?;
        let pixels =
            mapped.chunks_exact(self.row_bytes as usize).flat_map(|row| &row[..width]).copied().collect();
        drop(mapped);
        self.readback.unmap();
        Ok(pixels)
    }
}

fn texture(gpu: &Gpu, width: u32, height: u32) -> Texture {
    gpu.device.create_texture(&TextureDescriptor {
        label: Some("picture"),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: TextureFormat::Rgba8Unorm,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}
