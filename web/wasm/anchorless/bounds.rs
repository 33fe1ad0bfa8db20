//! The Cramér-Rao bounds beside the errors, and around the nodes.

use rangelab::Result;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::study::kinematics::bounds::{
    KinematicsBoundReport, KinematicsBounds, NodeQuantity, kinematics_bounds,
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

/// The bounds of one scenario at its own stamps, made once and read often.
#[wasm_bindgen]
pub struct AnchorlessBounds {
    yardstick: Yardstick,
    bounds: KinematicsBounds,
}

#[wasm_bindgen]
impl AnchorlessBounds {
    /// From distances alone and with accelerations, each where there is one.
    ///
    /// # Errors
    /// A sentence with every problem of the scenario (JSON).
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str) -> std::result::Result<Self, JsError> {
        let scenario = KinematicsScenario::from_json(scenario)?;
        let setup = scenario.setup()?;
        let yardstick = Yardstick::new(&scenario, &setup);
        Ok(Self { bounds: KinematicsBounds::new(&scenario, &setup, &yardstick), yardstick })
    }

    /// JSON, a pair of the crate's `KinematicsBoundReport`.
    pub fn reports(&self) -> String {
        json(&self.bounds.reports(&self.yardstick))
    }

    /// The covariance of the position of each node at a time (s), after one alignment at time 0, m^2: N x D x D.
    ///
    /// # Errors
    /// A sentence why there is no bound.
    pub fn positions(&self, accelerations: bool, time: f64) -> std::result::Result<Vec<f64>, JsError> {
        self.covariances(accelerations, NodeQuantity::Position(time))
    }

    /// The same of the tips of arrows, `Y_0 + factor Y_l`, the factor in s^l.
    ///
    /// # Errors
    /// As [`AnchorlessBounds::positions`], and where the motion has no such coefficient.
    pub fn tips(
        &self,
        accelerations: bool,
        coefficient: usize,
        factor: f64,
    ) -> std::result::Result<Vec<f64>, JsError> {
        self.covariances(accelerations, NodeQuantity::Tip { coefficient, factor })
    }
}

impl AnchorlessBounds {
    fn covariances(
        &self,
        accelerations: bool,
        quantity: NodeQuantity,
    ) -> std::result::Result<Vec<f64>, JsError> {
        let covariances = self.bounds.node_covariances(accelerations, quantity)?;
        Ok(covariances.iter().flatten().copied().collect())
    }
}
