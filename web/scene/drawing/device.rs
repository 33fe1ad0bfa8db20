//! Opening a graphics device, and hearing of its troubles without a panic.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use wgpu::{
    Adapter, Backends, Device, DeviceDescriptor, GlFenceBehavior, Instance, InstanceDescriptor, Limits,
    MemoryHints, PowerPreference, Queue, RequestAdapterOptions, Surface,
};

use crate::error::SceneError;

/// What the device reported since it was opened.
#[derive(Default)]
pub(crate) struct Health {
    lost: AtomicBool,
    fault: Mutex<Option<String>>,
}

impl Health {
    /// Whether the device is gone for good.
    pub(crate) fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Relaxed)
    }

    /// Notes that the device is gone.
    pub(crate) fn set_lost(&self) {
        self.lost.store(true, Ordering::Relaxed);
    }

    /// The first error reported since the last call, if any.
    pub(crate) fn take_fault(&self) -> Option<SceneError> {
        let mut fault = self.fault.lock().unwrap_or_else(PoisonError::into_inner);
        fault.take().map(SceneError::Device)
    }

    fn report(&self, message: String) {
        let mut fault = self.fault.lock().unwrap_or_else(PoisonError::into_inner);
        fault.get_or_insert(message);
    }
}

/// An instance for exactly the backend that this build was made for.
pub(crate) fn instance() -> Instance {
    let mut descriptor = InstanceDescriptor::new_without_display_handle();
    descriptor.backends = if cfg!(not(target_arch = "wasm32")) {
        Backends::VULKAN
    } else if cfg!(feature = "webgpu") {
        Backends::BROWSER_WEBGPU
    } else {
        Backends::GL
    };
    // WebGL copies what it is given at once: staging memory need not wait until a slow card has drawn.
    descriptor.backend_options.gl.fence_behavior = GlFenceBehavior::AutoFinish;
    Instance::new(descriptor)
}

/// An open device with its queue.
pub(crate) struct Gpu {
    pub(crate) adapter: Adapter,
    pub(crate) device: Device,
    pub(crate) queue: Queue,
    pub(crate) health: Arc<Health>,
}

impl Gpu {
    /// Opens the adapter that can draw on `surface` (any adapter without one), with what it has for `compute` if asked.
    pub(crate) async fn open(
        instance: &Instance,
        surface: Option<&Surface<'_>>,
        compute: bool,
    ) -> Result<Self, SceneError> {
        let options = RequestAdapterOptions {
            power_preference: PowerPreference::None,
            force_fallback_adapter: false,
            compatible_surface: surface,
            apply_limit_buckets: false,
        };
        let no_device = |reason: &dyn std::fmt::Display| SceneError::Device(reason.to_string());
        let adapter = instance.request_adapter(&options).await.map_err(|error| no_device(&error))?;
        let descriptor = DeviceDescriptor {
            label: Some("scene"),
            required_limits: limits(&adapter.limits(), compute),
            memory_hints: MemoryHints::MemoryUsage,
            ..DeviceDescriptor::default()
        };
        let (device, queue) = adapter.request_device(&descriptor).await.map_err(|error| no_device(&error))?;
        let health = Arc::new(Health::default());
        let (on_lost, on_error) = (Arc::clone(&health), Arc::clone(&health));
        device.set_device_lost_callback(move |_, _| on_lost.set_lost());
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| on_error.report(error.to_string())));
        Ok(Self { adapter, device, queue, health })
    }
}

/// Drawing needs no more than WebGL 2 offers, except pictures as large as the adapter can draw; computing takes what there
/// is.
fn limits(adapter: &Limits, compute: bool) -> Limits {
    let drawing = Limits::downlevel_webgl2_defaults().using_resolution(adapter.clone());
    if !compute {
        return drawing;
    }
    Limits {
        max_storage_buffers_per_shader_stage: adapter.max_storage_buffers_per_shader_stage,
        max_storage_textures_per_shader_stage: adapter.max_storage_textures_per_shader_stage,
        max_storage_buffer_binding_size: adapter.max_storage_buffer_binding_size,
        max_compute_workgroup_storage_size: adapter.max_compute_workgroup_storage_size,
        max_compute_invocations_per_workgroup: adapter.max_compute_invocations_per_workgroup,
        max_compute_workgroup_size_x: adapter.max_compute_workgroup_size_x,
        max_compute_workgroup_size_y: adapter.max_compute_workgroup_size_y,
        max_compute_workgroup_size_z: adapter.max_compute_workgroup_size_z,
        max_compute_workgroups_per_dimension: adapter.max_compute_workgroups_per_dimension,
        ..drawing
    }
}
