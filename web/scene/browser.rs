//! The scene on a canvas of the page.

mod field;

use std::sync::Arc;

use js_sys::Float32Array;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsError};
use web_sys::HtmlCanvasElement;
use wgpu::{
    CompositeAlphaMode, CurrentSurfaceTexture, PresentMode, Surface, SurfaceColorSpace, SurfaceConfiguration,
    SurfaceTarget, SurfaceTexture, TextureFormat, TextureUsages, TextureViewDescriptor,
};

use crate::data::{ELLIPSOIDS, Layout, POINTS, SEGMENTS, TRIANGLES};
use crate::drawing::device::{self, Gpu};
use crate::drawing::renderer::Renderer;
use crate::error::SceneError;
use crate::field::FieldData;
use crate::view::View;

/// Draws on one canvas until it is freed or the device is lost.
#[wasm_bindgen]
pub struct Scene {
    gpu: Gpu,
    surface: Surface<'static>,
    format: TextureFormat,
    size_px: (u32, u32),
    renderer: Renderer,
    incoming: Vec<f32>,
    incoming_field: FieldData,
    #[expect(dead_code, reason = "kept so that the canvas is listened to as long as the scene lives")]
    context_loss: ContextLoss,
}

#[wasm_bindgen]
impl Scene {
    /// Opens a graphics device for a canvas that has no other context yet.
    ///
    /// # Errors
    /// A sentence for the reader if the browser offers no adapter or the canvas cannot be drawn on.
    pub async fn create(canvas: HtmlCanvasElement) -> Result<Scene, JsError> {
        console_error_panic_hook::set_once();
        let instance = device::instance();
        let no_surface = |error: wgpu::CreateSurfaceError| SceneError::Device(error.to_string());
        let surface = instance.create_surface(SurfaceTarget::Canvas(canvas.clone())).map_err(no_surface)?;
        let gpu = Gpu::open(&instance, Some(&surface), cfg!(feature = "webgpu")).await?;
        let capabilities = surface.get_capabilities(&gpu.adapter);
        // The shaders encode sRGB themselves, because canvases of WebGPU cannot.
        let format = capabilities.formats.into_iter().find(|format| !format.is_srgb());
        let format = format.ok_or_else(|| SceneError::Device("the canvas offers no plain format".into()))?;
        let renderer = Renderer::new(&gpu, format).await?;
        let context_loss = ContextLoss::listen(canvas, &gpu)?;
        Ok(Self {
            gpu,
            surface,
            format,
            size_px: (0, 0),
            renderer,
            incoming: Vec::new(),
            incoming_field: FieldData::default(),
            context_loss,
        })
    }

    /// What draws: `"WebGPU"` or `"WebGL2"`.
    pub fn backend(&self) -> String {
        let backend = self.gpu.adapter.get_info().backend;
        if backend == wgpu::Backend::BrowserWebGpu { "WebGPU".into() } else { "WebGL2".into() }
    }

    /// Sets the size of the canvas in physical pixels; with a zero, nothing is drawn until the next size.
    ///
    /// # Errors
    /// If the device cannot draw so large a picture; the old size is kept.
    pub fn resize(&mut self, width_px: u32, height_px: u32) -> Result<(), JsError> {
        let limit_px = self.gpu.device.limits().max_texture_dimension_2d;
        if width_px.max(height_px) > limit_px {
            return Err(SceneError::Size { width_px, height_px, limit_px }.into());
        }
        if self.size_px != (width_px, height_px) {
            self.size_px = (width_px, height_px);
            self.configure();
        }
        Ok(())
    }

    /// Sets what is seen: a column-major 4 x 4 matrix from the world to clip coordinates with depth 0 (near) to 1 (far),
    /// and the size in physical pixels in which widths and radii are measured.
    ///
    /// # Errors
    /// If the numbers are not a view; the old one is kept.
    pub fn set_view(
        &mut self,
        view_projection: &Float32Array,
        width_px: f32,
        height_px: f32,
    ) -> Result<(), JsError> {
        let matrix = view_projection.to_vec();
        self.renderer.set_view(View::new(&matrix, width_px, height_px)?);
        Ok(())
    }

    /// Sets the colour where nothing is drawn, sRGB in 0..1.
    ///
    /// # Errors
    /// If a number is outside; the old colour is kept.
    pub fn set_background(&mut self, red: f32, green: f32, blue: f32) -> Result<(), JsError> {
        Ok(self.renderer.set_background([red, green, blue])?)
    }

    /// Replaces all segments, 13 numbers each: start xyz, end xyz, `width_px`, `dash_px`, rgba, overlay.
    ///
    /// # Errors
    /// A sentence that names the first bad number; the old segments are kept. So for the other shapes.
    pub fn set_segments(&mut self, segments: &Float32Array) -> Result<(), JsError> {
        copy(segments, &SEGMENTS, &mut self.incoming)?;
        Ok(self.renderer.set_segments(&self.incoming)?)
    }

    /// Replaces all points, 9 numbers each: xyz, `radius_px`, rgba, shape.
    pub fn set_points(&mut self, points: &Float32Array) -> Result<(), JsError> {
        copy(points, &POINTS, &mut self.incoming)?;
        Ok(self.renderer.set_points(&self.incoming)?)
    }

    /// Replaces all ellipsoids, 16 numbers each: centre xyz, three semi-axis vectors, rgba.
    pub fn set_ellipsoids(&mut self, ellipsoids: &Float32Array) -> Result<(), JsError> {
        copy(ellipsoids, &ELLIPSOIDS, &mut self.incoming)?;
        Ok(self.renderer.set_ellipsoids(&self.incoming)?)
    }

    /// Replaces all triangles, 10 numbers a vertex: xyz, normal xyz (zero: unshaded), rgba.
    pub fn set_triangles(&mut self, triangles: &Float32Array) -> Result<(), JsError> {
        copy(triangles, &TRIANGLES, &mut self.incoming)?;
        Ok(self.renderer.set_triangles(&self.incoming)?)
    }

    /// Draws one picture.
    ///
    /// # Errors
    /// If the device is lost or refused a command.
    pub fn render(&mut self) -> Result<(), JsError> {
        if self.size_px.0 == 0 || self.size_px.1 == 0 {
            return Ok(());
        }
        let Some(texture) = self.next_texture()? else { return Ok(()) };
        let view = texture.texture.create_view(&TextureViewDescriptor::default());
        let drawn = self.renderer.render(&view, self.size_px);
        self.gpu.queue.present(texture);
        Ok(drawn?)
    }

    /// Whether the device is lost: free this scene and create another one, on a new canvas element.
    pub fn lost(&self) -> bool {
        self.gpu.health.is_lost()
    }
}

impl Scene {
    fn configure(&self) {
        let (width, height) = self.size_px;
        if width == 0 || height == 0 {
            return;
        }
        let configuration = SurfaceConfiguration {
            usage: TextureUsages::RENDER_ATTACHMENT,
            format: self.format,
            color_space: SurfaceColorSpace::Auto,
            width,
            height,
            present_mode: PresentMode::AutoVsync,
            desired_maximum_frame_latency: 2,
            alpha_mode: CompositeAlphaMode::Opaque,
            view_formats: Vec::new(),
        };
        self.surface.configure(&self.gpu.device, &configuration);
    }

    /// The texture of the canvas, or none while it cannot be shown anyway.
    fn next_texture(&self) -> Result<Option<SurfaceTexture>, SceneError> {
        if self.gpu.health.is_lost() {
            return Err(SceneError::Lost);
        }
        match self.surface.get_current_texture() {
            CurrentSurfaceTexture::Success(texture) | CurrentSurfaceTexture::Suboptimal(texture) => {
                Ok(Some(texture))
            }
            CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => Ok(None),
            CurrentSurfaceTexture::Outdated => {
                self.configure();
                Ok(None)
            }
            CurrentSurfaceTexture::Lost => {
                self.gpu.health.set_lost();
                Err(SceneError::Lost)
            }
            CurrentSurfaceTexture::Validation => {
                let unknown = || SceneError::Device("the canvas gave no texture to draw on".into());
                Err(self.gpu.health.take_fault().unwrap_or_else(unknown))
            }
        }
    }
}

/// Copies numbers of the page into a buffer that is kept, so that equal sizes allocate nothing.
fn copy(from: &Float32Array, layout: &Layout, into: &mut Vec<f32>) -> Result<(), SceneError> {
    let length = from.length() as usize;
    layout.check_length(length)?;
    into.resize(length, 0.0);
    from.copy_to(into);
    Ok(())
}

/// Hears when a WebGL context is lost, which wgpu does not report.
struct ContextLoss {
    canvas: HtmlCanvasElement,
    listener: Closure<dyn FnMut()>,
}

const CONTEXT_LOST: &str = "webglcontextlost";

impl ContextLoss {
    fn listen(canvas: HtmlCanvasElement, gpu: &Gpu) -> Result<Self, SceneError> {
        let health = Arc::clone(&gpu.health);
        let listener = Closure::<dyn FnMut()>::new(move || health.set_lost());
        canvas
            .add_event_listener_with_callback(CONTEXT_LOST, listener.as_ref().unchecked_ref())
            .map_err(|_| SceneError::Device("the canvas takes no listener".into()))?;
        Ok(Self { canvas, listener })
    }
}

impl Drop for ContextLoss {
    fn drop(&mut self) {
        // Nothing is left to do if the canvas refuses: the listener only sets a flag.
        self.canvas
            .remove_event_listener_with_callback(CONTEXT_LOST, self.listener.as_ref().unchecked_ref())
            .ok();
    }
}
