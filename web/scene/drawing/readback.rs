//! Reading a texture of four bytes a texel back from the graphics card.

use futures_channel::oneshot;
use wgpu::{
    BufferDescriptor, BufferUsages, COPY_BYTES_PER_ROW_ALIGNMENT, CommandEncoderDescriptor, Device, MapMode,
    Queue, TexelCopyBufferInfo, TexelCopyBufferLayout, Texture,
};

use crate::error::SceneError;

/// The bytes of all texels, row by row.
///
/// # Errors
/// [`SceneError::Device`] or [`SceneError::Lost`] if the device does not give them.
pub(crate) fn texels(
    device: &Device,
    queue: &Queue,
    texture: &Texture,
) -> impl Future<Output = Result<Vec<u8>, SceneError>> + use<> {
    let row = 4 * texture.width();
    let padded_row = row.next_multiple_of(COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&BufferDescriptor {
        label: Some("texels"),
        size: u64::from(padded_row) * u64::from(texture.height()),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&CommandEncoderDescriptor::default());
    let layout = TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(padded_row), rows_per_image: None };
    let copy = TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), copy, texture.size());
    queue.submit([encoder.finish()]);
    let (sender, mapped) = oneshot::channel();
    buffer.map_async(MapMode::Read, .., move |result| {
        // Nobody listens any more when the future was dropped.
        sender.send(result).ok();
    });
    async move {
        let failed = |reason: &dyn std::fmt::Display| SceneError::Device(reason.to_string());
        mapped.await.map_err(|_| SceneError::Lost)?.map_err(|error| failed(&error))?;
        let bytes = buffer.slice(..).get_mapped_range().map_err(|error| failed(&error))?;
        let rows = bytes.chunks_exact(padded_row as usize);
        Ok(rows.flat_map(|padded| &padded[..row as usize]).copied().collect())
    }
}
