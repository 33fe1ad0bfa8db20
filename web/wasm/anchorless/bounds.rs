//! The Cramér-Rao bounds beside the errors, and around the nodes.

use rangelab::Result;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::study::kinematics::bounds::{
    KinematicsBoundReport, NodeQuantity, kinematics_bounds, node_covariances,
};
use rangelab::study::kinematics::errors::Yardstick;
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

use crate::study::scenarios;

/// The bounds of a kinematics scenario (JSON) at each of some numbers of stamps, or at its own where there is none, each from
/// distances alone and with accelerations: a JSON list of pairs of the crate's `KinematicsBoundReport`.
///
/// # Errors
/// A sentence with every problem of the scenario at the first number of stamps that is bad.
#[wasm_bindgen]
pub fn anchorless_bounds(scenario: &str, counts: &[u32]) -> std::result::Result<String, JsError> {
    Ok(json(&scenarios(scenario, counts)?.iter().map(bounds).collect::<Result<Vec<_>>>()?))
}

fn bounds(scenario: &KinematicsScenario) -> Result<[KinematicsBoundReport; 2]> {
    let setup = scenario.setup()?;
    Ok(kinematics_bounds(scenario, &setup, &Yardstick::new(scenario, &setup)))
}

/// The bound on the covariance of the position of each node at a time (s), after one alignment at time 0, m^2: N x D x D.
///
/// # Errors
/// A sentence where the scenario (JSON) is bad, or why there is no bound.
#[wasm_bindgen]
pub fn anchorless_covariances(
    scenario: &str,
    accelerations: bool,
    time: f64,
) -> std::result::Result<Vec<f64>, JsError> {
    covariances(scenario, accelerations, NodeQuantity::Position(time))
}

/// The same of the tips of arrows, `Y_0 + factor Y_l`, the factor in s^l.
///
/// # Errors
/// As [`anchorless_covariances`], and where the motion has no such coefficient.
#[wasm_bindgen]
pub fn anchorless_tip_covariances(
    scenario: &str,
    accelerations: bool,
    coefficient: usize,
    factor: f64,
) -> std::result::Result<Vec<f64>, JsError> {
    covariances(scenario, accelerations, NodeQuantity::Tip { coefficient, factor })
}

fn covariances(
    scenario: &str,
    accelerations: bool,
    quantity: NodeQuantity,
) -> std::result::Result<Vec<f64>, JsError> {
    let covariances = node_covariances(&KinematicsScenario::from_json(scenario)?, accelerations, quantity)?;
    Ok(covariances.iter().flatten().copied().collect())
}
