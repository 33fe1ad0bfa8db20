//! One step of a recording, and a recording: what an estimator is given.

use alloc::vec::Vec;

use super::motion::{Motion, ProcessNoise};
use super::ranges::Ranges;
use super::ranging::RangeModel;
use crate::math::pose::{Pose, Theta};

/// One epoch: the motion since the last one, then ranges. It holds no truth: an estimator cannot look.
#[derive(Clone, Debug, PartialEq)]
pub struct Epoch<const D: usize> {
    /// Known motion over the interval that ends here.
    pub motion: Motion<D>,
    /// Measured squared ranges.
    pub ranges: Ranges,
    /// True squared ranges, where the weights shall come from them; the measured ones serve otherwise.
    pub true_ranges: Option<Ranges>,
}

impl<const D: usize> Epoch<D> {
    /// The squared ranges that give the weights.
    pub fn weight_ranges(&self) -> &Ranges {
        self.true_ranges.as_ref().unwrap_or(&self.ranges)
    }
}

/// What an estimator believes before the first epoch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Initial<const D: usize> {
    /// `[Q | t]` before the first prediction.
    pub theta: Theta<D>,
    /// Variance of each entry of `[Q | t]` (\[T\] Sec. V: 100).
    pub variance: f64,
}

/// All that estimators are given: the model, the prior and the epochs; and the truth apart, for those who measure them.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording<const D: usize> {
    /// Anchors, topology and noise.
    pub model: RangeModel<D>,
    /// Belief before the first epoch.
    pub initial: Initial<D>,
    /// Process noise of each prediction.
    pub process: ProcessNoise,
    /// The epochs, in order.
    pub epochs: Vec<Epoch<D>>,
    /// The true pose at each epoch, where it is known.
    pub truth: Vec<Option<Pose<D>>>,
}
