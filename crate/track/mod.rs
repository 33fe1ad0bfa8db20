//! Floor 2: estimators that follow a moving body, epoch by epoch.

pub mod filter;
