//! Where anchors should stand: the value of a placement, its slope, and a better one.

use rangelab::model::scenario::Scenario;
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

/// What the anchors of a scenario (JSON) are worth and how that changes with the place of each: the JSON of the crate's
/// `Advice`.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn advise(scenario: &str) -> Result<String, JsError> {
    Ok(json(&rangelab::place::advise(&Scenario::from_json(scenario)?)?))
}

/// Better places for the anchors that may move: the JSON of the crate's `Improvement`. Restart 0 begins at the anchors
/// given, the others anywhere within the limits.
///
/// # Errors
/// A sentence with every problem of the scenario, or that no placement shows the pose.
#[wasm_bindgen]
pub fn improve(scenario: &str, restart: u32) -> Result<String, JsError> {
    Ok(json(&rangelab::place::improve(&Scenario::from_json(scenario)?, u64::from(restart))?))
}

/// What one more anchor would be worth at a point of the world (D coordinates, m): the JSON of the crate's `NextPlace`.
///
/// # Errors
/// A sentence for a bad scenario or point.
#[wasm_bindgen]
pub fn next_at(scenario: &str, point: &[f64]) -> Result<String, JsError> {
    Ok(json(&rangelab::place::next_at(&Scenario::from_json(scenario)?, point)?))
}

/// Where in the plane of the scenario's field one more anchor helps most: the JSON of the crate's `NextPlace`, or null.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn best_next(scenario: &str) -> Result<String, JsError> {
    Ok(json(&rangelab::place::best_next(&Scenario::from_json(scenario)?)?))
}
