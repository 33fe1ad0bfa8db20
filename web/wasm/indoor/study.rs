//! A Monte-Carlo study in pieces: blocks of trials from workers, joined where they are shown.

use rangelab::Error;
use rangelab::model::indoor::IndoorScenario;
use rangelab::study::indoor::block::IndoorBlock;
use rangelab::study::indoor::monte_carlo::IndoorMonteCarlo;
use rangelab::study::monte_carlo::TRIALS_PER_BLOCK;
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

/// Trials that are summed before their sum is joined to others. A study starts its pieces at multiples of it.
#[wasm_bindgen]
pub fn indoor_trials_per_block() -> usize {
    TRIALS_PER_BLOCK
}

/// The sums over one block of trials of an indoor scenario (JSON), for [`IndoorSum::push`]: numbers that mean nothing by
/// themselves.
///
/// # Errors
/// A sentence where the scenario or the first trial is bad.
#[wasm_bindgen]
pub fn indoor_block(scenario: &str, first_trial: usize) -> Result<Vec<f64>, JsError> {
    if !first_trial.is_multiple_of(TRIALS_PER_BLOCK) {
        let (value, limit) = (first_trial as f64, "a multiple of 20");
        return Err(Error::Number { what: "the first trial of a block", value, limit }.into());
    }
    let scenario = IndoorScenario::from_json(scenario)?;
    let study = IndoorMonteCarlo::new(&scenario, first_trial.saturating_add(TRIALS_PER_BLOCK))?;
    Ok(study.block(first_trial / TRIALS_PER_BLOCK)?.to_numbers())
}

/// A study under way.
#[wasm_bindgen]
pub struct IndoorSum {
    scenario: IndoorScenario,
    sum: IndoorBlock,
}

#[wasm_bindgen]
impl IndoorSum {
    /// No trials yet.
    ///
    /// # Errors
    /// A sentence with every problem of the scenario (JSON).
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str) -> Result<IndoorSum, JsError> {
        let scenario = IndoorScenario::from_json(scenario)?;
        let sum = IndoorBlock::new(&scenario, 0);
        Ok(Self { scenario, sum })
    }

    /// Joins what [`indoor_block`] gave for the trials that come next.
    ///
    /// # Errors
    /// A sentence where they are not those, or of another scenario; the sum stays as it was.
    pub fn push(&mut self, numbers: &[f64]) -> Result<(), JsError> {
        self.sum.merge(&IndoorBlock::from_numbers(&self.scenario, numbers)?)?;
        Ok(())
    }

    /// The figures so far: the JSON of the crate's `IndoorReport`.
    ///
    /// # Errors
    /// Never for the scenario that [`IndoorSum::new`] took.
    pub fn report(&self) -> Result<String, JsError> {
        let study = IndoorMonteCarlo::new(&self.scenario, self.sum.trials().max(1))?;
        Ok(json(&study.report(&self.sum)))
    }
}
