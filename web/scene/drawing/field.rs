//! The field on the graphics card: its grid from outside, and a finer one that a kernel filled.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use futures_channel::oneshot;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindingResource, Buffer,
    BufferDescriptor, BufferUsages, Device, ErrorFilter, Extent3d, Queue, TexelCopyBufferLayout, Texture,
    TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView, TextureViewDescriptor,
};

use super::compute::Compute;
use super::device::{Gpu, Health};
use super::readback;
use crate::data::FIELD_PARAMETERS;
use crate::error::SceneError;
use crate::field::FieldData;

const CANNOT_COMPUTE: SceneError = SceneError::FineField("this device draws but cannot compute");

/// What is drawn of the field, if anything.
pub(crate) struct Field {
    device: Device,
    queue: Queue,
    health: Arc<Health>,
    layout: BindGroupLayout,
    uniform: Buffer,
    rectangle: Vec<f32>,
    coarse: Option<Texture>,
    fine: Option<Fine>,
    /// One cell that is not resolved: stands in for the fine grid.
    unresolved: Texture,
    compute: Option<Compute>,
}

struct Fine {
    grid: Texture,
    /// Set once the device has refused to fill it.
    refused: Arc<AtomicBool>,
}

impl Field {
    /// No field yet; `layout` is that of its pipeline.
    pub(crate) fn new(gpu: &Gpu, layout: &BindGroupLayout) -> Self {
        let (device, queue) = (gpu.device.clone(), gpu.queue.clone());
        let uniform = device.create_buffer(&BufferDescriptor {
            label: Some("field"),
            size: size_of::<[f32; 88]>() as u64,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let unresolved = grid(&device, 1, 1, TextureUsages::COPY_DST);
        write(&queue, &unresolved, &[-1.0]);
        Self {
            compute: Compute::new(&device),
            device,
            queue,
            health: Arc::clone(&gpu.health),
            layout: layout.clone(),
            uniform,
            rectangle: Vec::new(),
            coarse: None,
            fine: None,
            unresolved,
        }
    }

    /// Replaces the field; its fine grid stays if the rectangle does.
    pub(crate) fn set(&mut self, data: &FieldData) -> Result<(), SceneError> {
        data.check()?;
        if data.is_empty() {
            (self.coarse, self.fine) = (None, None);
            return Ok(());
        }
        check_size(&self.device, data.width, data.height)?;
        if data.rectangle != self.rectangle {
            self.fine = None;
            self.rectangle.clone_from(&data.rectangle);
        }
        self.queue.write_buffer(&self.uniform, 0, bytemuck::cast_slice(&data.uniform()));
        let old =
            self.coarse.take().filter(|grid| (grid.width(), grid.height()) == (data.width, data.height));
        let grid =
            old.unwrap_or_else(|| grid(&self.device, data.width, data.height, TextureUsages::COPY_DST));
        write(&self.queue, &grid, &data.values);
        self.coarse = Some(grid);
        Ok(())
    }

    /// What binds the field for drawing, if there is one.
    pub(crate) fn group(&self) -> Option<BindGroup> {
        let fine = self.fine.as_ref().filter(|fine| !fine.refused.load(Ordering::Relaxed));
        let coarse = view(self.coarse.as_ref()?);
        let fine = view(fine.map_or(&self.unresolved, |fine| &fine.grid));
        let entry = |binding, resource| BindGroupEntry { binding, resource };
        Some(self.device.create_bind_group(&BindGroupDescriptor {
            label: Some("field"),
            layout: &self.layout,
            entries: &[
                entry(0, self.uniform.as_entire_binding()),
                entry(1, BindingResource::TextureView(&coarse)),
                entry(2, BindingResource::TextureView(&fine)),
            ],
        }))
    }

    /// Whether kernels can run on this device.
    pub(crate) fn can_compute(&self) -> bool {
        self.compute.is_some()
    }

    /// Compiles the kernel that fills fine grids; the one before and its grid are dropped.
    ///
    /// # Errors
    /// Of the future: [`SceneError::Kernel`] with the compiler's message; there is then no kernel.
    pub(crate) fn set_kernel(
        &mut self,
        wgsl: &str,
    ) -> Result<impl Future<Output = Result<(), SceneError>> + use<>, SceneError> {
        let compute = self.compute.as_mut().ok_or(CANNOT_COMPUTE)?;
        self.fine = None;
        Ok(compute.set_kernel(&self.device, wgsl))
    }

    /// Lets the kernel fill a fine grid, which is drawn from now on; the future waits until it is filled.
    ///
    /// # Errors
    /// [`SceneError::FineField`] without a field or a kernel, or for bad numbers and sizes theirs. Of the future: what
    /// the device reported; the fine grid is then not drawn.
    pub(crate) fn compute(
        &mut self,
        parameters: &[f32],
        width: u32,
        height: u32,
    ) -> Result<impl Future<Output = Result<(), SceneError>> + use<>, SceneError> {
        let compute = self.compute.as_ref().ok_or(CANNOT_COMPUTE)?;
        FIELD_PARAMETERS.check(parameters)?;
        check_size(&self.device, width, height)?;
        if self.coarse.is_none() {
            return Err(SceneError::FineField("there is no field to refine"));
        }
        let scope = self.device.push_error_scope(ErrorFilter::Validation);
        let usage = TextureUsages::STORAGE_BINDING | TextureUsages::COPY_SRC;
        let grid = grid(&self.device, width, height, usage);
        compute.run(&self.device, &self.queue, parameters, &view(&grid), [width, height])?;
        let fault = scope.pop();
        let (sender, done) = oneshot::channel();
        self.queue.on_submitted_work_done(move || {
            // Nobody listens any more when the future was dropped.
            sender.send(()).ok();
        });
        let refused = Arc::new(AtomicBool::new(false));
        self.fine = Some(Fine { grid, refused: Arc::clone(&refused) });
        let health = Arc::clone(&self.health);
        Ok(async move {
            if let Some(error) = fault.await {
                refused.store(true, Ordering::Relaxed);
                return Err(SceneError::Kernel(error.to_string()));
            }
            done.await.map_err(|_| SceneError::Lost)?;
            if health.is_lost() { Err(SceneError::Lost) } else { Ok(()) }
        })
    }

    /// Draws only the coarse grid from now on.
    pub(crate) fn drop_fine(&mut self) {
        self.fine = None;
    }

    /// The numbers of the fine grid, row by row.
    ///
    /// # Errors
    /// [`SceneError::FineField`] if there is none.
    pub(crate) fn read_fine(
        &self,
    ) -> Result<impl Future<Output = Result<Vec<f32>, SceneError>> + use<>, SceneError> {
        let fine = self.fine.as_ref().ok_or(SceneError::FineField("none was computed for this rectangle"))?;
        let bytes = readback::texels(&self.device, &self.queue, &fine.grid);
        Ok(async move { Ok(bytes.await?.as_chunks().0.iter().copied().map(f32::from_le_bytes).collect()) })
    }
}

fn check_size(device: &Device, width: u32, height: u32) -> Result<(), SceneError> {
    let limit = device.limits().max_texture_dimension_2d;
    if width.min(height) == 0 || width.max(height) > limit {
        return Err(SceneError::Grid { width, height, limit });
    }
    Ok(())
}

fn view(grid: &Texture) -> TextureView {
    grid.create_view(&TextureViewDescriptor::default())
}

fn grid(device: &Device, width: u32, height: u32, usage: TextureUsages) -> Texture {
    device.create_texture(&TextureDescriptor {
        label: Some("field"),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: TextureFormat::R32Float,
        usage: usage | TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    })
}

fn write(queue: &Queue, grid: &Texture, values: &[f32]) {
    let layout =
        TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * grid.width()), rows_per_image: None };
    queue.write_texture(grid.as_image_copy(), bytemuck::cast_slice(values), layout, grid.size());
}
