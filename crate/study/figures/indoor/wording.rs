//! How claims of \[I\] are put.

use alloc::format;
use alloc::string::String;

use crate::study::figures::claim::{Claim, Interval, Source};
use crate::study::moments::Estimate;

/// Where a claim about every noise is hardest.
pub(super) fn at_worst(what: &str, decibels: f64) -> String {
    format!("{what}, worst at {decibels} dB")
}

/// The ratio of two numbers, of which either may be missing.
pub(super) fn across(a: Option<Estimate>, b: Option<Estimate>) -> Option<Estimate> {
    a?.over(b?)
}

/// A claim of the paper.
pub(super) fn paper(what: impl Into<String>, found: Option<Estimate>, target: Interval) -> Claim {
    Claim::new(Source::Paper, what, found, target)
}

/// A claim of rangelab.
pub(super) fn beyond(what: impl Into<String>, found: Option<Estimate>, target: Interval) -> Claim {
    Claim::new(Source::Beyond, what, found, target)
}
