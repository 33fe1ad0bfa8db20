//! The Cramér-Rao bounds beside the errors, and around the nodes.

use rangelab::model::kinematics::KinematicsScenario;
use rangelab::study::kinematics::bounds::{kinematics_bounds, node_covariances};
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

use crate::study::scenarios;

/// The bounds of a kinematics scenario (JSON), of its positions at some instants (s): the JSON of the crate's
/// `KinematicsBounds`.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn anchorless_bounds(scenario: &str, instants: &[f64]) -> Result<String, JsError> {
    Ok(json(&kinematics_bounds(&KinematicsScenario::from_json(scenario)?, instants)?))
}

/// The instants of a kinematics scenario (JSON), s: those at which a study compares positions.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn anchorless_instants(scenario: &str) -> Result<Vec<f64>, JsError> {
    Ok(KinematicsScenario::from_json(scenario)?.instants())
}

/// The bounds of the coefficients at each of some numbers of stamps: a JSON list of the crate's `KinematicsBounds`.
///
/// # Errors
/// A sentence with every problem of the scenario (JSON) at the first number of stamps that is bad.
#[wasm_bindgen]
pub fn swept_bounds(scenario: &str, counts: &[u32]) -> Result<String, JsError> {
    let bounds = |scenario| kinematics_bounds(&scenario, &[]);
    let all = scenarios(scenario, counts)?.into_iter().map(bounds).collect::<rangelab::Result<Vec<_>>>()?;
    Ok(json(&all))
}

/// The bound on the covariance of the position of each node at a time (s), after one alignment at time 0, m^2: N x D x D.
///
/// # Errors
/// A sentence where the scenario (JSON) is bad, or why there is no bound.
#[wasm_bindgen]
pub fn anchorless_covariances(scenario: &str, accelerometers: bool, time: f64) -> Result<Vec<f64>, JsError> {
    let covariances = node_covariances(&KinematicsScenario::from_json(scenario)?, accelerometers, time)?;
    Ok(covariances.iter().flatten().copied().collect())
}
