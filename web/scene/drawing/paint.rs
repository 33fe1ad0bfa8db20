//! The order of drawing: the field under everything, solids, then what shines through, then annotations over them.
//!
//! What is empty is not drawn: browsers warn of draws without vertices.
//!
//! Only opaque triangles hide what is behind them. Within a kind, later records are painted over earlier ones, so that
//! nearly coincident tracks do not flicker.

use wgpu::{IndexFormat, RenderPass};

use super::renderer::Renderer;
use crate::data::SEGMENTS;

/// Draws all layers into a pass whose view is bound.
pub(crate) fn everything(pass: &mut RenderPass, scene: &Renderer) {
    field(pass, scene);
    triangles(pass, scene);
    ellipsoids(pass, scene);
    segments(pass, scene, 0, scene.segments.normal);
    points(pass, scene);
    segments(pass, scene, scene.segments.normal, scene.segments.total);
}

fn field(pass: &mut RenderPass, scene: &Renderer) {
    let Some(group) = scene.field.group() else { return };
    pass.set_pipeline(&scene.pipelines.field);
    pass.set_bind_group(1, &group, &[]);
    pass.draw(0..6, 0..1);
}

fn triangles(pass: &mut RenderPass, scene: &Renderer) {
    let triangles = &scene.triangles;
    let Some(buffer) = triangles.buffer.get() else { return };
    pass.set_vertex_buffer(0, buffer.slice(..));
    if triangles.opaque > 0 {
        pass.set_pipeline(&scene.pipelines.opaque_triangles);
        pass.draw(0..triangles.opaque, 0..1);
    }
    if triangles.total > triangles.opaque {
        pass.set_pipeline(&scene.pipelines.translucent_triangles);
        pass.draw(triangles.opaque..triangles.total, 0..1);
    }
}

fn ellipsoids(pass: &mut RenderPass, scene: &Renderer) {
    let sphere = &scene.sphere;
    let (Some(buffer), Some(vertices), Some(indices)) =
        (scene.ellipsoids.buffer.get(), sphere.vertices.get(), sphere.indices.get())
    else {
        return;
    };
    if scene.ellipsoids.total == 0 {
        return;
    }
    pass.set_pipeline(&scene.pipelines.ellipsoids);
    pass.set_vertex_buffer(0, vertices.slice(..));
    pass.set_vertex_buffer(1, buffer.slice(..));
    pass.set_index_buffer(indices.slice(..), IndexFormat::Uint16);
    pass.draw_indexed(0..sphere.index_count, 0, 0..scene.ellipsoids.total);
}

fn points(pass: &mut RenderPass, scene: &Renderer) {
    let Some(buffer) = scene.points.buffer.get() else { return };
    if scene.points.total == 0 {
        return;
    }
    pass.set_pipeline(&scene.pipelines.points);
    pass.set_vertex_buffer(0, buffer.slice(..));
    pass.draw(0..6, 0..scene.points.total);
}

/// Draws the segments from `first` up to `end`.
fn segments(pass: &mut RenderPass, scene: &Renderer, first: u32, end: u32) {
    let (Some(buffer), Some(phases)) = (scene.segments.buffer.get(), scene.segments.phases.get()) else {
        return;
    };
    if first == end {
        return;
    }
    // The same records three times: each one, the one before and the one after it. Offsets instead of a first instance,
    // which WebGL does not know.
    let record = (SEGMENTS.stride() * size_of::<f32>()) as u64;
    let before = u64::from(first) * record;
    pass.set_pipeline(&scene.pipelines.segments);
    pass.set_vertex_buffer(0, buffer.slice(before + record..));
    pass.set_vertex_buffer(1, buffer.slice(before..));
    pass.set_vertex_buffer(2, buffer.slice(before + 2 * record..));
    pass.set_vertex_buffer(3, phases.slice(u64::from(first) * size_of::<f32>() as u64..));
    pass.draw(0..6, 0..end - first);
}
