//! Laws of the mathematics that hold for every input, in the plane and in space, also at the edges: angles at and next to
//! pi, rank-deficient and graded matrices, matrices that are not positive definite.
#![allow(clippy::float_cmp, reason = "where bits are compared, bits are meant")]

#[path = "../support/mod.rs"]
mod support;

mod chi_squared;
mod metric;
mod pose;
mod positive_definite;
mod projection;
mod rotation;
mod singular;
mod tangent;
