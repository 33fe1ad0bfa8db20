//! Bodies by name: where sensors are often put, at unit size.

use alloc::vec::Vec;

use serde::Serialize;

use crate::math::float::sqrt;

/// A body that comes with the crate.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct NamedTopology {
    /// Its name.
    pub name: &'static str,
    /// What it is and what to know of it, in a few words.
    pub title: &'static str,
    /// Sensors in the body frame, their centroid at its origin and the two farthest 1 m apart.
    pub sensors: Vec<Vec<f64>>,
}

/// Name, title and sensors at any place and size.
type Outline<const D: usize> = (&'static str, &'static str, &'static [[f64; D]]);

const HALF_SQRT_3: f64 = 0.866_025_403_784_438_6;

const IN_SPACE: [Outline<3>; 7] = [
    (
        "pyramid",
        "Pyramid, the body of the tracking paper",
        &[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 0.0, 2.0]],
    ),
    (
        "tetrahedron",
        "Tetrahedron, the fewest that need no constraint",
        &[[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]],
    ),
    (
        "cube",
        "Cube",
        &[
            [-1.0, -1.0, -1.0],
            [1.0, -1.0, -1.0],
            [1.0, 1.0, -1.0],
            [-1.0, 1.0, -1.0],
            [-1.0, -1.0, 1.0],
            [1.0, -1.0, 1.0],
            [1.0, 1.0, 1.0],
            [-1.0, 1.0, 1.0],
        ],
    ),
    (
        "cross",
        "Cross, two on each axis",
        &[
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, -1.0],
        ],
    ),
    ("square", "Square, flat", &[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]]),
    ("triangle", "Triangle, flat", &[[1.0, 0.0, 0.0], [-0.5, HALF_SQRT_3, 0.0], [-0.5, -HALF_SQRT_3, 0.0]]),
    ("rod", "Rod, its roll unseen", &[[-1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
];

const IN_THE_PLANE: [Outline<2>; 4] = [
    (
        "triangle",
        "Triangle, the fewest that need no constraint",
        &[[1.0, 0.0], [-0.5, HALF_SQRT_3], [-0.5, -HALF_SQRT_3]],
    ),
    ("square", "Square", &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]),
    (
        "hexagon",
        "Hexagon",
        &[
            [1.0, 0.0],
            [0.5, HALF_SQRT_3],
            [-0.5, HALF_SQRT_3],
            [-1.0, 0.0],
            [-0.5, -HALF_SQRT_3],
            [0.5, -HALF_SQRT_3],
        ],
    ),
    ("rod", "Rod, seen only with the constraint", &[[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0]]),
];

/// The named bodies of a dimension; none where it is neither 2 nor 3.
///
/// ```
/// use rangelab::model::topologies::topologies;
/// let rod = topologies(2).into_iter().find(|body| body.name == "rod").unwrap();
/// assert_eq!(rod.sensors, [[-0.5, 0.0], [0.0, 0.0], [0.5, 0.0]]);
/// ```
pub fn topologies(dimension: usize) -> Vec<NamedTopology> {
    match dimension {
        2 => IN_THE_PLANE.iter().map(named).collect(),
        3 => IN_SPACE.iter().map(named).collect(),
        _ => Vec::new(),
    }
}

fn named<const D: usize>(&(name, title, points): &Outline<D>) -> NamedTopology {
    let mean: [f64; D] =
        core::array::from_fn(|i| points.iter().map(|point| point[i]).sum::<f64>() / points.len() as f64);
    let size = points.iter().flat_map(|a| points.iter().map(|b| distance(a, b))).fold(0.0, f64::max);
    let unit = |point: &[f64; D]| point.iter().zip(mean).map(|(x, mean)| (x - mean) / size).collect();
    NamedTopology { name, title, sensors: points.iter().map(unit).collect() }
}

fn distance<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    sqrt(a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum())
}
