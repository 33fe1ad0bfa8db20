// Triangles with ambient and directional light, seen from both sides.

// From above and a little aside, in a world whose z points up.
const LIGHT = vec3<f32>(0.32, -0.48, 0.82);

struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) colour: vec4<f32>,
}

struct Surface {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) colour: vec4<f32>,
}

@vertex
fn triangle_vertex(vertex: Vertex) -> Surface {
    return Surface(clip_of(vertex.position), vertex.position, vertex.normal, vertex.colour);
}

@fragment
fn triangle_fragment(surface: Surface) -> @location(0) vec4<f32> {
    let size = length(surface.normal);
    if size < 1e-6 {
        return surface.colour;
    }
    let facing = select(-1.0, 1.0, dot(surface.normal, to_viewer(surface.position)) >= 0.0);
    let lit = max(dot(surface.normal, LIGHT) * facing / size, 0.0);
    let shaded = linear_from_srgb(surface.colour.rgb) * (0.4 + 0.6 * lit);
    return vec4(srgb_from_linear(shaded), surface.colour.a);
}
