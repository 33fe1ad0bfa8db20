//! Sums as a row of numbers, in which they travel from a worker to whoever joins them.

use alloc::vec::Vec;

/// What is written as so many numbers and read back as the same bits.
pub(super) trait Flat {
    /// How many numbers.
    const LENGTH: usize;

    /// Appends them.
    fn write(&self, to: &mut Vec<f64>);

    /// Reads them back.
    fn read(from: &mut Numbers<'_>) -> Self;
}

/// Numbers that are read from the front; what is beyond the end is zero.
pub(super) struct Numbers<'a>(core::slice::Iter<'a, f64>);

impl<'a> Numbers<'a> {
    pub(super) fn new(numbers: &'a [f64]) -> Self {
        Self(numbers.iter())
    }

    pub(super) fn number(&mut self) -> f64 {
        self.0.next().copied().unwrap_or_default()
    }

    /// Counts are far below 2^53, up to which they are exact.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count was written as it is"
    )]
    pub(super) fn count(&mut self) -> usize {
        self.number() as usize
    }
}
