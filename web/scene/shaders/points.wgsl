// Markers that face the viewer, cut out by signed distances, with an outline that contrasts with the fill.

struct Marker {
    @builtin(vertex_index) vertex: u32,
    @location(0) position: vec3<f32>,
    @location(1) radius_px: f32,
    @location(2) colour: vec4<f32>,
    @location(3) shape: f32,
}

struct Fragment {
    @builtin(position) clip: vec4<f32>,
    @location(0) offset_px: vec2<f32>,
    @location(1) @interpolate(flat, either) colour: vec4<f32>,
    @location(2) @interpolate(flat, either) radius_px: f32,
    @location(3) @interpolate(flat, either) shape: u32,
}

fn outline_px(radius_px: f32) -> f32 {
    return max(1.0, 0.15 * radius_px);
}

@vertex
fn point_vertex(marker: Marker) -> Fragment {
    var out: Fragment;
    // The corners of the triangle lie farthest out, those of its outline twice as far from them as its sides.
    let reach = 1.2 * marker.radius_px + 2.0 * outline_px(marker.radius_px) + 1.0;
    out.offset_px = corner(marker.vertex) * reach;
    out.colour = marker.colour;
    out.radius_px = marker.radius_px;
    out.shape = u32(marker.shape + 0.5);
    out.clip = NOWHERE;
    if clip_of(marker.position).z >= 0.0 && marker.radius_px > 0.0 {
        let centre = project(marker.position, marker.radius_px);
        out.clip = screen_position(centre.xy + out.offset_px, centre.z);
    }
    return out;
}

fn box_distance(p: vec2<f32>, half: vec2<f32>) -> f32 {
    let d = abs(p) - half;
    return length(max(d, vec2(0.0))) + min(max(d.x, d.y), 0.0);
}

fn triangle_distance(p: vec2<f32>, r: f32) -> f32 {
    // Equilateral, centroid at the origin, corners at distance r: the largest distance beyond its three sides.
    let side = 0.8660254 * abs(p.x) + 0.5 * p.y;
    return max(side, -p.y) - 0.5 * r;
}

fn shape_distance(shape: u32, p: vec2<f32>, r: f32) -> f32 {
    switch shape {
        case 1u: {
            let thick = max(0.18 * r, 0.75);
            return abs(length(p) - (r - thick)) - thick;
        }
        case 2u: {
            return box_distance(p, vec2(0.85 * r));
        }
        case 3u: {
            return triangle_distance(p, 1.2 * r);
        }
        case 4u: {
            return (abs(p.x) + abs(p.y) - 1.15 * r) * 0.70710678;
        }
        case 5u: {
            let turned = vec2(p.x + p.y, p.x - p.y) * 0.70710678;
            let bar = vec2(1.1 * r, 0.28 * r);
            return min(box_distance(turned, bar), box_distance(turned, bar.yx));
        }
        default: {
            return length(p) - r;
        }
    }
}

@fragment
fn point_fragment(in: Fragment) -> @location(0) vec4<f32> {
    let distance = shape_distance(in.shape, in.offset_px, in.radius_px);
    let luminance = dot(linear_from_srgb(in.colour.rgb), vec3(0.2126, 0.7152, 0.0722));
    let outline = select(vec3(0.97), vec3(0.06), luminance > 0.18);
    let colour = mix(outline, in.colour.rgb, coverage(distance));
    return vec4(colour, in.colour.a * coverage(distance - outline_px(in.radius_px)));
}
