// What every shader of the scene shares: the view, depth towards the viewer and sRGB.

struct View {
    clip_from_world: mat4x4<f32>,
    // w = 1: the viewer's position; w = 0: the direction towards a viewer far away.
    eye: vec4<f32>,
    // Width and height in pixels, metres per pixel at clip w = 1.
    size: vec4<f32>,
}

@group(0) @binding(0) var<uniform> view: View;

fn clip_of(position: vec3<f32>) -> vec4<f32> {
    return view.clip_from_world * vec4(position, 1.0);
}

fn to_viewer(position: vec3<f32>) -> vec3<f32> {
    return view.eye.xyz - view.eye.w * position;
}

// Pixels from the centre of the picture, y up, and depth. The depth is that of a point moved towards the viewer by twice
// what `half_px` pixels measure there, so that a line or marker of that half size does not sink into a surface it lies on,
// unless that is seen at less than 27 degrees.
fn project(position: vec3<f32>, half_px: f32) -> vec3<f32> {
    let clip = clip_of(position);
    let towards = to_viewer(position);
    let metres = 2.0 * half_px * view.size.z * clip.w;
    let lifted = clip_of(position + towards * min(metres / length(towards), 0.5));
    return vec3(0.5 * view.size.xy * clip.xy / clip.w, max(lifted.z / lifted.w, 0.0));
}

fn screen_position(pixel: vec2<f32>, depth: f32) -> vec4<f32> {
    return vec4(pixel / (0.5 * view.size.xy), depth, 1.0);
}

// A position outside the picture, for shapes that are not to be drawn.
const NOWHERE = vec4<f32>(2.0, 2.0, 2.0, 1.0);

// Corners of a rectangle as two triangles, each coordinate -1 or 1.
fn corner(vertex: u32) -> vec2<f32> {
    let right = vertex == 1u || vertex == 4u || vertex == 5u;
    let upper = vertex == 2u || vertex == 3u || vertex == 5u;
    return vec2(select(-1.0, 1.0, right), select(-1.0, 1.0, upper));
}

// How much of a pixel lies inside an edge at this signed distance (negative inside), in pixels.
fn coverage(distance_px: f32) -> f32 {
    return clamp(0.5 - distance_px, 0.0, 1.0);
}

fn linear_from_srgb(colour: vec3<f32>) -> vec3<f32> {
    let dark = colour / 12.92;
    let light = pow((colour + 0.055) / 1.055, vec3(2.4));
    return select(light, dark, colour <= vec3(0.04045));
}

// The canvas stores what it is given, so the encoding happens here.
fn srgb_from_linear(colour: vec3<f32>) -> vec3<f32> {
    let dark = colour * 12.92;
    let light = 1.055 * pow(max(colour, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055;
    return select(light, dark, colour <= vec3(0.0031308));
}
