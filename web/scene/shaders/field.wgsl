// A rectangle that shows a grid of positive numbers by colours on a logarithmic scale, hatched where they are too large.

struct Field {
    corner: vec4<f32>,
    u: vec4<f32>,
    v: vec4<f32>,
    // Both ends of the scale, the number above which is hatched (0: none is), opacity.
    scale: vec4<f32>,
    // Colour of the hatching, number of stops.
    hatch: vec4<f32>,
    no_bound: vec4<f32>,
    stops: array<vec4<f32>, 16>,
}

@group(1) @binding(0) var<uniform> field: Field;
@group(1) @binding(1) var coarse: texture_2d<f32>;
// Negative where it is not resolved.
@group(1) @binding(2) var fine: texture_2d<f32>;

struct Fragment {
    @builtin(position) clip: vec4<f32>,
    @location(0) at: vec2<f32>,
    // Where the middle of the rectangle is seen, pixels: the hatching moves with it.
    @location(1) @interpolate(flat, either) anchor_px: vec2<f32>,
}

@vertex
fn field_vertex(@builtin(vertex_index) vertex: u32) -> Fragment {
    var out: Fragment;
    out.at = 0.5 + 0.5 * corner(vertex);
    out.clip = clip_of(field.corner.xyz + field.u.xyz * out.at.x + field.v.xyz * out.at.y);
    let middle = clip_of(field.corner.xyz + 0.5 * (field.u.xyz + field.v.xyz));
    if middle.w > 0.0 {
        let seen = 0.5 * view.size.xy * vec2(middle.x, -middle.y) / middle.w;
        out.anchor_px = clamp(seen, vec2(-1e5), vec2(1e5));
    }
    return out;
}

const UNBOUNDED = 1e30;
// In place of a logarithm, which lies between -100 and 100.
const NO_BOUND = 1e30;
const UNRESOLVED = -1e30;

fn log_of(value: f32) -> f32 {
    if !(value >= 0.0) {
        return UNRESOLVED;
    }
    return select(log(max(value, 1e-37)), NO_BOUND, value >= UNBOUNDED);
}

fn log_in(grid: texture_2d<f32>, cell: vec2<i32>) -> f32 {
    return log_of(textureLoad(grid, cell, 0).x);
}

// Logarithm at a place of the rectangle (0..1), interpolated between the centres of four cells; that of the cell there
// if one of the four has none.
fn log_at(grid: texture_2d<f32>, at: vec2<f32>) -> f32 {
    let last = vec2<i32>(textureDimensions(grid)) - 1;
    let place = at * vec2<f32>(last + 1);
    let inside = clamp(place - 0.5, vec2(0.0), vec2<f32>(last));
    let near = vec2<i32>(inside);
    let far = min(near + 1, last);
    let four = vec4(
        log_in(grid, near),
        log_in(grid, vec2(far.x, near.y)),
        log_in(grid, vec2(near.x, far.y)),
        log_in(grid, far),
    );
    if any(abs(four) > vec4(100.0)) {
        return log_in(grid, min(vec2<i32>(place), last));
    }
    let part = fract(inside);
    let rows = mix(four.xz, four.yw, part.x);
    return mix(rows.x, rows.y, part.y);
}

fn colour_of(logarithm: f32) -> vec3<f32> {
    let low = log(field.scale.x);
    let t = clamp((logarithm - low) / (log(field.scale.y) - low), 0.0, 1.0);
    let last = i32(field.hatch.w) - 1;
    let along = t * f32(last);
    let stop = min(i32(along), last - 1);
    return mix(field.stops[stop].rgb, field.stops[stop + 1].rgb, along - f32(stop));
}

// How much of a pixel is covered by lines of 1.5 pixels, 10 pixels apart.
fn lines(across_px: f32) -> f32 {
    return coverage(10.0 * abs(fract(0.1 * across_px) - 0.5) - 0.75);
}

@fragment
fn field_fragment(in: Fragment) -> @location(0) vec4<f32> {
    let at = clamp(in.at, vec2(0.0), vec2(1.0));
    var logarithm = log_at(fine, at);
    if logarithm == UNRESOLVED {
        logarithm = log_at(coarse, at);
    }
    let pixel = (in.clip.xy - 0.5 * view.size.xy - in.anchor_px) * 0.70710678;
    let rising = lines(pixel.x + pixel.y);
    let crossed = max(rising, lines(pixel.x - pixel.y));
    var colour = colour_of(logarithm);
    if logarithm == NO_BOUND {
        colour = mix(field.no_bound.rgb, field.hatch.rgb, crossed);
    } else if field.scale.z > 0.0 && logarithm > log(field.scale.z) {
        colour = mix(colour, field.hatch.rgb, rising);
    }
    return vec4(colour, field.scale.w);
}
