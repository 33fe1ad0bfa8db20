// Lines of constant width on the screen, with round ends, joints painted once and dashes measured in pixels.

struct Segment {
    @builtin(vertex_index) vertex: u32,
    @location(0) start: vec3<f32>,
    @location(1) end: vec3<f32>,
    @location(2) width_px: f32,
    @location(3) dash_px: f32,
    @location(4) colour: vec4<f32>,
    @location(5) overlay: f32,
    // The records before and after this one, which it may continue.
    @location(6) before_start: vec3<f32>,
    @location(7) before_end: vec3<f32>,
    @location(8) before_width_px: f32,
    @location(9) after_start: vec3<f32>,
    @location(10) after_end: vec3<f32>,
    @location(11) after_width_px: f32,
    @location(12) phase_px: f32,
}

struct Fragment {
    @builtin(position) clip: vec4<f32>,
    @location(0) pixel: vec2<f32>,
    // Start and end, pixels.
    @location(1) @interpolate(flat, either) ends: vec4<f32>,
    // Normals of the lines that cut the joints at start and end; zero where the line ends free.
    @location(2) @interpolate(flat, either) cuts: vec4<f32>,
    @location(3) @interpolate(flat, either) colour: vec4<f32>,
    // Half width, dash, phase.
    @location(4) @interpolate(flat, either) style: vec3<f32>,
}

// Shorter lines have no direction that pixels could show.
const SHORTEST_PX = 1e-3;

struct Visible {
    start: vec3<f32>,
    end: vec3<f32>,
    // Whether the given end points themselves are in front of the viewer.
    start_seen: bool,
    end_seen: bool,
}

// The part of a line beyond the near plane.
fn visible(start: vec3<f32>, end: vec3<f32>) -> Visible {
    let a = clip_of(start).z;
    let b = clip_of(end).z;
    var part = Visible(start, end, a >= 0.0, b >= 0.0);
    if !part.start_seen && part.end_seen {
        part.start = mix(start, end, a / (a - b));
    }
    if part.start_seen && !part.end_seen {
        part.end = mix(end, start, b / (b - a));
    }
    return part;
}

fn direction(start: vec2<f32>, end: vec2<f32>) -> vec2<f32> {
    let along = end - start;
    let size = length(along);
    return select(vec2(0.0), along / max(size, SHORTEST_PX), size >= SHORTEST_PX);
}

// Normal of the line that halves the joint of two lines; zero if one has no direction or they turn back.
fn joint_normal(first: vec2<f32>, second: vec2<f32>) -> vec2<f32> {
    let sum = first + second;
    let sharp = dot(first, first) < 0.5 || dot(second, second) < 0.5 || dot(sum, sum) < 1e-4;
    return select(sum, vec2(0.0), sharp);
}

@vertex
fn segment_vertex(s: Segment) -> Fragment {
    var out: Fragment;
    out.clip = NOWHERE;
    let part = visible(s.start, s.end);
    if !part.start_seen && !part.end_seen {
        return out;
    }
    // Hairlines stay one pixel wide and fade instead.
    let half_px = 0.5 * max(s.width_px, 1.0);
    let a = project(part.start, half_px);
    let b = project(part.end, half_px);
    let along = direction(a.xy, b.xy);
    let follows = all(s.before_end == s.start) && s.before_width_px == s.width_px;
    if s.width_px <= 0.0 || (follows && dot(along, along) < 0.5) {
        return out;
    }

    var start_cut = vec2(0.0);
    if follows && part.start_seen {
        let before = visible(s.before_start, s.before_end);
        start_cut = joint_normal(direction(project(before.start, half_px).xy, a.xy), along);
    }
    var end_cut = vec2(0.0);
    if all(s.after_start == s.end) && s.after_width_px == s.width_px && part.end_seen {
        let after = visible(s.after_start, s.after_end);
        end_cut = joint_normal(along, direction(b.xy, project(after.end, half_px).xy));
    }

    let axis = select(vec2(1.0, 0.0), along, dot(along, along) > 0.5);
    let reach = half_px + 1.0;
    let at = corner(s.vertex);
    let tip = select(a, b, at.x > 0.0);
    out.pixel = tip.xy + reach * (at.x * axis + at.y * vec2(-axis.y, axis.x));
    out.clip = screen_position(out.pixel, select(tip.z, 0.0, s.overlay > 0.5));
    out.ends = vec4(a.xy, b.xy);
    out.cuts = vec4(start_cut, end_cut);
    out.colour = vec4(s.colour.rgb, s.colour.a * min(s.width_px, 1.0));
    out.style = vec3(half_px, s.dash_px, s.phase_px);
    return out;
}

// Signed distance in pixels along the line to the nearest dash.
fn dash_distance(at_px: f32, dash_px: f32) -> f32 {
    let period = 2.0 * dash_px;
    let off_centre = abs(fract(at_px / period) - 0.25);
    return (min(off_centre, 1.0 - off_centre) - 0.25) * period;
}

@fragment
fn segment_fragment(in: Fragment) -> @location(0) vec4<f32> {
    let from_start = in.pixel - in.ends.xy;
    let from_end = in.pixel - in.ends.zw;
    let across_start = dot(from_start, in.cuts.xy);
    let across_end = dot(from_end, in.cuts.zw);
    let cut_start = any(in.cuts.xy != vec2(0.0)) && across_start < 0.0;
    let cut_end = any(in.cuts.zw != vec2(0.0)) && across_end >= 0.0;
    if cut_start || cut_end {
        discard;
    }

    let line = in.ends.zw - in.ends.xy;
    let size = length(line);
    let along = clamp(dot(from_start, line) / max(size, SHORTEST_PX), 0.0, size);
    let nearest = in.ends.xy + line * (along / max(size, SHORTEST_PX));
    var distance = length(in.pixel - nearest) - in.style.x;
    if in.style.y > 0.0 {
        distance = max(distance, dash_distance(along + in.style.z, in.style.y));
    }
    return vec4(in.colour.rgb, in.colour.a * coverage(distance));
}
