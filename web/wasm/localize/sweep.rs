//! A sweep of the noise in pieces: blocks of trials from workers, joined where they are shown.

use rangelab::Error;
use rangelab::model::noise::RangeNoise;
use rangelab::model::scenario::Scenario;
use rangelab::study::localization::{LocalizationBlock, LocalizationStudy, TRIALS_PER_BLOCK};
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

/// Trials that are summed before their sum is joined to others. A sweep starts its pieces at multiples of it.
#[wasm_bindgen]
pub fn localization_trials_per_block() -> usize {
    TRIALS_PER_BLOCK
}

/// The sums over one block of trials of a scenario (JSON) at each noise of a sweep (JSON list), for
/// [`LocalizationSum::push`]: numbers that mean nothing by themselves.
///
/// # Errors
/// A sentence where the scenario, the sweep or the numbers of the trials are bad.
#[wasm_bindgen]
pub fn localization_block(
    scenario: &str,
    sweep: &str,
    first_trial: usize,
    trials: usize,
) -> Result<Vec<f64>, JsError> {
    if !first_trial.is_multiple_of(TRIALS_PER_BLOCK) {
        let (value, limit) = (first_trial as f64, "a multiple of 50");
        return Err(Error::Number { what: "the first trial of a block", value, limit }.into());
    }
    let scenario = Scenario::from_json(scenario)?;
    let points = points(sweep)?;
    LocalizationStudy::new(&scenario, points.clone(), trials)?;
    let study = LocalizationStudy::new(&scenario, points, first_trial.saturating_add(trials))?;
    Ok(study.block(first_trial / TRIALS_PER_BLOCK)?.to_numbers())
}

/// A sweep under way.
#[wasm_bindgen]
pub struct LocalizationSum {
    scenario: Scenario,
    points: Vec<RangeNoise>,
    sum: LocalizationBlock,
}

#[wasm_bindgen]
impl LocalizationSum {
    /// No trials yet.
    ///
    /// # Errors
    /// A sentence with every problem of the scenario (JSON) or the sweep (JSON list of noises).
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str, sweep: &str) -> Result<LocalizationSum, JsError> {
        let (scenario, points) = (Scenario::from_json(scenario)?, points(sweep)?);
        let sum = LocalizationStudy::new(&scenario, points.clone(), 1)?.start();
        Ok(Self { scenario, points, sum })
    }

    /// Joins what [`localization_block`] gave for the trials that come next.
    ///
    /// # Errors
    /// A sentence where they are not those, or of another scenario or sweep; the sum stays as it was.
    pub fn push(&mut self, numbers: &[f64]) -> Result<(), JsError> {
        let next = LocalizationBlock::from_numbers(&self.scenario, self.points.len(), numbers)?;
        self.sum.merge(&next)?;
        Ok(())
    }

    /// The figures so far: the JSON of the crate's `LocalizationReport`.
    ///
    /// # Errors
    /// Never for the scenario and sweep that [`LocalizationSum::new`] took.
    pub fn report(&self) -> Result<String, JsError> {
        let study = LocalizationStudy::new(&self.scenario, self.points.clone(), self.sum.trials().max(1))?;
        Ok(json(&study.report(&self.sum)))
    }
}

fn points(sweep: &str) -> Result<Vec<RangeNoise>, JsError> {
    serde_json::from_str(sweep)
        .map_err(|error| JsError::new(&format!("The sweep is no list of noises: {error}")))
}
