//! The Indoor lab: one run or many, and what they say about its filters.

pub mod block;
pub mod monte_carlo;
pub mod report;
pub mod run;
pub mod sweep;
pub mod tally;
