//! The mesh that every ellipsoid is an image of: an octahedron, subdivided and blown up to the unit sphere.

/// Subdivisions of an edge of the octahedron; a silhouette then has four times as many corners.
const DIVISIONS: u16 = 14;
const VERTICES_PER_FACE: u16 = (DIVISIONS + 1) * (DIVISIONS + 2) / 2;

/// Vertices (xyz each) of the unit sphere, face by face.
pub(crate) fn vertices() -> Vec<f32> {
    let mut vertices = Vec::new();
    for face in 0..8_u8 {
        let [x_sign, y_sign, z_sign] = [1, 2, 4].map(|bit| if face & bit == 0 { 1.0 } else { -1.0 });
        for i in 0..=DIVISIONS {
            for j in 0..=DIVISIONS - i {
                let [x, y, z] = [i, j, DIVISIONS - i - j].map(f32::from);
                let radius = (x * x + y * y + z * z).sqrt();
                vertices.extend([x_sign * x / radius, y_sign * y / radius, z_sign * z / radius]);
            }
        }
    }
    vertices
}

/// Triangles of the unit sphere as indices of [`vertices`].
pub(crate) fn indices() -> Vec<u16> {
    let mut indices = Vec::new();
    for face in 0..8 {
        let mut row = face * VERTICES_PER_FACE;
        for i in 0..DIVISIONS {
            let (length, next_row) = (DIVISIONS - i, row + DIVISIONS - i + 1);
            for j in 0..length {
                indices.extend([row + j, row + j + 1, next_row + j]);
                if j + 1 < length {
                    indices.extend([row + j + 1, next_row + j + 1, next_row + j]);
                }
            }
            row = next_row;
        }
    }
    indices
}
