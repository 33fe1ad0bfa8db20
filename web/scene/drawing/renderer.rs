//! The renderer: takes plain data and a view, draws a picture into a texture.

use std::sync::Arc;

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, Buffer, BufferDescriptor, BufferUsages, Color,
    CommandEncoderDescriptor, Device, ErrorFilter, LoadOp, Operations, Queue, RenderPass,
    RenderPassColorAttachment, RenderPassDepthStencilAttachment, RenderPassDescriptor, StoreOp,
    TextureFormat, TextureView,
};

use super::device::{Gpu, Health};
use super::field::Field;
use super::layers::{Plain, Segments, Sphere, Triangles};
use super::paint;
use super::pipelines::Pipelines;
use super::targets::Targets;
use crate::error::SceneError;
use crate::view::View;

/// Draws the scene on one device; buffers live as long as it does.
pub(crate) struct Renderer {
    device: Device,
    queue: Queue,
    health: Arc<Health>,
    format: TextureFormat,
    sample_count: u32,
    pub(crate) pipelines: Pipelines,
    uniform: Buffer,
    view_group: BindGroup,
    view: Option<View>,
    background: [f32; 3],
    targets: Option<Targets>,
    pub(crate) sphere: Sphere,
    pub(crate) field: Field,
    pub(crate) triangles: Triangles,
    pub(crate) ellipsoids: Plain,
    pub(crate) segments: Segments,
    pub(crate) points: Plain,
}

impl Renderer {
    /// Compiles the pipelines for pictures of this format.
    ///
    /// # Errors
    /// [`SceneError::Device`] if the device refuses a shader or a pipeline.
    pub(crate) async fn new(gpu: &Gpu, format: TextureFormat) -> Result<Self, SceneError> {
        let device = gpu.device.clone();
        let scope = device.push_error_scope(ErrorFilter::Validation);
        let four = gpu.adapter.get_texture_format_features(format).flags.sample_count_supported(4);
        let sample_count = if four { 4 } else { 1 };
        let pipelines = Pipelines::new(&device, format, sample_count);
        let (uniform, view_group) = view_binding(&device, &pipelines);
        let sphere = Sphere::new(&device, &gpu.queue);
        let field = Field::new(gpu, &pipelines.field_layout);
        if let Some(error) = scope.pop().await {
            return Err(SceneError::Device(error.to_string()));
        }
        Ok(Self {
            device,
            queue: gpu.queue.clone(),
            health: Arc::clone(&gpu.health),
            format,
            sample_count,
            pipelines,
            uniform,
            view_group,
            view: None,
            background: [1.0; 3],
            targets: None,
            sphere,
            field,
            triangles: Triangles::new(),
            ellipsoids: Plain::ellipsoids(),
            segments: Segments::new(),
            points: Plain::points(),
        })
    }

    /// Sets what is seen; nothing is drawn before the first call.
    pub(crate) fn set_view(&mut self, view: View) {
        self.queue.write_buffer(&self.uniform, 0, bytemuck::cast_slice(&view.uniform()));
        self.segments.view_changed();
        self.view = Some(view);
    }

    /// Sets the colour (sRGB) where nothing is drawn.
    pub(crate) fn set_background(&mut self, rgb: [f32; 3]) -> Result<(), SceneError> {
        let bad = rgb.iter().zip(["red", "green", "blue"]).find(|(value, _)| !(0.0..=1.0).contains(*value));
        if let Some((&value, component)) = bad {
            let (layout, allowed) = ("background", "a number from 0 to 1".into());
            return Err(SceneError::Value { layout, record: 0, component, value, allowed });
        }
        self.background = rgb;
        Ok(())
    }

    /// Replaces the triangles.
    pub(crate) fn set_triangles(&mut self, values: &[f32]) -> Result<(), SceneError> {
        self.triangles.set(&self.device, &self.queue, values)
    }

    /// Replaces the ellipsoids.
    pub(crate) fn set_ellipsoids(&mut self, values: &[f32]) -> Result<(), SceneError> {
        self.ellipsoids.set(&self.device, &self.queue, values)
    }

    /// Replaces the segments.
    pub(crate) fn set_segments(&mut self, values: &[f32]) -> Result<(), SceneError> {
        self.segments.set(&self.device, &self.queue, values)
    }

    /// Replaces the points.
    pub(crate) fn set_points(&mut self, values: &[f32]) -> Result<(), SceneError> {
        self.points.set(&self.device, &self.queue, values)
    }

    /// Draws one picture into `target`, which has this size and the format of the renderer.
    ///
    /// # Errors
    /// [`SceneError::Lost`], or [`SceneError::Device`] with what the device reported since the last picture.
    pub(crate) fn render(&mut self, target: &TextureView, size_px: (u32, u32)) -> Result<(), SceneError> {
        if self.health.is_lost() {
            return Err(SceneError::Lost);
        }
        if let Some(view) = &self.view {
            self.segments.update_phases(&self.device, &self.queue, view);
        }
        let targets = match self.targets.take() {
            Some(targets) if (targets.width_px, targets.height_px) == size_px => targets,
            _ => Targets::new(&self.device, self.format, self.sample_count, size_px),
        };
        let mut encoder = self.device.create_command_encoder(&CommandEncoderDescriptor::default());
        {
            let mut pass = self.begin(&mut encoder, &targets, target);
            if self.view.is_some() {
                pass.set_bind_group(0, &self.view_group, &[]);
                paint::everything(&mut pass, self);
            }
        }
        self.queue.submit([encoder.finish()]);
        self.targets = Some(targets);
        self.health.take_fault().map_or(Ok(()), Err)
    }

    fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        targets: &Targets,
        target: &TextureView,
    ) -> RenderPass<'e> {
        let [r, g, b] = self.background.map(f64::from);
        let (view, resolve_target, store) = match &targets.samples {
            Some(samples) => (samples, Some(target), StoreOp::Discard),
            None => (target, None, StoreOp::Store),
        };
        let colour = RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target,
            ops: Operations { load: LoadOp::Clear(Color { r, g, b, a: 1.0 }), store },
        };
        let depth = RenderPassDepthStencilAttachment {
            view: &targets.depth,
            depth_ops: Some(Operations { load: LoadOp::Clear(1.0), store: StoreOp::Discard }),
            stencil_ops: None,
        };
        encoder.begin_render_pass(&RenderPassDescriptor {
            label: Some("scene"),
            color_attachments: &[Some(colour)],
            depth_stencil_attachment: Some(depth),
            ..RenderPassDescriptor::default()
        })
    }
}

fn view_binding(device: &Device, pipelines: &Pipelines) -> (Buffer, BindGroup) {
    let uniform = device.create_buffer(&BufferDescriptor {
        label: Some("view"),
        size: size_of::<[f32; 24]>() as u64,
        usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let entries = [BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() }];
    let descriptor =
        BindGroupDescriptor { label: Some("view"), layout: &pipelines.view_layout, entries: &entries };
    let view_group = device.create_bind_group(&descriptor);
    (uniform, view_group)
}
