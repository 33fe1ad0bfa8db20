//! The WebAssembly module of the papers' figures: what they consist of, their jobs for workers, and the sum of those.
//!
//! It is a thin facade over rangelab. What goes wrong is thrown as an `Error` whose message is a sentence.

use rangelab::Error;
use rangelab::study::figures::plan::{FigurePlan, FigureSum as Sum};
use rangelab::study::figures::report::FigureReport;
use rangelab::study::figures::{FIGURES, SEED, figure};
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

/// The figures: JSON of the crate's `Figure`, in the order in which they are listed.
#[wasm_bindgen]
pub fn figures() -> String {
    json(&FIGURES)
}

/// The seed that a figure has where none is asked for.
#[wasm_bindgen]
pub fn figure_seed() -> f64 {
    SEED as f64
}

/// How many jobs a figure has; each takes about as long.
///
/// # Errors
/// A sentence where there is no such figure, or it cannot have so many trials or such a seed.
#[wasm_bindgen]
pub fn figure_jobs(name: &str, trials: usize, seed: f64) -> Result<usize, JsError> {
    Ok(plan(name, trials, seed)?.jobs())
}

/// The sums of job `job`, from 0, for [`FigureSum::push`]: numbers that mean nothing by themselves.
///
/// # Errors
/// As [`figure_jobs`]; where there is no such job, or a trial leaves double precision.
#[wasm_bindgen]
pub fn figure_block(name: &str, trials: usize, seed: f64, job: usize) -> Result<Vec<f64>, JsError> {
    let plan = plan(name, trials, seed)?;
    Ok(plan.to_numbers(&plan.job(job)?))
}

/// A figure under way.
#[wasm_bindgen]
pub struct FigureSum {
    plan: FigurePlan,
    sum: Sum,
}

#[wasm_bindgen]
impl FigureSum {
    /// No jobs yet.
    ///
    /// # Errors
    /// As [`figure_jobs`].
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str, trials: usize, seed: f64) -> Result<FigureSum, JsError> {
        let plan = plan(name, trials, seed)?;
        let sum = plan.start();
        Ok(Self { plan, sum })
    }

    /// Joins what [`figure_block`] gave for the job that comes next.
    ///
    /// # Errors
    /// A sentence where it is not that, or of another figure; the sum stays as it was.
    pub fn push(&mut self, numbers: &[f64]) -> Result<(), JsError> {
        Ok(self.sum.merge(&self.plan.from_numbers(numbers)?)?)
    }

    /// Jobs so far.
    pub fn jobs(&self) -> usize {
        self.sum.jobs()
    }

    /// The figure of the jobs so far: the JSON of the crate's `FigureReport`, the same text as the command line's.
    ///
    /// # Errors
    /// None for a sum of this figure.
    pub fn report(&self) -> Result<String, JsError> {
        Ok(self.reported()?.to_json())
    }

    /// The same as comma-separated values, again the command line's.
    ///
    /// # Errors
    /// As [`FigureSum::report`].
    pub fn csv(&self) -> Result<String, JsError> {
        Ok(self.reported()?.to_csv())
    }
}

impl FigureSum {
    fn reported(&self) -> rangelab::Result<FigureReport> {
        self.plan.report(&self.sum)
    }
}

fn plan(name: &str, trials: usize, seed: f64) -> rangelab::Result<FigurePlan> {
    FigurePlan::new(figure(name)?, trials, whole(seed)?)
}

/// Whole numbers up to here are doubles: 2^53.
const MOST_SEED: f64 = 9_007_199_254_740_992.0;

/// A seed of the browser, where every number is a double.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked before")]
fn whole(seed: f64) -> rangelab::Result<u64> {
    if (0.0..=MOST_SEED).contains(&seed) && seed.to_bits() == (seed as u64 as f64).to_bits() {
        return Ok(seed as u64);
    }
    Err(Error::Number { what: "the seed", value: seed, limit: "a whole number from 0 to 2^53" })
}
