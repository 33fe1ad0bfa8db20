//! The WebAssembly module of the lab Anchorless: documents in as JSON, one trial out as typed arrays, studies in blocks.
//!
//! It is a thin facade over rangelab. What goes wrong is thrown as an `Error` whose message is a sentence.

mod bounds;
mod run;
mod study;

use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::presets::{KINEMATICS_PRESETS, kinematics_preset};
use rangelab::study::kinematics::run::run_kinematics;
use rangelab::study::kinematics::spectrum::gram_spectrum;
use rangelab_wasm_shared::{complaints, json};
use wasm_bindgen::prelude::*;

pub use bounds::{AnchorlessBounds, anchorless_bounds};
pub use run::AnchorlessTrial;
pub use study::{AnchorlessSum, anchorless_block, anchorless_trials_per_block};

/// The presets: JSON `[{name, title, summary}]`.
#[wasm_bindgen]
pub fn anchorless_presets() -> String {
    json(&KINEMATICS_PRESETS)
}

/// The kinematics scenario of a preset as JSON.
///
/// # Errors
/// A sentence with the names that exist.
#[wasm_bindgen]
pub fn anchorless_preset_scenario(name: &str) -> Result<String, JsError> {
    Ok(kinematics_preset(name)?.to_json())
}

/// A kinematics scenario (JSON) with everything that it leaves out filled in.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn complete_anchorless(scenario: &str) -> Result<String, JsError> {
    Ok(KinematicsScenario::from_json(scenario)?.to_json())
}

/// All that is wrong with a kinematics scenario: JSON `[{path, value, limit, message}]`, empty if it can be run. Text that is
/// no kinematics scenario gives one entry without a path.
#[wasm_bindgen]
pub fn validate_anchorless(scenario: &str) -> String {
    complaints(KinematicsScenario::from_json(scenario))
}

/// Simulates one trial of a kinematics scenario (JSON) and runs its estimators on it.
///
/// # Errors
/// A sentence with every problem of the scenario. An estimator that fails says so in its own part of the run.
#[wasm_bindgen]
pub fn run_anchorless(scenario: &str, trial: u32) -> Result<AnchorlessTrial, JsError> {
    let scenario = KinematicsScenario::from_json(scenario)?;
    Ok(AnchorlessTrial::new(run_kinematics(&scenario, u64::from(trial))?)?)
}

/// The eigenvalues of the Gram matrices of one trial: the JSON of the crate's `GramSpectrum`.
///
/// # Errors
/// A sentence with every problem of the scenario (JSON).
#[wasm_bindgen]
pub fn anchorless_spectrum(scenario: &str, trial: u32) -> Result<String, JsError> {
    Ok(json(&gram_spectrum(&KinematicsScenario::from_json(scenario)?, u64::from(trial))?))
}
