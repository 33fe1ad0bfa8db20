//! Snapshot estimators: exact where ranges are, equal where they must be, least where they claim to be, at their bounds where
//! the papers say so, and never without an answer or a cause.
#![allow(clippy::float_cmp, reason = "where a share is none, exactly none is meant")]

mod bounds;
mod degenerate;
mod derivatives;
mod equivalences;
mod figures;
mod likelihood;
mod optimum;
mod scenes;
mod study;
#[path = "../support/mod.rs"]
mod support;
