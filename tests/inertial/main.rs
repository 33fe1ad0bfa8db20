//! The inertial filters against the figures of the corrected paper, an independent implementation, finite differences and
//! the chi-square law; then the edges, where an answer is finite or a typed error.
#![allow(clippy::float_cmp, reason = "where bits are compared, bits are meant")]

#[path = "../support/mod.rs"]
mod support;

mod agreement;
mod claims;
mod consistency;
mod edges;
mod equalities;
mod jacobians;
mod plain;
mod reference;
mod reference_error_state;
mod table;
