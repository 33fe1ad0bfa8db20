//! The trackers against independent references: the textbook gain form, brute-force minimization, finite differences, and
//! the chi-square laws; then the edges, where an answer is finite or a typed error.
#![allow(clippy::float_cmp, reason = "where bits are compared, bits are meant")]

#[path = "../support/mod.rs"]
mod support;

mod consistency;
mod constrained;
mod edges;
mod error_state;
mod gain_form;
mod noise_free;
mod projection;
mod scenario;
mod trigger;
