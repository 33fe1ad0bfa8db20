//! Single trials, many trials as a cloud, and their averages at the scenario's own noise.

use rangelab::model::scenario::Scenario;
use rangelab::study::localization::LocalizationStudy;
use rangelab::study::localization::run;
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

/// What the enabled localizers make of the first epoch of one trial of a scenario (JSON): the JSON of the crate's
/// `SnapshotRun`.
///
/// # Errors
/// A sentence with every problem of the scenario. An estimator that fails says so in its own part of the run.
#[wasm_bindgen]
pub fn localize(scenario: &str, trial: u32) -> Result<String, JsError> {
    Ok(json(&run::localize_trial(&Scenario::from_json(scenario)?, u64::from(trial))?))
}

/// The estimates of trials `0..trials` as seen from the truth of each. Trial by trial, estimator by estimator: 1 where there
/// is a pose and else 0, 1 where it mirrors the body, iterations, `Q_hat Q^T` row by row, `t_hat - t` (m); zeros where there
/// is no pose.
///
/// # Errors
/// As [`localize`].
#[wasm_bindgen]
pub fn localization_cloud(scenario: &str, trials: u32) -> Result<Vec<f64>, JsError> {
    Ok(run::localization_cloud(&Scenario::from_json(scenario)?, 0, u64::from(trials))?)
}

/// The averages over trials `0..trials` at the noise of the scenario, and the bounds: the JSON of the crate's
/// `LocalizationReport`, with one point.
///
/// # Errors
/// As [`localize`], and for no trials or too many.
#[wasm_bindgen]
pub fn localize_at_noise(scenario: &str, trials: usize) -> Result<String, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    let study = LocalizationStudy::new(&scenario, vec![scenario.noise], trials)?;
    Ok(json(&study.run()?))
}
