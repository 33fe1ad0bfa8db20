//! How claims are put.

use alloc::string::String;

use super::claim::{Claim, Interval, Source};
use crate::study::moments::Estimate;

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
