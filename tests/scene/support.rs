//! Records, views and pixels that the tests of the scene share. Each test file uses its part of it.
#![allow(dead_code, reason = "each test file is a crate of its own and uses a part")]

use glam::camera::rh::{proj::directx, view::look_at_mat4};
use glam::{Mat4, Vec3};
use rangelab_scene::View;
use rangelab_scene::field::FieldData;

pub const WIDTH_PX: u32 = 200;
pub const HEIGHT_PX: u32 = 160;

pub const RED: [f32; 4] = [1.0, 0.0, 0.0, 1.0];
pub const BLUE: [f32; 4] = [0.0, 0.0, 1.0, 1.0];

pub fn view(clip_from_world: Mat4) -> View {
    View::new(&clip_from_world.to_cols_array(), WIDTH_PX as f32, HEIGHT_PX as f32).expect("a sound matrix")
}

/// From above, x to the right, y up, ten pixels a metre, the origin in the middle; near at z = 10, far at z = -10.
pub fn plan_matrix() -> Mat4 {
    let projection = directx::orthographic(-10.0, 10.0, -8.0, 8.0, 0.0, 20.0);
    projection * look_at_mat4(Vec3::new(0.0, 0.0, 10.0), Vec3::ZERO, Vec3::Y)
}

/// A perspective from `eye` to the origin, z up.
pub fn perspective_matrix(eye: Vec3) -> Mat4 {
    let projection = directx::perspective(0.8, WIDTH_PX as f32 / HEIGHT_PX as f32, 0.1, 100.0);
    projection * look_at_mat4(eye, Vec3::ZERO, Vec3::Z)
}

/// One record of `SEGMENTS`, solid and not in the overlay.
pub fn segment(start: [f32; 3], end: [f32; 3], width_px: f32, rgba: [f32; 4]) -> Vec<f32> {
    [&start[..], &end, &[width_px, 0.0], &rgba, &[0.0]].concat()
}

/// The same, dashed.
pub fn dashed(start: [f32; 3], end: [f32; 3], width_px: f32, dash_px: f32) -> Vec<f32> {
    let mut record = segment(start, end, width_px, RED);
    record[7] = dash_px;
    record
}

/// One record of `POINTS`.
pub fn point(position: [f32; 3], radius_px: f32, rgba: [f32; 4], shape: f32) -> Vec<f32> {
    [&position[..], &[radius_px], &rgba, &[shape]].concat()
}

/// One record of `ELLIPSOIDS`.
pub fn ellipsoid(centre: [f32; 3], axes: [[f32; 3]; 3], rgba: [f32; 4]) -> Vec<f32> {
    [&centre[..], &axes.concat(), &rgba].concat()
}

/// Two triangles that make a rectangle parallel to the floor: `x`, `y` and height, with one normal.
pub fn rectangle(
    [x0, x1]: [f32; 2],
    [y0, y1]: [f32; 2],
    z: f32,
    normal: [f32; 3],
    rgba: [f32; 4],
) -> Vec<f32> {
    let corners = [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y0, z], [x1, y1, z], [x0, y1, z]];
    corners.iter().flat_map(|corner| [&corner[..], &normal, &rgba].concat()).collect()
}

/// A picture that was read back.
pub struct Picture {
    pub rgba: Vec<u8>,
}

impl Picture {
    /// Red, green and blue at a column and a row from the top left.
    pub fn pixel(&self, column: u32, row: u32) -> [u8; 3] {
        assert!(column < WIDTH_PX && row < HEIGHT_PX, "({column}, {row}) is outside the picture");
        let at = 4 * (row * WIDTH_PX + column) as usize;
        [self.rgba[at], self.rgba[at + 1], self.rgba[at + 2]]
    }

    /// Colour where the plan shows the world position (x, y), in metres.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positions of the tests are inside"
    )]
    pub fn plan(&self, x: f32, y: f32) -> [u8; 3] {
        self.pixel((100.0 + 10.0 * x).floor() as u32, (80.0 - 10.0 * y).floor() as u32)
    }

    /// Errs with the numbers unless the plan shows this colour at (x, y), within 2 of 255.
    pub fn expect(&self, what: &str, (x, y): (f32, f32), rgb: [u8; 3]) -> Result<(), String> {
        let seen = self.plan(x, y);
        let near = seen.iter().zip(rgb).all(|(&a, b)| a.abs_diff(b) <= 2);
        if near { Ok(()) } else { Err(format!("{what} at ({x}, {y}): {seen:?}, not {rgb:?}")) }
    }
}

pub const WHITE_RGB: [u8; 3] = [255; 3];
pub const RED_RGB: [u8; 3] = [255, 0, 0];
pub const BLUE_RGB: [u8; 3] = [0, 0, 255];

/// Red at 0.01, green at 0.1, blue at 1 on the logarithmic scale of [`field`].
pub const FIELD_COLOURS: [f32; 9] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
pub const GREEN_RGB: [u8; 3] = [0, 255, 0];
/// The colour of [`field`] where there is no bound.
pub const GREY_RGB: [u8; 3] = [128; 3];

/// A field over -6..6 and -3..5 m of the floor, from 0.01 to 1, hatched black above `worse_than`.
pub fn field(values: &[f32], [width, height]: [u32; 2], worse_than: f32) -> FieldData {
    let grey = [128.0 / 255.0; 3];
    FieldData {
        values: values.to_vec(),
        width,
        height,
        rectangle: vec![-6.0, -3.0, 0.0, 12.0, 0.0, 0.0, 0.0, 8.0, 0.0],
        style: [&[0.01, 1.0, worse_than, 1.0], &[0.0; 3][..], &grey, &[3.0], &FIELD_COLOURS].concat(),
    }
}
