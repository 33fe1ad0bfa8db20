//! When the nodes measure.

use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

/// The least time (s) between the earliest and the latest stamp, where they are not all one: in a shorter one the powers of time
/// that divide the coefficients leave what numbers can hold.
pub const LEAST_SPREAD: f64 = 1e-6;

/// The stamps of a record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Stamps {
    /// Evenly from the first to the last, both included.
    Regular {
        /// The first, s.
        first: f64,
        /// The last, s.
        last: f64,
        /// How many, K.
        count: usize,
    },
    /// As listed, in any order.
    Listed {
        /// The stamps, s.
        times: Vec<f64>,
    },
}

impl Default for Stamps {
    /// \[A\] Sec. 5 with K = 100.
    fn default() -> Self {
        Self::Regular { first: -5.0, last: 5.0, count: 100 }
    }
}

impl Stamps {
    /// K.
    pub fn count(&self) -> usize {
        match self {
            Self::Regular { count, .. } => *count,
            Self::Listed { times } => times.len(),
        }
    }

    /// `count` stamps evenly over the same time.
    #[must_use]
    pub fn evenly(&self, count: usize) -> Self {
        let [first, last] = self.ends();
        Self::Regular { first, last, count }
    }

    /// The earliest and the latest, s.
    pub(super) fn ends(&self) -> [f64; 2] {
        match self {
            Self::Regular { first, last, .. } => [*first, *last],
            Self::Listed { times } => earliest_and_latest(times),
        }
    }

    /// The stamps, s.
    pub fn times(&self) -> Vec<f64> {
        match self {
            Self::Regular { first, last, count } => evenly(*first, *last, *count),
            Self::Listed { times } => times.clone(),
        }
    }
}

/// The ends of some stamps in any order; infinities the wrong way round where there is none.
pub fn earliest_and_latest(times: &[f64]) -> [f64; 2] {
    let earliest = times.iter().copied().fold(f64::INFINITY, f64::min);
    let latest = times.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    [earliest, latest]
}

/// Instants evenly from the first to the last; one alone stands at the first.
pub(super) fn evenly(first: f64, last: f64, count: usize) -> Vec<f64> {
    let intervals = count.saturating_sub(1).max(1) as f64;
    // Written so that the last one is exact.
    (0..count).map(|k| (first * (intervals - k as f64) + last * k as f64) / intervals).collect()
}
