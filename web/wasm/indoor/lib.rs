//! The WebAssembly module of the lab Indoor: documents in as JSON, one trial out as typed arrays, studies in blocks.
//!
//! It is a thin facade over rangelab. What goes wrong is thrown as an `Error` whose message is a sentence.

mod run;
mod study;

use rangelab::model::indoor::IndoorScenario;
use rangelab::model::indoor::presets::{INDOOR_PRESETS, indoor_preset};
use rangelab::simulate::indoor::simulate_indoor;
use rangelab::study::indoor::run::run_indoor_recording;
use rangelab_wasm_shared::{complaints, json};
use wasm_bindgen::prelude::*;

pub use run::IndoorTrial;
pub use study::{IndoorSum, indoor_block, indoor_trials_per_block};

/// The presets: JSON `[{name, title, summary}]`.
#[wasm_bindgen]
pub fn indoor_presets() -> String {
    json(&INDOOR_PRESETS)
}

/// The indoor scenario of a preset as JSON.
///
/// # Errors
/// A sentence with the names that exist.
#[wasm_bindgen]
pub fn indoor_preset_scenario(name: &str) -> Result<String, JsError> {
    Ok(indoor_preset(name)?.to_json())
}

/// An indoor scenario (JSON) with everything that it leaves out filled in.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn complete_indoor(scenario: &str) -> Result<String, JsError> {
    Ok(IndoorScenario::from_json(scenario)?.to_json())
}

/// All that is wrong with an indoor scenario: JSON `[{path, value, limit, message}]`, empty if it can be run. Text that is
/// no indoor scenario gives one entry without a path.
#[wasm_bindgen]
pub fn validate_indoor(scenario: &str) -> String {
    complaints(IndoorScenario::from_json(scenario))
}

/// Simulates one trial of an indoor scenario (JSON) and runs its filters on it.
///
/// # Errors
/// A sentence with every problem of the scenario. A filter that fails says so in its own part of the run.
#[wasm_bindgen]
pub fn run_indoor(scenario: &str, trial: u32) -> Result<IndoorTrial, JsError> {
    let scenario = IndoorScenario::from_json(scenario)?;
    let recording = simulate_indoor(&scenario, u64::from(trial))?;
    let run = run_indoor_recording(&scenario.name, &recording, &scenario.filters);
    Ok(IndoorTrial::new(run, &recording))
}
