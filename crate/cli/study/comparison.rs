//! What a study is read for: each estimator against its bound and against its own claim.

use rangelab::bounds::BoundKind;
use rangelab::model::estimator_settings::EstimatorName;
use rangelab::study::moments::Estimate;
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

/// `a/b`; the relative standard errors are added in quadrature, which overstates where the two rise and fall together.
pub fn ratio(a: Estimate, b: Estimate) -> Option<Estimate> {
    if !(a.value > 0.0 && b.value > 0.0) {
        return None;
    }
    let value = a.value / b.value;
    let (of_a, of_b) = (a.standard_error / a.value, b.standard_error / b.value);
    Some(Estimate { value, standard_error: value * (of_a * of_a + of_b * of_b).sqrt() })
}
