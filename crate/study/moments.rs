//! Mean and standard error of a stream of numbers.

use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::flat::{Flat, Numbers};
use crate::math::float::sqrt;

/// A number with its standard error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// One standard deviation of its sampling error.
    pub standard_error: f64,
}

impl Estimate {
    /// Its ratio to another number; `None` where one of the two is not positive.
    ///
    /// The relative standard errors are added in quadrature, which overstates where the two rise and fall together.
    ///
    /// ```
    /// use rangelab::study::moments::Estimate;
    /// let (a, b) = (Estimate { value: 3.0, standard_error: 0.3 }, Estimate { value: 2.0, standard_error: 0.0 });
    /// assert_eq!(a.over(b).map(|ratio| ratio.value), Some(1.5));
    /// assert_eq!(b.over(Estimate { value: 0.0, ..a }), None);
    /// ```
    pub fn over(self, other: Self) -> Option<Self> {
        if !(self.value > 0.0 && other.value > 0.0) {
            return None;
        }
        let value = self.value / other.value;
        let (mine, theirs) = (self.standard_error / self.value, other.standard_error / other.value);
        Some(Self { value, standard_error: value * sqrt(mine * mine + theirs * theirs) })
    }
}

/// Running mean and spread (Welford, merged by Chan's formula), so that blocks of trials can be joined in order.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: usize,
    mean: f64,
    squares: f64,
}

impl Moments {
    /// Takes one number.
    pub fn push(&mut self, x: f64) {
        self.count += 1;
        let delta = x - self.mean;
        self.mean += delta / self.count as f64;
        self.squares += delta * (x - self.mean);
    }

    /// Appends the numbers of `next`.
    pub fn merge(&mut self, next: &Self) {
        if next.count == 0 {
            return;
        }
        if self.count == 0 {
            *self = *next;
            return;
        }
        let share = next.count as f64 / (self.count + next.count) as f64;
        let delta = next.mean - self.mean;
        self.mean += delta * share;
        self.squares += next.squares + delta * delta * self.count as f64 * share;
        self.count += next.count;
    }

    /// How many numbers were taken.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Mean with its standard error; zero for no numbers, standard error zero for one.
    pub fn mean(&self) -> Estimate {
        let variance = if self.count > 1 { self.squares / (self.count - 1) as f64 } else { 0.0 };
        let standard_error = if self.count > 0 { sqrt(variance / self.count as f64) } else { 0.0 };
        Estimate { value: self.mean, standard_error }
    }

    /// Root of the mean, for squared errors: RMSE with its standard error by the delta method, `se/(2 root)`.
    ///
    /// ```
    /// let mut moments = rangelab::study::moments::Moments::default();
    /// [9.0, 25.0, 16.0].into_iter().for_each(|squared_error| moments.push(squared_error));
    /// assert_eq!(moments.root_mean().value, (50.0f64 / 3.0).sqrt());
    /// ```
    pub fn root_mean(&self) -> Estimate {
        let mean = self.mean();
        let value = sqrt(mean.value.max(0.0));
        let standard_error = if value > 0.0 { mean.standard_error / (2.0 * value) } else { 0.0 };
        Estimate { value, standard_error }
    }
}

impl Flat for Moments {
    const LENGTH: usize = 3;

    fn write(&self, to: &mut Vec<f64>) {
        to.extend([self.count as f64, self.mean, self.squares]);
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        Self { count: from.count(), mean: from.number(), squares: from.number() }
    }
}
