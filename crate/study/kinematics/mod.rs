//! Studies of the Anchorless lab: one trial as a document, or many in blocks.

pub mod block;
pub mod bounds;
pub mod deviations;
pub mod errors;
pub mod monte_carlo;
pub mod report;
pub mod run;
pub mod spectrum;
pub mod sweep;
mod tally;
