//! Costs along a turn: trigonometric polynomials of degree 2, least where a quartic vanishes.

use super::float::{atan2, cos, sin};

/// `constant + cos1 cos x + sin1 sin x + cos2 cos 2x + sin2 sin 2x`.
///
/// A quadratic cost of an orthogonal matrix is one along every turn about a fixed axis (\[L\] eq. 66).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Harmonics {
    /// Mean over a whole turn.
    pub constant: f64,
    /// Part of `cos x`.
    pub cos1: f64,
    /// Part of `sin x`.
    pub sin1: f64,
    /// Part of `cos 2x`.
    pub cos2: f64,
    /// Part of `sin 2x`.
    pub sin2: f64,
}

impl Harmonics {
    /// The value at an angle, rad.
    pub fn at(&self, x: f64) -> f64 {
        let (c, s) = (cos(x), sin(x));
        self.constant
            + self.cos1 * c
            + self.sin1 * s
            + self.cos2 * (c * c - s * s)
            + self.sin2 * (2.0 * s * c)
    }

    /// The angle from 0 to `limit` (at most `pi/2`) with the least value; 0 itself counts.
    ///
    /// ```
    /// use rangelab::math::trigonometric::Harmonics;
    /// let cost = Harmonics { sin1: -1.0, ..Harmonics::default() };
    /// assert_eq!(cost.least_up_to(0.5), 0.5);
    /// ```
    pub fn least_up_to(&self, limit: f64) -> f64 {
        let end = sin(0.5 * limit) / cos(0.5 * limit);
        let mut best = if self.at(limit) < self.at(0.0) { limit } else { 0.0 };
        for u in self.stationary(0.0, end).into_iter().flatten() {
            best = self.better(best, 2.0 * atan2(u, 1.0));
        }
        best
    }

    /// The angle with the least value of all, from `-pi/2` to `3 pi/2`: the global minimum, without iteration from a start.
    pub fn least(&self) -> f64 {
        let opposite = Self { cos1: -self.cos1, sin1: -self.sin1, ..*self };
        let mut best = 0.0;
        for (half, from) in [(self, 0.0), (&opposite, core::f64::consts::PI)] {
            // The ends of one half are inside of the other half's chart or on its end.
            for u in half.stationary(-1.0, 1.0).into_iter().flatten().chain([-1.0, 1.0]) {
                best = self.better(best, from + 2.0 * atan2(u, 1.0));
            }
        }
        best
    }

    fn better(&self, a: f64, b: f64) -> f64 {
        if self.at(b) < self.at(a) { b } else { a }
    }

    /// The roots `u = tan(x/2)` of the slope times `(1 + u^2)^2` in an interval.
    fn stationary(&self, low: f64, high: f64) -> [Option<f64>; 4] {
        let Self { cos1, sin1, cos2, sin2, .. } = *self;
        let quartic = [
            sin1 + 2.0 * sin2,
            -2.0 * cos1 - 8.0 * cos2,
            -12.0 * sin2,
            -2.0 * cos1 + 8.0 * cos2,
            2.0 * sin2 - sin1,
        ];
        roots(&quartic, low, high)
    }
}

/// Bisections after which nothing is left of an interval.
const MAX_HALVINGS: usize = 100;

/// Real roots of a quartic (constant first) in an interval, where it changes its sign: between the roots of its derivative,
/// which are found the same way.
fn roots(quartic: &[f64; 5], low: f64, high: f64) -> [Option<f64>; 4] {
    let mut derivatives = [[0.0; 5]; 4];
    derivatives[0] = *quartic;
    for k in 1..4 {
        for i in 0..5 - k {
            derivatives[k][i] = derivatives[k - 1][i + 1] * (i + 1) as f64;
        }
    }
    let mut found = [None; 4];
    for polynomial in derivatives.iter().rev() {
        let mut next = [None; 4];
        let mut count = 0;
        let mut left = low;
        for end in found.into_iter().flatten().chain([high]) {
            if let Some(root) = root_between(polynomial, left, end) {
                next[count.min(3)] = Some(root);
                count += 1;
            }
            left = end;
        }
        found = next;
    }
    found
}

fn value_and_slope(polynomial: &[f64; 5], x: f64) -> (f64, f64) {
    polynomial.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * x + c, slope * x + value))
}

/// The root of a monotone stretch, by Newton's steps where they stay inside and halving where not.
fn root_between(polynomial: &[f64; 5], low: f64, high: f64) -> Option<f64> {
    let (at_low, at_high) = (value_and_slope(polynomial, low).0, value_and_slope(polynomial, high).0);
    if at_low == 0.0 {
        return Some(low);
    }
    if !((at_low < 0.0 && at_high >= 0.0) || (at_low > 0.0 && at_high <= 0.0)) {
        return None;
    }
    let (mut low, mut high, mut x) = (low, high, 0.5 * (low + high));
    for _ in 0..MAX_HALVINGS {
        let (value, slope) = value_and_slope(polynomial, x);
        if (value < 0.0) == (at_low < 0.0) {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= f64::EPSILON * x.abs() || high - low <= f64::EPSILON * high.abs() {
            return Some(next);
        }
        x = next;
    }
    Some(x)
}

/// The harmonics of `<X, W X>` for `X(x) = F + cos x A + sin x B`, from the products `<., W .>` of `F`, `A` and `B`.
pub(super) fn harmonics_of(products: &[[f64; 3]; 3]) -> Harmonics {
    let [f, a, b] = *products;
    Harmonics {
        constant: f[0] + 0.5 * (a[1] + b[2]),
        cos1: 2.0 * f[1],
        sin1: 2.0 * f[2],
        cos2: 0.5 * (a[1] - b[2]),
        sin2: a[2],
    }
}
