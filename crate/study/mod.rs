//! Floor 3: many runs, and what they say about an estimator.

pub mod error;
pub mod moments;
pub mod monte_carlo;
pub mod tally;
