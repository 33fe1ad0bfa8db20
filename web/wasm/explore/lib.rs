//! The WebAssembly module of the lab Explore: what a geometry can see, over a plane too, and where anchors should stand.
//!
//! It is a thin facade over rangelab: scenarios in as JSON. What goes wrong is thrown as an `Error` whose message is a
//! sentence.

mod field;
mod place;

pub use field::{
    explore, field_layout, field_parameters, field_probe, field_program, field_rows, mounting_cloud,
    size_curve,
};
pub use place::{advise, best_next, improve, next_at};
