//! A smooth curve through given points, by the length travelled along it.

use alloc::vec::Vec;

use nalgebra::SVector;

use crate::math::float::sqrt;

/// Pieces of the table of lengths between two points: speed is even to about one percent, less so where the curve turns
/// back sharply.
const SAMPLES: usize = 32;

/// A centripetal Catmull-Rom curve: a cubic between each two points, continuous in its tangent, without loops or cusps
/// inside a cubic (C. Yuksel, S. Schaefer, J. Keyser, *Parameterization and applications of Catmull-Rom curves*, 2011).
///
/// The knots are `t_(i+1) = t_i + ||p_(i+1) - p_i||^(1/2)`. An open curve goes on straight beyond its ends, so that it
/// leaves the first point towards the second.
///
/// ```
/// use nalgebra::Vector2;
/// use rangelab::model::path::Curve;
/// let straight = Curve::through(&[Vector2::new(0.0, 0.0), Vector2::new(3.0, 4.0)], false);
/// assert!((straight.length() - 5.0).abs() < 1e-12);
/// assert!((straight.position_and_tangent(0.5).0 - Vector2::new(1.5, 2.0)).norm() < 1e-12);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<const D: usize> {
    cubics: Vec<Cubic<D>>,
    /// Length from the start to each sample, m; [`SAMPLES`] to a cubic, and the end.
    lengths: Vec<f64>,
}

impl<const D: usize> Curve<D> {
    /// The curve through two or more points, neighbours apart from each other; a closed one returns to the first.
    ///
    /// # Panics
    /// With fewer than two points.
    pub fn through(points: &[SVector<f64, D>], closed: bool) -> Self {
        assert!(points.len() > 1, "a curve joins at least two points");
        let count = points.len();
        let last = if closed { count } else { count - 1 };
        let point = |i: usize| points[i % count];
        let cubics = (0..last).map(|i| {
            let (from, to) = (point(i), point(i + 1));
            let before = if closed || i > 0 { point(i + count - 1) } else { from * 2.0 - to };
            let after = if closed || i + 2 < count { point(i + 2) } else { to * 2.0 - from };
            Cubic::between([before, from, to, after])
        });
        let cubics: Vec<Cubic<D>> = cubics.collect();
        let lengths = lengths(&cubics);
        Self { cubics, lengths }
    }

    /// Its length, m: that of a polygon with `SAMPLES` corners to a cubic.
    pub fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// The point at a part of the length, from 0 to 1, and the direction there: a vector of any length, zero where the
    /// curve turns back on itself.
    pub fn position_and_tangent(&self, part: f64) -> (SVector<f64, D>, SVector<f64, D>) {
        let travelled = part * self.length();
        let after = self.lengths.partition_point(|&length| length <= travelled);
        let sample = after.clamp(1, self.lengths.len() - 1) - 1;
        let (from, to) = (self.lengths[sample], self.lengths[sample + 1]);
        let cubic = &self.cubics[sample / SAMPLES];
        let parameter = |within: f64| ((sample % SAMPLES) as f64 + within) / SAMPLES as f64;
        let speed = |within: f64| cubic.tangent(parameter(within)).norm();
        let here = parameter(accelerated((travelled - from) / (to - from), speed(0.0), speed(1.0)));
        (cubic.position(here), cubic.tangent(here))
    }
}

/// `p(u) = c_0 + c_1 u + c_2 u^2 + c_3 u^3`, `u` from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cubic<const D: usize>([SVector<f64, D>; 4]);

impl<const D: usize> Cubic<D> {
    /// Joins the second point to the third; the tangents there come from the neighbours.
    fn between(points: [SVector<f64, D>; 4]) -> Self {
        let chord = |i: usize| points[i + 1] - points[i];
        let knot: [f64; 3] = core::array::from_fn(|i| sqrt(chord(i).norm()));
        let slope = |i: usize| chord(i) / knot[i];
        // The derivative, at a point, of the parabola through it and its two neighbours.
        let derivative =
            |i: usize| slope(i) + slope(i + 1) - (chord(i) + chord(i + 1)) / (knot[i] + knot[i + 1]);
        let (from, along) = (points[1], chord(1));
        let (out, into) = (derivative(0) * knot[1], derivative(1) * knot[1]);
        Self([from, out, along * 3.0 - out * 2.0 - into, out + into - along * 2.0])
    }

    fn position(&self, u: f64) -> SVector<f64, D> {
        let [c0, c1, c2, c3] = self.0;
        c0 + (c1 + (c2 + c3 * u) * u) * u
    }

    fn tangent(&self, u: f64) -> SVector<f64, D> {
        let [_, c1, c2, c3] = self.0;
        c1 + (c2 * 2.0 + c3 * (3.0 * u)) * u
    }
}

/// When, from 0 to 1, a part of the way is behind a point whose speed goes evenly from one value to another: the root of
/// `part (from + to) = 2 from x + (to - from) x^2`, written so that equal speeds and rest at the start are no exceptions.
fn accelerated(part: f64, from: f64, to: f64) -> f64 {
    if part == 0.0 {
        return 0.0;
    }
    part * (from + to) / (from + sqrt(from * from + part * (to * to - from * from)))
}

fn lengths<const D: usize>(cubics: &[Cubic<D>]) -> Vec<f64> {
    let mut lengths = Vec::with_capacity(cubics.len() * SAMPLES + 1);
    let mut travelled = 0.0;
    lengths.push(travelled);
    for cubic in cubics {
        let mut before = cubic.position(0.0);
        for i in 1..=SAMPLES {
            let here = cubic.position(i as f64 / SAMPLES as f64);
            travelled += (here - before).norm();
            lengths.push(travelled);
            before = here;
        }
    }
    lengths
}
