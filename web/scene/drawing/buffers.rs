//! Buffers on the graphics card that are reused from frame to frame.

use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, Queue};

/// A vertex or index buffer that grows by doubling and never shrinks: stable sizes cost no allocation.
pub(crate) struct GrowingBuffer {
    label: &'static str,
    usage: BufferUsages,
    buffer: Option<Buffer>,
}

impl GrowingBuffer {
    /// An empty vertex buffer.
    pub(crate) fn vertices(label: &'static str) -> Self {
        Self { label, usage: BufferUsages::VERTEX | BufferUsages::COPY_DST, buffer: None }
    }

    /// An empty index buffer.
    pub(crate) fn indices(label: &'static str) -> Self {
        Self { label, usage: BufferUsages::INDEX | BufferUsages::COPY_DST, buffer: None }
    }

    /// Replaces the contents.
    pub(crate) fn write(&mut self, device: &Device, queue: &Queue, bytes: &[u8]) {
        let needed = bytes.len() as u64;
        let current = self.buffer.take().filter(|buffer| buffer.size() >= needed);
        let buffer = current.unwrap_or_else(|| {
            let size = needed.next_power_of_two().max(4096);
            let (label, usage) = (Some(self.label), self.usage);
            device.create_buffer(&BufferDescriptor { label, size, usage, mapped_at_creation: false })
        });
        if !bytes.is_empty() {
            queue.write_buffer(&buffer, 0, bytes);
        }
        self.buffer = Some(buffer);
    }

    /// The buffer, once something was written.
    pub(crate) fn get(&self) -> Option<&Buffer> {
        self.buffer.as_ref()
    }
}
