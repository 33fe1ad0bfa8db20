//! Floor 3: one run or many, and what they say about an estimator.

pub mod block;
mod bound_tally;
mod digits;
pub mod error;
pub mod exploration;
pub mod figures;
mod flat;
pub mod localization;
pub mod moments;
pub mod monte_carlo;
pub mod report;
pub mod tally;
pub mod track_run;
