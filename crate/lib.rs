//! Position **and orientation** of a rigid body from ranges between sensors on it and known anchors.
// Without `std` no platform mathematics can slip in. The macros of `typescript`, which only write types, need it.
#![cfg_attr(not(feature = "typescript"), no_std)]

extern crate alloc;

pub mod bounds;
pub mod error;
pub mod math;
pub mod model;
pub mod simulate;
pub mod study;
pub mod track;

pub use error::{Error, Problem, Result};

/// The program in the README, run by rustdoc.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
