//! The matrix that the page draws with, and what follows from it.

use crate::error::SceneError;

/// A view of the world: a projection with depth 0 (near) to 1 (far), perspective or orthographic.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    clip_from_world: [f32; 16],
    width_px: f32,
    height_px: f32,
    eye: [f32; 4],
}

impl View {
    /// A view from a column-major 4 x 4 matrix and the size of the picture in physical pixels.
    ///
    /// # Errors
    /// [`SceneError::View`] if there are not 16 finite numbers, the size is not positive, or no eye can see this way.
    pub fn new(clip_from_world: &[f32], width_px: f32, height_px: f32) -> Result<Self, SceneError> {
        let Ok(clip_from_world) = <[f32; 16]>::try_from(clip_from_world) else {
            let length = clip_from_world.len();
            return Err(SceneError::View(format!("a matrix has 16 numbers, not {length}")));
        };
        if let Some((index, value)) = clip_from_world.iter().enumerate().find(|(_, value)| !value.is_finite())
        {
            return Err(SceneError::View(format!("number {index} of the matrix is {value}")));
        }
        if !(width_px > 0.0 && height_px > 0.0 && width_px.is_finite() && height_px.is_finite()) {
            return Err(SceneError::View(format!("a picture cannot be {width_px} x {height_px} pixels")));
        }
        let eye = eye(&clip_from_world)
            .ok_or_else(|| SceneError::View("the matrix flattens the world, nothing could be seen".into()))?;
        Ok(Self { clip_from_world, width_px, height_px, eye })
    }

    /// Where the viewer is: a world position with a last 1, or for an orthographic view the direction towards the
    /// viewer with a last 0.
    pub fn eye(&self) -> [f32; 4] {
        self.eye
    }

    /// Homogeneous clip coordinates of a world position.
    pub fn clip(&self, position: [f32; 3]) -> [f32; 4] {
        let [x, y, z] = position;
        let m = &self.clip_from_world;
        std::array::from_fn(|i| m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i])
    }

    /// Length in pixels of the part of a line in front of the viewer.
    pub fn length_px(&self, start: [f32; 3], end: [f32; 3]) -> f32 {
        let (a, b) = (self.clip(start), self.clip(end));
        if a[2] < 0.0 && b[2] < 0.0 {
            return 0.0;
        }
        let [ax, ay] = self.pixel(if a[2] < 0.0 { meet_near(a, b) } else { a });
        let [bx, by] = self.pixel(if b[2] < 0.0 { meet_near(b, a) } else { b });
        let (dx, dy) = (bx - ax, by - ay);
        (dx * dx + dy * dy).sqrt()
    }

    /// The numbers that the shaders read: matrix, eye, then width, height and metres per pixel at clip w = 1.
    pub fn uniform(&self) -> [f32; 24] {
        let [_, r1, _, _] = rows(&self.clip_from_world);
        let vertical = (r1[0] * r1[0] + r1[1] * r1[1] + r1[2] * r1[2]).sqrt();
        let mut uniform = [0.0; 24];
        uniform[..16].copy_from_slice(&self.clip_from_world);
        uniform[16..20].copy_from_slice(&self.eye);
        #[expect(clippy::cast_possible_truncation, reason = "a graphics card computes in f32")]
        let metres_per_px = (2.0 / (f64::from(self.height_px) * vertical)) as f32;
        uniform[20..23].copy_from_slice(&[self.width_px, self.height_px, metres_per_px]);
        uniform
    }

    fn pixel(&self, clip: [f32; 4]) -> [f32; 2] {
        [0.5 * self.width_px * clip[0] / clip[3], 0.5 * self.height_px * clip[1] / clip[3]]
    }
}

/// Where the line from `behind` (clip z < 0) to `front` meets the near plane.
fn meet_near(behind: [f32; 4], front: [f32; 4]) -> [f32; 4] {
    let t = behind[2] / (behind[2] - front[2]);
    std::array::from_fn(|i| behind[i] + t * (front[i] - behind[i]))
}

fn rows(matrix: &[f32; 16]) -> [[f64; 4]; 4] {
    std::array::from_fn(|row| std::array::from_fn(|column| f64::from(matrix[4 * column + row])))
}

/// The one point whose clip x, y and w all vanish: every line of sight passes through it.
fn eye(matrix: &[f32; 16]) -> Option<[f32; 4]> {
    let [x, y, z, w] = rows(matrix);
    let minor = |i: usize, j: usize, k: usize| {
        x[i] * (y[j] * w[k] - y[k] * w[j]) - x[j] * (y[i] * w[k] - y[k] * w[i])
            + x[k] * (y[i] * w[j] - y[j] * w[i])
    };
    let p = [minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)];
    let far = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    // A viewer more than a million metres away sees along parallel lines.
    let scale = if p[3].abs() > 1e-6 * far {
        p[3]
    } else {
        // Depth grows away from the viewer; the minors leave the sign of the direction open.
        -far * (z[0] * p[0] + z[1] * p[1] + z[2] * p[2]).signum()
    };
    let last = if p[3].abs() > 1e-6 * far { 1.0 } else { 0.0 };
    #[expect(clippy::cast_possible_truncation, reason = "a graphics card computes in f32")]
    let eye = [(p[0] / scale) as f32, (p[1] / scale) as f32, (p[2] / scale) as f32, last];
    eye.iter().all(|value| value.is_finite()).then_some(eye)
}
