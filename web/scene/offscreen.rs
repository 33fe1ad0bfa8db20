//! The same renderer without a window: pictures for tests and for the README.

use wgpu::{
    Extent3d, PollType, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
    TextureViewDescriptor,
};

use crate::drawing::device::{self, Gpu};
use crate::drawing::readback;
use crate::drawing::renderer::Renderer;
use crate::error::SceneError;
use crate::field::FieldData;
use crate::view::View;

/// All that one picture shows; the layouts of the arrays are in [`crate::data`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SceneData {
    /// Colour (sRGB) where nothing is drawn.
    pub background: [f32; 3],
    /// Under everything else, whatever is nearer.
    pub field: FieldData,
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
}

impl Offscreen {
    /// Opens a device for pictures of this size in pixels.
    ///
    /// # Errors
    /// [`SceneError::Device`] without a Vulkan device, [`SceneError::Size`] for an impossible size.
    pub fn new(width_px: u32, height_px: u32) -> Result<Self, SceneError> {
        Self::open(width_px, height_px, true)
    }

    /// The same on a device that only draws, as WebGL 2 does.
    ///
    /// # Errors
    /// Those of [`Offscreen::new`].
    pub fn without_compute(width_px: u32, height_px: u32) -> Result<Self, SceneError> {
        Self::open(width_px, height_px, false)
    }

    fn open(width_px: u32, height_px: u32, compute: bool) -> Result<Self, SceneError> {
        pollster::block_on(async {
            let gpu = Gpu::open(&device::instance(), None, compute).await?;
            let limit_px = gpu.device.limits().max_texture_dimension_2d;
            if width_px.min(height_px) == 0 || width_px.max(height_px) > limit_px {
                return Err(SceneError::Size { width_px, height_px, limit_px });
            }
            let renderer = Renderer::new(&gpu, TextureFormat::Rgba8Unorm).await?;
            let texture = texture(&gpu, width_px, height_px);
            Ok(Self { gpu, renderer, texture })
        })
    }

    /// Draws one picture; returns its RGBA bytes, row by row from the top.
    ///
    /// # Errors
    /// Whatever [`crate::data::Layout::check`] refuses, or a failure of the device.
    pub fn render(&mut self, view: &View, data: &SceneData) -> Result<Vec<u8>, SceneError> {
        self.renderer.set_background(data.background)?;
        self.renderer.field.set(&data.field)?;
        self.renderer.set_triangles(&data.triangles)?;
        self.renderer.set_ellipsoids(&data.ellipsoids)?;
        self.renderer.set_segments(&data.segments)?;
        self.renderer.set_points(&data.points)?;
        self.renderer.set_view(view.clone());
        let size_px = (self.texture.width(), self.texture.height());
        self.renderer.render(&self.texture.create_view(&TextureViewDescriptor::default()), size_px)?;
        self.wait(readback::texels(&self.gpu.device, &self.gpu.queue, &self.texture))
    }

    /// Whether this device runs kernels.
    pub fn can_compute(&self) -> bool {
        self.renderer.field.can_compute()
    }

    /// Replaces the field, so that a kernel can fill a fine grid of it. [`Offscreen::render`] sets that of its data; a fine
    /// grid stays as long as the rectangle does.
    ///
    /// # Errors
    /// Those of [`FieldData::check`], or [`SceneError::Grid`].
    pub fn set_field(&mut self, field: &FieldData) -> Result<(), SceneError> {
        self.renderer.field.set(field)
    }

    /// Compiles the kernel that fills fine grids: a WGSL module whose entry point `main` has `@workgroup_size(8, 8)`, reads
    /// `@group(0) @binding(0) var<storage, read> parameters: array<f32>` and stores into
    /// `@group(0) @binding(1) var values: texture_storage_2d<r32float, write>`. A negative number means "not resolved".
    ///
    /// # Errors
    /// [`SceneError::Kernel`] with the compiler's message, or [`SceneError::FineField`] on a device that cannot compute.
    pub fn set_field_kernel(&mut self, wgsl: &str) -> Result<(), SceneError> {
        let compiled = self.renderer.field.set_kernel(wgsl)?;
        self.wait(compiled)
    }

    /// Lets the kernel fill a fine grid over the rectangle of the field, which is drawn where it is resolved.
    ///
    /// # Errors
    /// [`SceneError::FineField`] without a field or a kernel, [`SceneError::Value`] for a bad parameter,
    /// [`SceneError::Grid`] for an impossible size, or a failure of the device.
    pub fn compute_field(&mut self, parameters: &[f32], width: u32, height: u32) -> Result<(), SceneError> {
        let filled = self.renderer.field.compute(parameters, width, height)?;
        self.wait(filled)
    }

    /// Draws only the numbers of the field itself from now on.
    pub fn drop_fine_field(&mut self) {
        self.renderer.field.drop_fine();
    }

    /// The numbers of the fine grid, row by row.
    ///
    /// # Errors
    /// [`SceneError::FineField`] if there is none.
    pub fn read_fine_field(&self) -> Result<Vec<f32>, SceneError> {
        self.wait(self.renderer.field.read_fine()?)
    }

    /// Waits for all that was submitted, so that a future that depends on it is ready.
    fn wait<T>(&self, submitted: impl Future<Output = Result<T, SceneError>>) -> Result<T, SceneError> {
        let failed = |error: wgpu::PollError| SceneError::Device(error.to_string());
        self.gpu.device.poll(PollType::wait_indefinitely()).map_err(failed)?;
        pollster::block_on(submitted)
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
