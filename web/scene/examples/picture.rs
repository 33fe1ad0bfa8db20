//! Draws one of everything and writes a PNG: `cargo run -p rangelab-scene --features native --example picture -- out.png`.

use std::error::Error;
use std::f32::consts::TAU;
use std::fs::File;
use std::io::BufWriter;

use glam::camera::rh::{proj::directx::perspective, view::look_at_mat4};
use glam::{Vec2, Vec3};
use rangelab_scene::field::{FieldData, UNBOUNDED};
use rangelab_scene::{Offscreen, SceneData, View};

const WIDTH_PX: u32 = 1200;
const HEIGHT_PX: u32 = 760;

// Okabe and Ito's colours: told apart by colour-blind readers too.
const ORANGE: [f32; 4] = [0.90, 0.62, 0.0, 1.0];
const SKY: [f32; 4] = [0.34, 0.71, 0.91, 1.0];
const GREEN: [f32; 4] = [0.0, 0.62, 0.45, 1.0];
const BLUE: [f32; 4] = [0.0, 0.45, 0.70, 1.0];
const VERMILION: [f32; 4] = [0.84, 0.37, 0.0, 1.0];
const GREY: [f32; 4] = [0.45, 0.48, 0.52, 0.5];

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: picture OUT.png")?;
    let (width, height) = (WIDTH_PX as f32, HEIGHT_PX as f32);
    let projection = perspective(0.7, width / height, 0.1, 100.0);
    let camera = look_at_mat4(Vec3::new(7.0, -9.5, 6.0), Vec3::new(0.0, 0.0, 0.9), Vec3::Z);
    let view = View::new(&(projection * camera).to_cols_array(), width, height)?;

    let mut data = SceneData { background: [0.97, 0.975, 0.98], ..SceneData::default() };
    floor(&mut data);
    body(&mut data, Vec3::new(2.2, 0.3, 1.2), 0.45);
    tracks(&mut data);
    ellipsoids(&mut data);
    markers(&mut data);

    let pixels = Offscreen::new(WIDTH_PX, HEIGHT_PX)?.render(&view, &data)?;
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), WIDTH_PX, HEIGHT_PX);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(())
}

fn segment(
    data: &mut SceneData,
    ends: [Vec3; 2],
    [width_px, dash_px]: [f32; 2],
    rgba: [f32; 4],
    overlay: f32,
) {
    data.segments.extend(ends.iter().flat_map(Vec3::to_array));
    data.segments.extend([width_px, dash_px]);
    data.segments.extend(rgba);
    data.segments.push(overlay);
}

/// A grid, and a field on part of it: hatched where it is worst, and with a corner that has no bound.
fn floor(data: &mut SceneData) {
    for i in -5..=5_i8 {
        let at = f32::from(i);
        segment(data, [Vec3::new(at, -5.0, 0.0), Vec3::new(at, 5.0, 0.0)], [1.0, 0.0], GREY, 0.0);
        segment(data, [Vec3::new(-5.0, at, 0.0), Vec3::new(5.0, at, 0.0)], [1.0, 0.0], GREY, 0.0);
    }
    let stops = [[0.99, 0.91, 0.15], [0.13, 0.57, 0.55], [0.27, 0.0, 0.33]];
    let style = [0.05, 5.0, 2.0, 0.7, 0.1, 0.1, 0.12, 0.6, 0.6, 0.6, 3.0];
    let value = |i: u8, j: u8| {
        let far = (Vec2::new(f32::from(i), f32::from(j)) - 14.0).length_squared();
        if i + j < 4 { UNBOUNDED } else { 0.05 + 0.01 * far }
    };
    data.field = FieldData {
        values: (0..16).flat_map(|j| (0..16).map(move |i| value(i, j))).collect(),
        width: 16,
        height: 16,
        rectangle: vec![-5.0, -5.0, 0.0, 5.0, 0.0, 0.0, 0.0, 5.0, 0.0],
        style: [&style, stops.as_flattened()].concat(),
    };
}

/// A shaded cube with its edges.
fn body(data: &mut SceneData, centre: Vec3, half: f32) {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    for (k, sign) in (0..3).flat_map(|k| [(k, -1.0), (k, 1.0)]) {
        let (normal, u, v) = (axes[k] * sign, axes[(k + 1) % 3], axes[(k + 2) % 3]);
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(a, b)| centre + (normal + u * a + v * b) * half);
        for i in [0, 1, 2, 0, 2, 3] {
            data.triangles.extend(corners[i].to_array());
            data.triangles.extend(normal.to_array());
            data.triangles.extend([0.75, 0.78, 0.82, 1.0]);
        }
        for i in 0..4 {
            segment(data, [corners[i], corners[(i + 1) % 4]], [1.5, 0.0], [0.2, 0.22, 0.25, 1.0], 0.0);
        }
    }
    for (axis, rgba) in axes.into_iter().zip([VERMILION, GREEN, BLUE]) {
        segment(data, [centre, centre + axis * 1.1], [3.0, 0.0], rgba, 1.0);
    }
}

/// A solid, a dashed and a wide translucent track of many short segments.
fn tracks(data: &mut SceneData) {
    let styles =
        [([9.0, 0.0], [0.0, 0.45, 0.70, 0.35], 0.0), ([2.5, 0.0], VERMILION, 0.35), ([2.5, 8.0], GREEN, 0.7)];
    for (style, rgba, lift) in styles {
        let at = |i: u16| {
            let turn = TAU * f32::from(i) / 400.0;
            (Vec2::from_angle(turn) * Vec2::new(3.6, 2.6))
                .extend(0.9 + lift + 0.3 * Vec2::from_angle(3.0 * turn).y)
        };
        for i in 0..340 {
            segment(data, [at(i), at(i + 1)], style, rgba, 0.0);
        }
    }
    let zigzag = [-2.0, -1.0, 0.0, 1.0].map(|x: f32| Vec3::new(x, 4.0, 0.5 + x * x % 2.0));
    for ends in zigzag.windows(2) {
        segment(data, [ends[0], ends[1]], [16.0, 0.0], [0.34, 0.71, 0.91, 0.5], 0.0);
    }
}

/// A ball, a long one, and a flat one lying on the floor.
fn ellipsoids(data: &mut SceneData) {
    let mut ellipsoid = |centre: [f32; 3], axes: [[f32; 3]; 3], [r, g, b, _]: [f32; 4]| {
        data.ellipsoids.extend(centre);
        data.ellipsoids.extend(axes.iter().flatten());
        data.ellipsoids.extend([r, g, b, 0.5]);
    };
    ellipsoid([-3.4, 0.3, 1.5], [[0.9, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.9]], ORANGE);
    ellipsoid([-0.6, 0.0, 1.0], [[1.3, 0.5, 0.3], [-0.1, 0.3, -0.1], [-0.1, 0.0, 0.4]], SKY);
    ellipsoid([-0.6, -2.6, 0.01], [[1.3, 0.3, 0.0], [-0.15, 0.6, 0.0], [0.0; 3]], GREEN);
}

/// Each shape at two sizes.
fn markers(data: &mut SceneData) {
    for (shape, rgba) in [BLUE, ORANGE, GREEN, VERMILION, SKY, [0.1, 0.1, 0.12, 1.0]].into_iter().enumerate()
    {
        for (row, radius_px) in [11.0, 5.0].into_iter().enumerate() {
            let (x, y) = (0.4 + 0.7 * shape as f32, -4.6 + 0.8 * row as f32 + 0.4 * shape as f32);
            data.points.extend([x, y, 0.0, radius_px]);
            data.points.extend(rgba);
            data.points.push(shape as f32);
        }
    }
}
