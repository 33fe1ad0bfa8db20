//! What share of numbers lies below what.

use alloc::vec::Vec;

/// The number that a share (0 to 1) of the given ones does not exceed, on a straight line between neighbours; `None` for
/// no numbers. Those without an order (NaN) are left out.
///
/// ```
/// use rangelab::study::quantile::quantile;
/// assert_eq!(quantile([3.0, 1.0, 2.0].into_iter(), 0.5), Some(2.0));
/// assert_eq!(quantile([1.0, 2.0].into_iter(), 0.75), Some(1.75));
/// assert_eq!(quantile(core::iter::empty(), 0.5), None);
/// ```
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in a list")]
pub fn quantile(numbers: impl Iterator<Item = f64>, share: f64) -> Option<f64> {
    let mut sorted: Vec<f64> = numbers.filter(|number| !number.is_nan()).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    let place = share.clamp(0.0, 1.0) * last as f64;
    let below = place as usize;
    let above = (below + 1).min(last);
    Some(sorted[below] + (place - below as f64) * (sorted[above] - sorted[below]))
}
