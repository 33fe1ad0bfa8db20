//! The WebAssembly module that the page starts with: documents in as JSON, a run out as typed arrays.
//!
//! It is a thin facade over rangelab and does no arithmetic of its own but the roots of variances. What goes wrong is thrown as an `Error` whose message is
//! a sentence.

mod budget;
mod draws;
mod study;
mod track_run;

use rangelab::Error;
use rangelab::model::presets::PRESETS;
use rangelab::model::scenario::Scenario;
use rangelab::model::topologies;
use rangelab::study::monte_carlo::TRIALS_PER_BLOCK;
use rangelab::study::track_run::run_scenario;
use rangelab_wasm_shared::{complaints, json};
use wasm_bindgen::prelude::*;

pub use budget::{BudgetSum, budget_block};
pub use draws::{DrawList, draws_block, draws_half_width, quantiles};
pub use study::{StudySum, study_block};
pub use track_run::TrackRun;

/// The presets: JSON `[{name, title, summary}]`.
#[wasm_bindgen]
pub fn presets() -> String {
    json(&PRESETS)
}

/// The scenario of a preset as JSON.
///
/// # Errors
/// A sentence with the names that exist.
#[wasm_bindgen]
pub fn preset(name: &str) -> Result<String, JsError> {
    Ok(rangelab::model::presets::preset(name)?.to_json())
}

/// The named bodies of a dimension: JSON `[{name, title, sensors}]`, the two farthest sensors 1 m apart.
#[wasm_bindgen]
pub fn topologies(dimension: usize) -> String {
    json(&topologies::topologies(dimension))
}

/// A scenario (JSON) with everything that it leaves out filled in.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn complete(scenario: &str) -> Result<String, JsError> {
    Ok(Scenario::from_json(scenario)?.to_json())
}

/// The central interval of the chi-square distribution: the two numbers that hold `probability` between them and leave as
/// much below as above.
///
/// # Errors
/// A sentence where there is no such interval.
#[wasm_bindgen]
pub fn chi_squared_interval(degrees_of_freedom: f64, probability: f64) -> Result<Vec<f64>, JsError> {
    Ok(rangelab::math::chi_squared::chi_squared_interval(degrees_of_freedom, probability)?.to_vec())
}

/// All that is wrong with a scenario: JSON `[{path, value, limit, message}]`, empty if it can be run. Text that is no
/// scenario gives one entry without a path.
#[wasm_bindgen]
pub fn validate(scenario: &str) -> String {
    complaints(Scenario::from_json(scenario))
}

/// Simulates one trial of a scenario (JSON) and runs its estimators and the bounds on it.
///
/// # Errors
/// A sentence with every problem of the scenario. An estimator that fails says so in its own part of the run.
#[wasm_bindgen]
pub fn track(scenario: &str, trial: u32) -> Result<TrackRun, JsError> {
    Ok(run_scenario(&Scenario::from_json(scenario)?, u64::from(trial))?.into())
}

/// The trials up to the end of the block that begins with `first_trial`.
fn end_of_block(first_trial: usize) -> Result<usize, Error> {
    if first_trial.is_multiple_of(TRIALS_PER_BLOCK) {
        return Ok(first_trial.saturating_add(TRIALS_PER_BLOCK));
    }
    let (value, limit) = (first_trial as f64, "a multiple of 20");
    Err(Error::Number { what: "the first trial of a block", value, limit })
}
