//! The WebAssembly module of the lab Localize: what snapshot estimators make of many trials, and over a sweep of the noise.
//!
//! It is a thin facade over rangelab: scenarios in as JSON. What goes wrong is thrown as an `Error` whose message is a
//! sentence.

mod snapshot;
mod sweep;

pub use snapshot::{localization_cloud, localize, localize_at_noise};
pub use sweep::{LocalizationSum, localization_block, localization_trials_per_block};
