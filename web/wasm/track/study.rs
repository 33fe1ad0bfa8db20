//! A Monte-Carlo study in pieces: blocks of trials from workers, joined where they are shown.

use rangelab::bounds::BoundKind;
use rangelab::model::scenario::Scenario;
use rangelab::study::block::Block;
use rangelab::study::moments::Estimate;
use rangelab::study::monte_carlo::{MonteCarlo, TRIALS_PER_BLOCK};
use rangelab::study::report::BoundSummary;
use rangelab::study::tally::Summary;
use rangelab::with_dimension;
use rangelab_wasm_shared::{Named, json};
use wasm_bindgen::prelude::*;

/// Trials that are summed before their sum is joined to others. A study starts its pieces at multiples of it.
#[wasm_bindgen]
pub fn trials_per_block() -> usize {
    TRIALS_PER_BLOCK
}

/// The sums over some trials of a scenario (JSON), for [`StudySum::push`]: numbers that mean nothing by themselves.
///
/// # Errors
/// A sentence where the scenario or the numbers of the trials are bad, or a trial leaves double precision.
#[wasm_bindgen]
pub fn study_block(scenario: &str, first_trial: usize, trials: usize) -> Result<Vec<f64>, JsError> {
    crate::end_of_block(first_trial)?;
    let scenario = Scenario::from_json(scenario)?;
    MonteCarlo::new(&scenario, trials)?;
    let study = MonteCarlo::new(&scenario, first_trial.saturating_add(trials))?;
    let mut numbers = Vec::new();
    for index in first_trial / TRIALS_PER_BLOCK..study.blocks() {
        numbers.extend(study.block(index)?.to_numbers());
    }
    Ok(numbers)
}

/// A study under way.
#[wasm_bindgen]
pub struct StudySum {
    scenario: Scenario,
    sum: Block,
}

#[wasm_bindgen]
impl StudySum {
    /// No trials yet.
    ///
    /// # Errors
    /// A sentence with every problem of the scenario (JSON).
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str) -> Result<StudySum, JsError> {
        let scenario = Scenario::from_json(scenario)?;
        with_dimension!(scenario.dimension, D => scenario.setup::<D>().map(drop))?;
        let sum = Block::new(&scenario, 0);
        Ok(Self { scenario, sum })
    }

    /// Joins what [`study_block`] gave for the trials that come next.
    ///
    /// # Errors
    /// A sentence where they are not those, or of another scenario; the sum stays as it was.
    pub fn push(&mut self, numbers: &[f64]) -> Result<(), JsError> {
        let mut sum = self.sum.clone();
        for block in numbers.chunks(Block::length(&self.scenario)) {
            sum.merge(&Block::from_numbers(&self.scenario, block)?)?;
        }
        self.sum = sum;
        Ok(())
    }

    /// Trials so far.
    pub fn trials(&self) -> usize {
        self.sum.trials()
    }

    /// The estimators: JSON `[{name, label}]`.
    pub fn estimators(&self) -> String {
        let names = self.scenario.estimators.enabled.iter();
        json(&names.map(|name| Named { name: name.name(), label: name.label() }).collect::<Vec<_>>())
    }

    /// Root mean square rotation angle of an estimator, rad: K values, then K standard errors. NaN where no trial came.
    pub fn angle(&self, estimator: usize) -> Vec<f64> {
        self.figures(estimator, |step| step.rms_angle)
    }

    /// Root mean square error of the position, m, in the same shape.
    pub fn position(&self, estimator: usize) -> Vec<f64> {
        self.figures(estimator, |step| step.rmse_position)
    }

    /// Mean NEES over its degrees of freedom, in the same shape; 1 where the covariance is right.
    pub fn nees(&self, estimator: usize) -> Vec<f64> {
        self.figures(estimator, |step| step.nees)
    }

    /// Mean NIS over its mean degrees of freedom, in the same shape; 1 where ranges come as far off as was expected.
    pub fn nis(&self, estimator: usize) -> Vec<f64> {
        self.figures(estimator, |step| step.nis)
    }

    /// Mean degrees of freedom of the NIS: K. Missing ranges lower them.
    pub fn nis_degrees_of_freedom(&self, estimator: usize) -> Vec<f64> {
        self.sum.estimator(estimator).map(|step| step.nis_degrees_of_freedom).collect()
    }

    /// Share of the trials in which `Q` was projected, in the same shape.
    pub fn event_rate(&self, estimator: usize) -> Vec<f64> {
        self.figures(estimator, |step| step.event_rate)
    }

    /// Degrees of freedom of the NEES; 0 before the first trial.
    pub fn nees_degrees_of_freedom(&self, estimator: usize) -> usize {
        self.sum.estimator(estimator).map(|step| step.nees_degrees_of_freedom).max().unwrap_or(0)
    }

    /// Trials in which the estimator had stopped by then: K.
    pub fn failures(&self, estimator: usize) -> Vec<u32> {
        self.sum.estimator(estimator).map(|step| u32::try_from(step.failures).unwrap_or(u32::MAX)).collect()
    }

    /// The bounds that exist in some trial: JSON `[{name, label}]`.
    pub fn bounds(&self) -> String {
        let kinds = self.existing().into_iter();
        json(&kinds.map(|kind| Named { name: kind.name(), label: kind.label() }).collect::<Vec<_>>())
    }

    /// A bound on the root mean square rotation angle, rad: K values, then K standard errors, which come from the
    /// trials' own trajectories. NaN where it exists in no trial.
    pub fn angle_bound(&self, bound: usize) -> Vec<f64> {
        self.bound_figures(bound, |step| step.angle)
    }

    /// A bound on the root mean square error of the position, m, in the same shape.
    pub fn position_bound(&self, bound: usize) -> Vec<f64> {
        self.bound_figures(bound, |step| step.position)
    }
}

impl StudySum {
    /// The sums so far as one row of numbers.
    pub fn to_numbers(&self) -> Vec<f64> {
        self.sum.to_numbers()
    }

    fn figures(&self, estimator: usize, read: impl Fn(&Summary) -> Estimate) -> Vec<f64> {
        curve(self.sum.estimator(estimator).map(|step| (step.trials > 0).then(|| read(&step))))
    }

    fn bound_figures(&self, bound: usize, read: impl Fn(&BoundSummary) -> Estimate) -> Vec<f64> {
        let kind = self.existing()[bound];
        curve(self.sum.bound(kind).map(|step| (step.trials > 0).then(|| read(&step))))
    }

    fn existing(&self) -> Vec<BoundKind> {
        let exists = |kind: &BoundKind| self.sum.bound(*kind).any(|step| step.trials > 0);
        BoundKind::ALL.into_iter().filter(exists).collect()
    }
}

/// Values, then standard errors.
fn curve(steps: impl Iterator<Item = Option<Estimate>>) -> Vec<f64> {
    let nothing = Estimate { value: f64::NAN, standard_error: f64::NAN };
    let steps: Vec<Estimate> = steps.map(|step| step.unwrap_or(nothing)).collect();
    let values = steps.iter().map(|step| step.value);
    values.chain(steps.iter().map(|step| step.standard_error)).collect()
}
