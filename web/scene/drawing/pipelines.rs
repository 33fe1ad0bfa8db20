//! How each kind of shape is drawn: shader, vertex layout, blending and depth.

use wgpu::{
    BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry, BindingType, BlendState,
    BufferBindingType, ColorTargetState, ColorWrites, CompareFunction, DepthStencilState, Device,
    FragmentState, MultisampleState, PipelineLayout, PipelineLayoutDescriptor, PrimitiveState,
    RenderPipeline, RenderPipelineDescriptor, ShaderModule, ShaderModuleDescriptor, ShaderSource,
    ShaderStages, TextureFormat, TextureSampleType, TextureViewDimension, VertexAttribute,
    VertexBufferLayout, VertexState, VertexStepMode, vertex_attr_array,
};

use crate::data::{ELLIPSOIDS, POINTS, SEGMENTS, TRIANGLES};

/// Depth format, offered with multisampling by WebGPU and WebGL 2 alike.
pub(crate) const DEPTH_FORMAT: TextureFormat = TextureFormat::Depth24Plus;

/// Everything that can be drawn.
pub(crate) struct Pipelines {
    pub(crate) view_layout: BindGroupLayout,
    pub(crate) field_layout: BindGroupLayout,
    pub(crate) field: RenderPipeline,
    pub(crate) opaque_triangles: RenderPipeline,
    pub(crate) translucent_triangles: RenderPipeline,
    pub(crate) ellipsoids: RenderPipeline,
    pub(crate) segments: RenderPipeline,
    pub(crate) points: RenderPipeline,
}

macro_rules! shader {
    ($file:literal) => {
        concat!(include_str!("../shaders/common.wgsl"), include_str!(concat!("../shaders/", $file)))
    };
}

const TRIANGLE: [VertexAttribute; 3] = vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4];
const SPHERE: [VertexAttribute; 1] = vertex_attr_array![0 => Float32x3];
const ELLIPSOID: [VertexAttribute; 5] =
    vertex_attr_array![1 => Float32x3, 2 => Float32x3, 3 => Float32x3, 4 => Float32x3, 5 => Float32x4];
const POINT: [VertexAttribute; 4] =
    vertex_attr_array![0 => Float32x3, 1 => Float32, 2 => Float32x4, 3 => Float32];
const SEGMENT: [VertexAttribute; 6] = vertex_attr_array![
    0 => Float32x3, 1 => Float32x3, 2 => Float32, 3 => Float32, 4 => Float32x4, 5 => Float32
];
const BEFORE: [VertexAttribute; 3] = vertex_attr_array![6 => Float32x3, 7 => Float32x3, 8 => Float32];
const AFTER: [VertexAttribute; 3] = vertex_attr_array![9 => Float32x3, 10 => Float32x3, 11 => Float32];
const PHASE: [VertexAttribute; 1] = vertex_attr_array![12 => Float32];

fn buffer(
    stride: usize,
    step_mode: VertexStepMode,
    attributes: &[VertexAttribute],
) -> VertexBufferLayout<'_> {
    VertexBufferLayout { array_stride: (stride * size_of::<f32>()) as u64, step_mode, attributes }
}

/// What the pipelines have in common.
struct Maker<'a> {
    device: &'a Device,
    layout: PipelineLayout,
    format: TextureFormat,
    sample_count: u32,
}

/// What they differ in.
struct Kind<'a> {
    /// Its entry points are `<name>_vertex` and `<name>_fragment`.
    name: &'a str,
    module: &'a ShaderModule,
    buffers: &'a [VertexBufferLayout<'a>],
    hides_what_is_behind: bool,
}

impl Pipelines {
    /// Compiles all pipelines for pictures of this format.
    pub(crate) fn new(device: &Device, format: TextureFormat, sample_count: u32) -> Self {
        let view_layout = view_layout(device);
        let field_layout = field_layout(device);
        let layout = pipeline_layout(device, &[Some(&view_layout)]);
        let maker = Maker { device, layout, format, sample_count };
        let [opaque_triangles, translucent_triangles] = maker.triangles();
        let (ellipsoids, segments, points) = (maker.ellipsoids(), maker.segments(), maker.points());
        let layout = pipeline_layout(device, &[Some(&view_layout), Some(&field_layout)]);
        let field = Maker { layout, ..maker }.field();
        Self {
            view_layout,
            field_layout,
            field,
            opaque_triangles,
            translucent_triangles,
            ellipsoids,
            segments,
            points,
        }
    }
}

fn pipeline_layout(device: &Device, groups: &[Option<&BindGroupLayout>]) -> PipelineLayout {
    device.create_pipeline_layout(&PipelineLayoutDescriptor {
        label: Some("scene"),
        bind_group_layouts: groups,
        immediate_size: 0,
    })
}

const UNIFORM: BindingType =
    BindingType::Buffer { ty: BufferBindingType::Uniform, has_dynamic_offset: false, min_binding_size: None };

/// A grid of numbers that shaders load without filtering, which not every device can do.
const GRID: BindingType = BindingType::Texture {
    sample_type: TextureSampleType::Float { filterable: false },
    view_dimension: TextureViewDimension::D2,
    multisampled: false,
};

fn entry(binding: u32, ty: BindingType) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry { binding, visibility: ShaderStages::VERTEX_FRAGMENT, ty, count: None }
}

fn view_layout(device: &Device) -> BindGroupLayout {
    let entries = &[entry(0, UNIFORM)];
    device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some("view"), entries })
}

fn field_layout(device: &Device) -> BindGroupLayout {
    let entries = &[entry(0, UNIFORM), entry(1, GRID), entry(2, GRID)];
    device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some("field"), entries })
}

impl Maker<'_> {
    fn field(&self) -> RenderPipeline {
        let module = &self.module(shader!("field.wgsl"));
        self.pipeline(&Kind { name: "field", module, buffers: &[], hides_what_is_behind: false })
    }

    fn triangles(&self) -> [RenderPipeline; 2] {
        let module = self.module(shader!("triangles.wgsl"));
        let buffers = [buffer(TRIANGLES.stride(), VertexStepMode::Vertex, &TRIANGLE)];
        [true, false].map(|hides_what_is_behind| {
            self.pipeline(&Kind {
                name: "triangle",
                module: &module,
                buffers: &buffers,
                hides_what_is_behind,
            })
        })
    }

    fn ellipsoids(&self) -> RenderPipeline {
        let module = self.module(shader!("ellipsoids.wgsl"));
        let buffers = [
            buffer(3, VertexStepMode::Vertex, &SPHERE),
            buffer(ELLIPSOIDS.stride(), VertexStepMode::Instance, &ELLIPSOID),
        ];
        let (module, buffers) = (&module, &buffers[..]);
        self.pipeline(&Kind { name: "ellipsoid", module, buffers, hides_what_is_behind: false })
    }

    fn segments(&self) -> RenderPipeline {
        let module = self.module(shader!("segments.wgsl"));
        let stride = SEGMENTS.stride();
        let buffers = [
            buffer(stride, VertexStepMode::Instance, &SEGMENT),
            buffer(stride, VertexStepMode::Instance, &BEFORE),
            buffer(stride, VertexStepMode::Instance, &AFTER),
            buffer(1, VertexStepMode::Instance, &PHASE),
        ];
        let (module, buffers) = (&module, &buffers[..]);
        self.pipeline(&Kind { name: "segment", module, buffers, hides_what_is_behind: false })
    }

    fn points(&self) -> RenderPipeline {
        let module = self.module(shader!("points.wgsl"));
        let buffers = [buffer(POINTS.stride(), VertexStepMode::Instance, &POINT)];
        let (module, buffers) = (&module, &buffers[..]);
        self.pipeline(&Kind { name: "point", module, buffers, hides_what_is_behind: false })
    }

    fn module(&self, source: &'static str) -> ShaderModule {
        self.device.create_shader_module(ShaderModuleDescriptor {
            label: None,
            source: ShaderSource::Wgsl(source.into()),
        })
    }

    fn pipeline(&self, kind: &Kind) -> RenderPipeline {
        let target = ColorTargetState {
            format: self.format,
            blend: Some(BlendState::ALPHA_BLENDING),
            write_mask: ColorWrites::ALL,
        };
        let buffers: Vec<_> = kind.buffers.iter().cloned().map(Some).collect();
        let (vertex_entry, fragment_entry) =
            (format!("{}_vertex", kind.name), format!("{}_fragment", kind.name));
        self.device.create_render_pipeline(&RenderPipelineDescriptor {
            label: Some(kind.name),
            layout: Some(&self.layout),
            vertex: VertexState {
                module: kind.module,
                entry_point: Some(&vertex_entry),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &buffers,
            },
            primitive: PrimitiveState::default(),
            depth_stencil: Some(DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(kind.hides_what_is_behind),
                depth_compare: Some(CompareFunction::LessEqual),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: MultisampleState { count: self.sample_count, ..MultisampleState::default() },
            fragment: Some(FragmentState {
                module: kind.module,
                entry_point: Some(&fragment_entry),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
