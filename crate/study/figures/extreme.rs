//! Where a claim about every point of a curve is hardest.

use crate::study::moments::Estimate;

/// The point with the largest figure, and the figure: none if it is missing at some point.
pub(super) fn most(points: usize, figure: impl Fn(usize) -> Option<Estimate>) -> (usize, Option<Estimate>) {
    extreme(points, figure, 1.0)
}

/// The point with the least figure.
pub(super) fn least(points: usize, figure: impl Fn(usize) -> Option<Estimate>) -> (usize, Option<Estimate>) {
    extreme(points, figure, -1.0)
}

fn extreme(
    points: usize,
    figure: impl Fn(usize) -> Option<Estimate>,
    sign: f64,
) -> (usize, Option<Estimate>) {
    let height = |found: Option<Estimate>| found.map_or(f64::INFINITY, |found| sign * found.value);
    let found = (0..points).map(|k| (k, figure(k)));
    found.max_by(|(_, a), (_, b)| height(*a).total_cmp(&height(*b))).unwrap_or((0, None))
}
