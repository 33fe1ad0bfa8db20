// Translucent ellipsoids: images of the unit sphere, denser at the rim so that the shape reads.

struct Ellipsoid {
    @location(0) unit: vec3<f32>,
    @location(1) centre: vec3<f32>,
    @location(2) axis_1: vec3<f32>,
    @location(3) axis_2: vec3<f32>,
    @location(4) axis_3: vec3<f32>,
    @location(5) colour: vec4<f32>,
}

struct Surface {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) colour: vec4<f32>,
}

@vertex
fn ellipsoid_vertex(e: Ellipsoid) -> Surface {
    let position = e.centre + e.axis_1 * e.unit.x + e.axis_2 * e.unit.y + e.axis_3 * e.unit.z;
    // Normals go with the cofactors, which exist for flat ellipses where the inverse does not.
    let normal = cross(e.axis_2, e.axis_3) * e.unit.x + cross(e.axis_3, e.axis_1) * e.unit.y
        + cross(e.axis_1, e.axis_2) * e.unit.z;
    // Axes may be millimetres, their products too small to square: scale before interpolation.
    let largest = max(max(abs(normal.x), abs(normal.y)), abs(normal.z));
    return Surface(clip_of(position), position, normal / max(largest, 1e-30), e.colour);
}

@fragment
fn ellipsoid_fragment(surface: Surface) -> @location(0) vec4<f32> {
    let towards = normalize(to_viewer(surface.position));
    let facing = abs(dot(surface.normal, towards)) / max(length(surface.normal), 1e-6);
    let rim = 1.0 - clamp(facing, 0.0, 1.0);
    let alpha = surface.colour.a * mix(0.4, 1.0, rim * rim);
    let shaded = linear_from_srgb(surface.colour.rgb) * mix(1.0, 0.7, rim);
    return vec4(srgb_from_linear(shaded), alpha);
}
