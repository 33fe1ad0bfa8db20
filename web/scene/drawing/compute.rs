//! Runs a kernel from outside that fills a grid. The kernel knows what the numbers mean; nothing here does.

use std::sync::{Arc, OnceLock};

use wgpu::{
    BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry,
    BindingResource, BindingType, BufferBindingType, BufferDescriptor, BufferUsages,
    CommandEncoderDescriptor, ComputePassDescriptor, ComputePipeline, ComputePipelineDescriptor, Device,
    ErrorFilter, Limits, PipelineCompilationOptions, PipelineLayout, PipelineLayoutDescriptor, Queue,
    ShaderModuleDescriptor, ShaderSource, ShaderStages, StorageTextureAccess, TextureFormat, TextureView,
    TextureViewDimension,
};

use crate::data::MAX_RECORDS;
use crate::error::SceneError;

/// Columns and rows that one workgroup fills.
const WORKGROUP: u32 = 8;

/// A kernel, once one was accepted, and what it reads.
pub(crate) struct Compute {
    layout: BindGroupLayout,
    pipeline_layout: PipelineLayout,
    /// Filled when the device has accepted the kernel set last.
    pipeline: Arc<OnceLock<ComputePipeline>>,
}

impl Compute {
    /// None on a device that cannot run a kernel.
    pub(crate) fn new(device: &Device) -> Option<Self> {
        if !suffices(&device.limits()) {
            return None;
        }
        let layout = layout(device);
        let pipeline_layout = device.create_pipeline_layout(&PipelineLayoutDescriptor {
            label: Some("field kernel"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        Some(Self { layout, pipeline_layout, pipeline: Arc::default() })
    }

    /// Compiles a kernel in place of the one before; the future says whether the device accepts it.
    pub(crate) fn set_kernel(
        &mut self,
        device: &Device,
        wgsl: &str,
    ) -> impl Future<Output = Result<(), SceneError>> + use<> {
        let scope = device.push_error_scope(ErrorFilter::Validation);
        let label = Some("field kernel");
        let source = ShaderSource::Wgsl(wgsl.to_owned().into());
        let module = device.create_shader_module(ShaderModuleDescriptor { label, source });
        let pipeline = device.create_compute_pipeline(&ComputePipelineDescriptor {
            label,
            layout: Some(&self.pipeline_layout),
            module: &module,
            entry_point: Some("main"),
            compilation_options: PipelineCompilationOptions::default(),
            cache: None,
        });
        let fault = scope.pop();
        // A place of its own: of two kernels set in a row the later one stays, whichever compiles first.
        self.pipeline = Arc::default();
        let place = Arc::clone(&self.pipeline);
        async move {
            if let Some(error) = fault.await {
                return Err(SceneError::Kernel(error.to_string()));
            }
            place.get_or_init(|| pipeline);
            Ok(())
        }
    }

    /// Submits one run of the kernel over a grid of this size.
    ///
    /// # Errors
    /// [`SceneError::FineField`] without a kernel or without parameters.
    pub(crate) fn run(
        &self,
        device: &Device,
        queue: &Queue,
        parameters: &[f32],
        grid: &TextureView,
        size: [u32; 2],
    ) -> Result<(), SceneError> {
        let pipeline = self.pipeline.get().ok_or(SceneError::FineField("no kernel was accepted yet"))?;
        if parameters.is_empty() {
            return Err(SceneError::FineField("the kernel has no parameters to read"));
        }
        let buffer = device.create_buffer(&BufferDescriptor {
            label: Some("field parameters"),
            size: size_of_val(parameters) as u64,
            usage: BufferUsages::STORAGE | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&buffer, 0, bytemuck::cast_slice(parameters));
        let group = device.create_bind_group(&BindGroupDescriptor {
            label: Some("field kernel"),
            layout: &self.layout,
            entries: &[
                BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() },
                BindGroupEntry { binding: 1, resource: BindingResource::TextureView(grid) },
            ],
        });
        let mut encoder = device.create_command_encoder(&CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor::default());
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &group, &[]);
            let [columns, rows] = size.map(|cells| cells.div_ceil(WORKGROUP));
            pass.dispatch_workgroups(columns, rows, 1);
        }
        queue.submit([encoder.finish()]);
        Ok(())
    }
}

/// Whether a device with these limits runs kernels on as many numbers as one may set and into every grid it can hold.
fn suffices(limits: &Limits) -> bool {
    limits.max_storage_buffers_per_shader_stage > 0
        && limits.max_storage_textures_per_shader_stage > 0
        && limits.max_storage_buffer_binding_size >= (size_of::<f32>() * MAX_RECORDS) as u64
        && limits.max_compute_workgroup_size_x.min(limits.max_compute_workgroup_size_y) >= WORKGROUP
        && limits.max_compute_invocations_per_workgroup >= WORKGROUP * WORKGROUP
        && limits.max_compute_workgroups_per_dimension >= limits.max_texture_dimension_2d.div_ceil(WORKGROUP)
}

fn layout(device: &Device) -> BindGroupLayout {
    let parameters = BindingType::Buffer {
        ty: BufferBindingType::Storage { read_only: true },
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let values = BindingType::StorageTexture {
        access: StorageTextureAccess::WriteOnly,
        format: TextureFormat::R32Float,
        view_dimension: TextureViewDimension::D2,
    };
    let entry = |binding, ty| {
        let visibility = ShaderStages::COMPUTE;
        BindGroupLayoutEntry { binding, visibility, ty, count: None }
    };
    device.create_bind_group_layout(&BindGroupLayoutDescriptor {
        label: Some("field kernel"),
        entries: &[entry(0, parameters), entry(1, values)],
    })
}
