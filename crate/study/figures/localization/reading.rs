//! Numbers of a sweep by estimator and noise.

use crate::model::localize_settings::LocalizerName;
use crate::study::figures::extreme;
use crate::study::localization::SnapshotBound;
use crate::study::localization::report::{LocalizationReport, SnapshotBoundSummary, SnapshotSummary};
use crate::study::moments::Estimate;

/// A figure of an estimator.
pub(super) type Read = fn(&SnapshotSummary) -> Option<Estimate>;
/// A figure of a bound.
pub(super) type ReadBound = fn(&SnapshotBoundSummary) -> Option<Estimate>;

/// From one point of the sweep to the next, dB.
const STEP_DB: usize = 5;

/// A sweep that is asked for numbers which it may lack. Noises are named by their `zeta`, dB.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a>(pub(super) &'a LocalizationReport);

impl Reading<'_> {
    /// A figure of an estimator.
    pub(super) fn at(self, name: LocalizerName, zeta_db: usize, read: Read) -> Option<Estimate> {
        let estimator = self.0.estimators.iter().find(|estimator| estimator.name == name)?;
        estimator.points.get(zeta_db / STEP_DB).filter(|point| point.trials > 0).and_then(read)
    }

    /// A figure of a bound.
    pub(super) fn bound(self, kind: SnapshotBound, zeta_db: usize, read: ReadBound) -> Option<Estimate> {
        let bound = self.0.bounds.iter().find(|bound| bound.name == kind.name())?;
        bound.points.get(zeta_db / STEP_DB).and_then(read)
    }

    /// Ratio of two estimators.
    pub(super) fn versus(
        self,
        a: LocalizerName,
        b: LocalizerName,
        zeta_db: usize,
        read: Read,
    ) -> Option<Estimate> {
        self.at(a, zeta_db, read)?.over(self.at(b, zeta_db, read)?)
    }
}

/// Where a figure is largest among the noises from one to another, and the figure.
pub(super) fn most(
    from_db: usize,
    to_db: usize,
    figure: impl Fn(usize) -> Option<Estimate>,
) -> (usize, Option<Estimate>) {
    let (index, found) = extreme::most(points(from_db, to_db), |i| figure(from_db + STEP_DB * i));
    (from_db + STEP_DB * index, found)
}

/// Where it is least.
pub(super) fn least(
    from_db: usize,
    to_db: usize,
    figure: impl Fn(usize) -> Option<Estimate>,
) -> (usize, Option<Estimate>) {
    let (index, found) = extreme::least(points(from_db, to_db), |i| figure(from_db + STEP_DB * i));
    (from_db + STEP_DB * index, found)
}

fn points(from_db: usize, to_db: usize) -> usize {
    (to_db - from_db) / STEP_DB + 1
}
