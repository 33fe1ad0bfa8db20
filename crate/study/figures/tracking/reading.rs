//! Numbers of a study by estimator and step.

use crate::bounds::BoundKind;
use crate::model::estimator_settings::EstimatorName;
use crate::study::moments::Estimate;
use crate::study::report::{BoundSummary, StudyReport};
use crate::study::tally::Summary;

/// A study that is asked for numbers which it may lack.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a>(pub(super) &'a StudyReport);

impl<'a> Reading<'a> {
    /// How many steps there are.
    pub(super) fn steps(self) -> usize {
        self.0.estimators.first().map_or(0, |estimator| estimator.steps.len())
    }

    /// A figure of an estimator at step `k`.
    pub(super) fn at(
        self,
        name: EstimatorName,
        k: usize,
        read: fn(&Summary) -> Estimate,
    ) -> Option<Estimate> {
        let estimator = self.0.estimators.iter().find(|estimator| estimator.name == name)?;
        estimator.steps.get(k).filter(|step| step.trials > 0).map(read)
    }

    /// Ratio of two estimators.
    pub(super) fn versus(
        self,
        a: EstimatorName,
        b: EstimatorName,
        k: usize,
        read: fn(&Summary) -> Estimate,
    ) -> Option<Estimate> {
        self.at(a, k, read)?.over(self.at(b, k, read)?)
    }

    /// Ratio of an error to the posterior bound on rotations.
    pub(super) fn over_bound(
        self,
        name: EstimatorName,
        k: usize,
        error: fn(&Summary) -> Estimate,
        least: fn(&BoundSummary) -> Estimate,
    ) -> Option<Estimate> {
        self.at(name, k, error)?.over(least(self.bound(BoundKind::PosteriorCrb, k)?))
    }

    /// The posterior bound on any matrix `Q`.
    pub(super) fn linear_bound(self, k: usize) -> Option<&'a BoundSummary> {
        self.bound(BoundKind::LinearPosteriorCrb, k)
    }

    /// How much farther it is than the one on rotations.
    pub(super) fn linear_over_intrinsic(self, k: usize) -> Option<Estimate> {
        self.linear_bound(k)?.orientation.over(self.bound(BoundKind::PosteriorCrb, k)?.orientation)
    }

    fn bound(self, kind: BoundKind, k: usize) -> Option<&'a BoundSummary> {
        let bound = self.0.bounds.iter().find(|bound| bound.name == kind.name())?;
        bound.steps.get(k).filter(|step| step.trials > 0)
    }
}
