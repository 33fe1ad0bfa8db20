//! Floor 3: one run or many, and what they say about an estimator.

pub mod anchor_draws;
pub mod block;
mod bound_tally;
pub mod budget;
mod digits;
pub mod error;
pub mod exploration;
pub mod figures;
mod flat;
pub mod indoor;
pub mod kinematics;
pub mod localization;
pub mod moments;
pub mod monte_carlo;
pub mod quantile;
pub mod report;
pub mod spending;
pub mod tally;
pub mod track_run;
