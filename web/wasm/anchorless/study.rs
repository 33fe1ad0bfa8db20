//! A Monte-Carlo study in pieces, at the stamps of the scenario or over a sweep of their number.

use rangelab::Error;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::study::kinematics::block::KinematicsBlock;
use rangelab::study::kinematics::monte_carlo::KinematicsMonteCarlo;
use rangelab::study::monte_carlo::TRIALS_PER_BLOCK;
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

/// Trials that are summed before their sum is joined to others. A study starts its pieces at multiples of it.
#[wasm_bindgen]
pub fn anchorless_trials_per_block() -> usize {
    TRIALS_PER_BLOCK
}

/// The sums over one block of trials of a kinematics scenario (JSON), at each of some numbers of stamps, or at its own where
/// there is none; for [`AnchorlessSum::push`]: numbers that mean nothing by themselves.
///
/// # Errors
/// A sentence where the scenario, a number of stamps or the first trial is bad.
#[wasm_bindgen]
pub fn anchorless_block(scenario: &str, counts: &[u32], first_trial: usize) -> Result<Vec<f64>, JsError> {
    if !first_trial.is_multiple_of(TRIALS_PER_BLOCK) {
        let (value, limit) = (first_trial as f64, "a multiple of 20");
        return Err(Error::Number { what: "the first trial of a block", value, limit }.into());
    }
    let mut numbers = Vec::new();
    for scenario in scenarios(scenario, counts)? {
        let study = KinematicsMonteCarlo::new(&scenario, first_trial.saturating_add(TRIALS_PER_BLOCK))?;
        let block = study.block(first_trial / TRIALS_PER_BLOCK)?.to_numbers();
        numbers.push(block.len() as f64);
        numbers.extend(block);
    }
    Ok(numbers)
}

/// A study under way.
#[wasm_bindgen]
pub struct AnchorlessSum {
    /// At each number of stamps.
    sums: Vec<(KinematicsScenario, KinematicsBlock)>,
}

#[wasm_bindgen]
impl AnchorlessSum {
    /// No trials yet.
    ///
    /// # Errors
    /// A sentence with every problem of the scenario (JSON) at the first number of stamps that is bad.
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str, counts: &[u32]) -> Result<AnchorlessSum, JsError> {
        let start = |scenario: KinematicsScenario| {
            let none = KinematicsBlock::new(&scenario, 0);
            (scenario, none)
        };
        Ok(Self { sums: scenarios(scenario, counts)?.into_iter().map(start).collect() })
    }

    /// Joins what [`anchorless_block`] gave for the trials that come next.
    ///
    /// # Errors
    /// A sentence where they are not those, or of another scenario or sweep; the sums stay as they were.
    pub fn push(&mut self, numbers: &[f64]) -> Result<(), JsError> {
        let (mut rest, mut next) = (numbers, self.sums.clone());
        for (scenario, sum) in &mut next {
            let (&length, after) = rest.split_first().unwrap_or((&0.0, &[]));
            let length = (0..after.len()).find(|count| (*count as f64).to_bits() == length.to_bits());
            let (block, after) = after.split_at(length.unwrap_or(after.len()));
            sum.merge(&KinematicsBlock::from_numbers(scenario, block)?)?;
            rest = after;
        }
        if !rest.is_empty() {
            let what = "numbers after the last block";
            return Err(Error::Size { what, found: rest.len(), expected: 0 }.into());
        }
        self.sums = next;
        Ok(())
    }

    /// The figures so far: JSON, the crate's `KinematicsReport` at each number of stamps, without its bounds.
    ///
    /// # Errors
    /// Never for the scenario that [`AnchorlessSum::new`] took.
    pub fn reports(&self) -> Result<String, JsError> {
        let report = |(scenario, sum): &(KinematicsScenario, KinematicsBlock)| {
            Ok(KinematicsMonteCarlo::new(scenario, sum.trials().max(1))?.report_beside(sum, Vec::new()))
        };
        Ok(json(&self.sums.iter().map(report).collect::<Result<Vec<_>, Error>>()?))
    }
}

/// The scenario with each number of stamps, evenly over the same interval; as it is where there is none.
pub(crate) fn scenarios(scenario: &str, counts: &[u32]) -> Result<Vec<KinematicsScenario>, JsError> {
    let scenario = KinematicsScenario::from_json(scenario)?;
    if counts.is_empty() {
        return Ok(vec![scenario]);
    }
    let with = |&count: &u32| {
        let stamps = scenario.stamps.evenly(count as usize);
        let swept = KinematicsScenario { stamps, ..scenario.clone() };
        swept.setup()?;
        Ok(swept)
    };
    counts.iter().map(with).collect()
}
