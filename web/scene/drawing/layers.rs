//! What is being drawn: the checked arrays, arranged for drawing and copied to the graphics card.

use wgpu::{Device, Queue};

use super::buffers::GrowingBuffer;
use super::sphere;
use crate::dash;
use crate::data::{ELLIPSOIDS, Layout, POINTS, SEGMENTS, TRIANGLES};
use crate::error::SceneError;
use crate::view::View;

/// Triangles: the opaque ones first, since they hide what is behind them.
pub(crate) struct Triangles {
    pub(crate) buffer: GrowingBuffer,
    pub(crate) opaque: u32,
    pub(crate) total: u32,
    sorted: Vec<f32>,
}

/// Records that are drawn as they came: points and ellipsoids.
pub(crate) struct Plain {
    layout: &'static Layout,
    pub(crate) buffer: GrowingBuffer,
    pub(crate) total: u32,
}

/// Segments between two blank records (so that each has neighbours), those of the overlay last.
pub(crate) struct Segments {
    pub(crate) buffer: GrowingBuffer,
    pub(crate) phases: GrowingBuffer,
    pub(crate) normal: u32,
    pub(crate) total: u32,
    padded: Vec<f32>,
    phase_px: Vec<f32>,
    stale: bool,
}

/// The mesh of the unit sphere.
pub(crate) struct Sphere {
    pub(crate) vertices: GrowingBuffer,
    pub(crate) indices: GrowingBuffer,
    pub(crate) index_count: u32,
}

/// Records are limited to 2^20, so that counts fit.
fn count(records: usize) -> u32 {
    u32::try_from(records).unwrap_or(u32::MAX)
}

impl Triangles {
    pub(crate) fn new() -> Self {
        Self { buffer: GrowingBuffer::vertices("triangles"), opaque: 0, total: 0, sorted: Vec::new() }
    }

    pub(crate) fn set(&mut self, device: &Device, queue: &Queue, values: &[f32]) -> Result<(), SceneError> {
        TRIANGLES.check(values)?;
        self.sorted.clear();
        let is_opaque = |shape: &[f32]| shape.chunks_exact(TRIANGLES.stride()).all(|vertex| vertex[9] >= 1.0);
        let opaque = TRIANGLES.split(values, &mut self.sorted, is_opaque);
        self.opaque = 3 * count(opaque);
        self.total = count(values.len() / TRIANGLES.stride());
        self.buffer.write(device, queue, bytemuck::cast_slice(&self.sorted));
        Ok(())
    }
}

impl Plain {
    pub(crate) fn points() -> Self {
        Self { layout: &POINTS, buffer: GrowingBuffer::vertices("points"), total: 0 }
    }

    pub(crate) fn ellipsoids() -> Self {
        Self { layout: &ELLIPSOIDS, buffer: GrowingBuffer::vertices("ellipsoids"), total: 0 }
    }

    pub(crate) fn set(&mut self, device: &Device, queue: &Queue, values: &[f32]) -> Result<(), SceneError> {
        self.layout.check(values)?;
        self.total = count(values.len() / self.layout.stride());
        self.buffer.write(device, queue, bytemuck::cast_slice(values));
        Ok(())
    }
}

impl Segments {
    pub(crate) fn new() -> Self {
        Self {
            buffer: GrowingBuffer::vertices("segments"),
            phases: GrowingBuffer::vertices("dash phases"),
            normal: 0,
            total: 0,
            padded: Vec::new(),
            phase_px: Vec::new(),
            stale: true,
        }
    }

    pub(crate) fn set(&mut self, device: &Device, queue: &Queue, values: &[f32]) -> Result<(), SceneError> {
        SEGMENTS.check(values)?;
        let blank = [0.0; SEGMENTS.stride()];
        self.padded.clear();
        self.padded.extend_from_slice(&blank);
        self.normal = count(SEGMENTS.split(values, &mut self.padded, |segment| segment[12] == 0.0));
        self.padded.extend_from_slice(&blank);
        self.total = count(values.len() / SEGMENTS.stride());
        self.buffer.write(device, queue, bytemuck::cast_slice(&self.padded));
        self.stale = true;
        Ok(())
    }

    /// Asks for new dash phases, because the view changed.
    pub(crate) fn view_changed(&mut self) {
        self.stale = self.stale || dash::any_dashed(&self.padded);
    }

    /// Brings the dash phases up to date.
    pub(crate) fn update_phases(&mut self, device: &Device, queue: &Queue, view: &View) {
        if !self.stale || self.total == 0 {
            return;
        }
        let stride = SEGMENTS.stride();
        let segments = &self.padded[stride..self.padded.len() - stride];
        dash::phases(segments, view, &mut self.phase_px);
        self.phases.write(device, queue, bytemuck::cast_slice(&self.phase_px));
        self.stale = false;
    }
}

impl Sphere {
    pub(crate) fn new(device: &Device, queue: &Queue) -> Self {
        let (mut vertices, mut indices) =
            (GrowingBuffer::vertices("sphere"), GrowingBuffer::indices("sphere triangles"));
        let triangles = sphere::indices();
        vertices.write(device, queue, bytemuck::cast_slice(&sphere::vertices()));
        indices.write(device, queue, bytemuck::cast_slice(&triangles));
        Self { vertices, indices, index_count: count(triangles.len()) }
    }
}
