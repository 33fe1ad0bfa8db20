//! What projections of the ET-KF cost and give, in pieces: blocks of trials from workers, joined where they are shown.

use rangelab::Error;
use rangelab::model::scenario::Scenario;
use rangelab::study::budget::{Budget, BudgetBlock, BudgetReport, BudgetRow};
use rangelab::study::moments::Estimate;
use rangelab::study::monte_carlo::TRIALS_PER_BLOCK;
use wasm_bindgen::prelude::*;

/// The sums over one block of trials of a scenario (JSON), for [`BudgetSum::push`].
///
/// # Errors
/// A sentence where the scenario, the thresholds or the number of the trial are bad.
#[wasm_bindgen]
pub fn budget_block(scenario: &str, thresholds: &[f64], first_trial: usize) -> Result<Vec<f64>, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    let trials = crate::end_of_block(first_trial)?;
    let block = Budget::new(&scenario, thresholds, trials)?.block(first_trial / TRIALS_PER_BLOCK)?;
    Ok(block.to_numbers())
}

/// A budget under way.
#[wasm_bindgen]
pub struct BudgetSum {
    scenario: Scenario,
    thresholds: Vec<f64>,
    sum: BudgetBlock,
}

#[wasm_bindgen]
impl BudgetSum {
    /// No trials yet.
    ///
    /// # Errors
    /// A sentence where the scenario (JSON) or the thresholds are bad.
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str, thresholds: &[f64]) -> Result<BudgetSum, JsError> {
        let scenario = Scenario::from_json(scenario)?;
        let sum = Budget::new(&scenario, thresholds, 1)?.start();
        Ok(Self { scenario, thresholds: thresholds.to_vec(), sum })
    }

    /// Joins what [`budget_block`] gave for the trials that come next.
    ///
    /// # Errors
    /// A sentence where they are not those; the sum stays as it was.
    pub fn push(&mut self, numbers: &[f64]) -> Result<(), JsError> {
        Ok(self.sum.merge(&BudgetBlock::from_numbers(self.thresholds.len(), numbers)?)?)
    }

    /// Trials so far.
    pub fn trials(&self) -> usize {
        self.sum.trials()
    }

    /// Projections in a run: a value a threshold, then their standard errors.
    pub fn projections(&self) -> Vec<f64> {
        self.figures(|row| row.projections)
    }

    /// `RMSE(Q)` in the same shape: at the first step, then over all steps, then at the last.
    pub fn orientation(&self) -> Vec<f64> {
        let along: [fn(&BudgetRow) -> Estimate; 3] =
            [|row| row.orientation.first, |row| row.orientation.all, |row| row.orientation.last];
        along.iter().flat_map(|read| self.figures(read)).collect()
    }

    /// Root mean square rotation angle, rad, in that shape.
    pub fn angle(&self) -> Vec<f64> {
        let along: [fn(&BudgetRow) -> Estimate; 3] =
            [|row| row.angle.first, |row| row.angle.all, |row| row.angle.last];
        along.iter().flat_map(|read| self.figures(read)).collect()
    }
}

impl BudgetSum {
    /// The figures so far; empty where the thresholds were refused, which the constructor rules out.
    fn report(&self) -> Result<BudgetReport, Error> {
        Ok(Budget::new(&self.scenario, &self.thresholds, 1)?.report(&self.sum))
    }

    fn figures(&self, read: impl Fn(&BudgetRow) -> Estimate) -> Vec<f64> {
        let rows = self.report().map(|report| report.rows).unwrap_or_default();
        let values = rows.iter().map(|row| read(row).value);
        values.chain(rows.iter().map(|row| read(row).standard_error)).collect()
    }
}
