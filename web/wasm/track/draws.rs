//! Anchors fixed and drawn anew, in pieces: blocks of draws from workers, joined where they are shown.

use rangelab::model::scenario::Scenario;
use rangelab::study::anchor_draws::{AnchorDraws, Deviation, Draw, Pair};
use rangelab::study::monte_carlo::TRIALS_PER_BLOCK;
use rangelab::study::quantile::quantile;
use wasm_bindgen::prelude::*;

/// One block of draws of a scenario (JSON), for [`DrawList::push`].
///
/// # Errors
/// A sentence where the scenario or the number of the draw is bad.
#[wasm_bindgen]
pub fn draws_block(scenario: &str, first_draw: usize) -> Result<Vec<f64>, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    let study = AnchorDraws::new(&scenario, crate::end_of_block(first_draw)?)?;
    Ok(Pair::to_numbers(&study.block(first_draw / TRIALS_PER_BLOCK)?))
}

/// Half the width of the cube around the origin in which a scenario's (JSON) anchors are drawn anew, m.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn draws_half_width(scenario: &str) -> Result<f64, JsError> {
    Ok(AnchorDraws::new(&Scenario::from_json(scenario)?, 1)?.half_width())
}

/// Draws so far. NaN stands where there is no number: anchors in a plane have no condition, estimators that failed no
/// error.
#[wasm_bindgen]
#[derive(Default)]
pub struct DrawList(Vec<Pair>);

#[wasm_bindgen]
impl DrawList {
    /// No draws yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> DrawList {
        Self::default()
    }

    /// Appends what [`draws_block`] gave.
    ///
    /// # Errors
    /// A sentence where the numbers are no draws.
    pub fn push(&mut self, numbers: &[f64]) -> Result<(), JsError> {
        self.0.extend(Pair::from_numbers(numbers)?);
        Ok(())
    }

    /// Draws so far.
    pub fn draws(&self) -> usize {
        self.0.len()
    }

    /// The condition of the centred anchors: the fixed ones, then each draw.
    pub fn conditions(&self) -> Vec<f64> {
        let number = |draw: &Draw| draw.condition.unwrap_or(f64::NAN);
        let fixed = self.0.first().map(|pair| number(&pair.fixed));
        fixed.into_iter().chain(self.0.iter().map(|pair| number(&pair.redrawn))).collect()
    }

    /// Rotation angles, rad, a number a draw; of the bound (0), the Kalman filter (1) or the unitarily constrained one
    /// (2), over fixed or redrawn anchors.
    pub fn angles(&self, of: usize, redrawn: bool) -> Vec<f64> {
        self.read(of, redrawn, |deviation| deviation.angle)
    }

    /// Errors of the position, m, in the same way.
    pub fn positions(&self, of: usize, redrawn: bool) -> Vec<f64> {
        self.read(of, redrawn, |deviation| deviation.position)
    }

    fn read(&self, of: usize, redrawn: bool, number: impl Fn(Deviation) -> f64) -> Vec<f64> {
        let draws = self.0.iter().map(|pair| if redrawn { &pair.redrawn } else { &pair.fixed });
        let found = draws.map(|draw| of.checked_sub(1).map_or(draw.bound, |index| draw.errors[index]));
        found.map(|deviation| deviation.map_or(f64::NAN, &number)).collect()
    }
}

/// The numbers that these shares (0 to 1) of `numbers` do not exceed; NaN for no numbers, NaN among them is left out.
#[wasm_bindgen]
pub fn quantiles(numbers: &[f64], shares: &[f64]) -> Vec<f64> {
    shares.iter().map(|&share| quantile(numbers.iter().copied(), share).unwrap_or(f64::NAN)).collect()
}
