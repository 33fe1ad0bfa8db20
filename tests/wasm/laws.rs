//! The laws of the mathematics, in the browser: the same files that run natively; and the golden bits of the Indoor and the
//! Anchorless lab.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::float_cmp, reason = "where bits are compared, bits are meant")]

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);

#[path = "../support/mod.rs"]
mod support;

#[path = "../golden/fingerprint.rs"]
mod fingerprint;
#[path = "../golden/indoor.rs"]
mod indoor;
#[path = "../golden/kinematics.rs"]
mod kinematics;

#[path = "../laws/chi_squared.rs"]
mod chi_squared;
#[path = "../laws/metric.rs"]
mod metric;
#[path = "../laws/pose.rs"]
mod pose;
#[path = "../laws/positive_definite.rs"]
mod positive_definite;
#[path = "../laws/projection.rs"]
mod projection;
#[path = "../laws/rotation.rs"]
mod rotation;
#[path = "../laws/singular.rs"]
mod singular;
#[path = "../laws/tangent.rs"]
mod tangent;
