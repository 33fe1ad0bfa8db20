//! What pictures have in common: pixels with letters, and scales.

pub mod canvas;
pub mod colours;
pub mod scale;
