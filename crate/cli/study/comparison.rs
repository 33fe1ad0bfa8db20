//! Which bound an estimator is held against.

use rangelab::bounds::BoundKind;
use rangelab::model::estimator_settings::EstimatorName;
use rangelab::study::report::{BoundSummary, StudyReport};

/// The bound on the estimators that stay rotations, given the ranges that the estimator uses.
pub fn bound_of(name: EstimatorName) -> BoundKind {
    match name {
        EstimatorName::EskfRaw => BoundKind::PosteriorCrbRaw,
        _ => BoundKind::PosteriorCrb,
    }
}

/// A bound at a step, where it exists in some trial.
pub fn bound(report: &StudyReport, kind: BoundKind, step: usize) -> Option<BoundSummary> {
    let bound = report.bounds.iter().find(|bound| bound.name == kind.name())?;
    bound.steps.get(step).copied().filter(|summary| summary.trials > 0)
}
