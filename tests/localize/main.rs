//! Snapshot estimators: exact where ranges are, equal where they must be, at their bounds where the papers say so.

mod probe;
#[path = "../support/mod.rs"]
mod support;
