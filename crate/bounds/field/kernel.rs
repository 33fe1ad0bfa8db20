//! The UC-CRB at one point as straight arithmetic, written once for all who compute it ([`Number`]).
//!
//! With levers `l_n = R c_n` in the world frame and `u = a_m - s_n`, `s_n = p + l_n`, a turn `phi` about the body's origin
//! (world axes) and a shift `tau` change the squared range by `-2 u.(tau + phi x l_n)`. So the information about
//! `(phi, tau)` is that of each sensor, `R_n = 4 sum_m w_mn v v^T`, carried over by `[hat(l_n); I]`
//! (the normal equations on the tangent space; \[L\] eq. 42, corrected), with `v = u` for the squared ranges as they are
//! and `v = a_m` less its weighted mean where `||s||^2` is projected out.
//!
//! Vectors have three entries, the third 0 in the plane; there the information about `(phi_z, tau_x, tau_y)` is used.

use crate::math::number::Number;

/// Entries of a symmetric 3 x 3 matrix: xx, xy, xz, yy, yz, zz.
pub type Symmetric<N> = [N; 6];
/// Row and column to the entry.
pub const ENTRY: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];

/// Weight of a pair, 4/variance of its squared range (1/m^2 after the information's factor 4): the law of
/// [`crate::model::noise::RangeNoise::squared_range_variance`]. Zero beyond `max_squared_range`.
#[inline]
pub fn weight<N: Number>(squared: N, [linear, quadratic]: [N; 2], floor: N, max_squared_range: N) -> N {
    let s = squared.larger(floor);
    let w = s.constant(4.0) / ((linear + quadratic * s) * s);
    N::choose(squared.above(max_squared_range), s.constant(0.0), w)
}

/// Adds `w v v^T`.
#[inline]
pub fn add_square<N: Number>(sum: &mut Symmetric<N>, w: N, v: [N; 3]) {
    let scaled = v.map(|x| w * x);
    for i in 0..3 {
        for j in i..3 {
            sum[ENTRY[i][j]] = sum[ENTRY[i][j]] + scaled[i] * v[j];
        }
    }
}

/// A weighted scatter about the mean, in one pass (West): the mean so far moves with each point.
#[derive(Clone, Copy)]
pub struct Scatter<N> {
    /// Sum of weights.
    pub weight: N,
    /// Mean of the points.
    pub mean: [N; 3],
    /// Scatter about it.
    pub square: Symmetric<N>,
}

impl<N: Number> Scatter<N> {
    /// No points.
    #[inline]
    pub fn empty(zero: N) -> Self {
        Self { weight: zero, mean: [zero; 3], square: [zero; 6] }
    }

    /// One more point.
    #[inline]
    pub fn add(&mut self, w: N, point: [N; 3]) {
        let zero = w.constant(0.0);
        let total = self.weight + w;
        let share = N::choose(total.above(zero), w / total, zero);
        let off: [N; 3] = core::array::from_fn(|i| point[i] - self.mean[i]);
        add_square(&mut self.square, self.weight * share, off);
        for i in 0..3 {
            self.mean[i] = self.mean[i] + share * off[i];
        }
        self.weight = total;
    }
}

/// The information about a pose: 6 x 6 symmetric, turn before shift; only the lower triangle is kept up.
pub type Information<N> = [[N; 6]; 6];

/// Adds the ranges of one sensor with information `r` and lever `l`.
#[inline]
pub fn add_sensor<N: Number>(j: &mut Information<N>, r: &Symmetric<N>, l: [N; 3]) {
    // Column k of hat(l) R: l x (column k of R).
    let mut turned = [[r[0]; 3]; 3];
    for k in 0..3 {
        let column = [r[ENTRY[0][k]], r[ENTRY[1][k]], r[ENTRY[2][k]]];
        turned[k] = cross(l, column);
    }
    for i in 0..3 {
        for k in 0..3 {
            // Lower left: R hat(l)^T, the transpose of hat(l) R.
            j[3 + i][k] = j[3 + i][k] + turned[i][k];
        }
    }
    for i in 0..3 {
        // Row i of hat(l) R, turned again: hat(l) R hat(l)^T.
        let row = [turned[0][i], turned[1][i], turned[2][i]];
        let twice = cross(l, row);
        for k in 0..=i {
            j[i][k] = j[i][k] + twice[k];
            j[3 + i][3 + k] = j[3 + i][3 + k] + r[ENTRY[i][k]];
        }
    }
}

#[inline]
fn cross<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The trace of the bound on the last `wanted` of the parameters `order` (indices into the information), and the least
/// part of an information that was left once the parameters before it were unknown too: it tells how many digits the
/// trace has.
///
/// The parameters before are eliminated (`L D L^T`), what is left of the wanted ones is inverted.
#[inline]
pub fn trace_of_bound<N: Number>(j: &Information<N>, order: &[usize], wanted: usize) -> (N, N) {
    let n = order.len();
    let at = |i: usize, k: usize| {
        let (a, b) = (order[i], order[k]);
        if a >= b { j[a][b] } else { j[b][a] }
    };
    let zero = j[0][0].constant(0.0);
    let one = j[0][0].constant(1.0);
    let mut lower = [[zero; 6]; 6];
    let mut inverse_pivot = [one; 6];
    let mut digits = one;
    for k in 0..n {
        let mut pivot = at(k, k);
        for i in 0..k {
            pivot = pivot - lower[k][i] * lower[k][i] * inverse_pivot[i];
        }
        // The quotient of nothing by nothing is no number, and not above anything.
        let part = pivot / at(k, k);
        digits = N::choose(part.above(digits), digits, N::choose(part.above(zero), part, zero));
        inverse_pivot[k] = one / pivot;
        for i in k + 1..n {
            let mut entry = at(i, k);
            for m in 0..k {
                entry = entry - lower[i][m] * lower[k][m] * inverse_pivot[m];
            }
            lower[i][k] = entry;
        }
    }
    (trace_of_inverse(&lower, &inverse_pivot, n, wanted), digits)
}

/// The trace of the last block of the inverse of `L D L^T`; `lower` holds `L D` below its diagonal.
#[inline]
fn trace_of_inverse<N: Number>(lower: &[[N; 6]; 6], inverse_pivot: &[N; 6], n: usize, wanted: usize) -> N {
    let zero = inverse_pivot[0].constant(0.0);
    let mut trace = zero;
    for column in n - wanted..n {
        // Column of L^-1 by forward substitution; its squares over the pivots add up to the diagonal.
        let mut x = [zero; 6];
        x[column] = zero.constant(1.0);
        trace = trace + inverse_pivot[column];
        for i in column + 1..n {
            let mut sum = zero;
            for k in column..i {
                sum = sum - lower[i][k] * inverse_pivot[k] * x[k];
            }
            x[i] = sum;
            trace = trace + sum * sum * inverse_pivot[i];
        }
    }
    trace
}

/// Least information over the largest, among those of one unit: below rounding, the least is none.
#[inline]
pub fn least_part<N: Number>(j: &Information<N>, parameters: &[usize]) -> N {
    let first = j[parameters[0]][parameters[0]];
    let (mut least, mut most) = (first, first);
    for &i in &parameters[1..] {
        let entry = j[i][i];
        least = N::choose(entry.above(least), least, entry);
        most = most.larger(entry);
    }
    least / most
}
