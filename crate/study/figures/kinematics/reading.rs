//! Numbers of a sweep by estimator, number of stamps and what they are of.

use alloc::format;
use alloc::string::String;

use crate::math::float::sqrt;
use crate::model::kinematics::settings::KinematicsName;
use crate::study::figures::experiment::Study;
use crate::study::figures::extreme;
use crate::study::kinematics::bounds::KinematicsBoundReport;
use crate::study::kinematics::report::{KinematicsReport, KinematicsSummary};
use crate::study::kinematics::sweep::KinematicsSweepReport;
use crate::study::moments::Estimate;
use crate::study::quantile::quantile;

/// What a root mean square error is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    /// A coordinate of `Y_l`.
    Coefficient(usize),
    /// An entry of `vech(B_l)`.
    Gram(usize),
    /// A coordinate of the positions at an instant, by number, with one alignment.
    Position(usize),
    /// The same with an alignment of its own.
    AlignedPosition(usize),
}

/// Whether a bound reads accelerations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bound {
    Distances,
    Accelerations,
}

use Quantity::{AlignedPosition, Coefficient, Gram, Position};

impl Quantity {
    pub(super) fn of(self, summary: &KinematicsSummary) -> Option<Estimate> {
        let (list, index) = match self {
            Coefficient(l) => (&summary.coefficients, l),
            Gram(l) => (&summary.gram, l),
            Position(i) => (&summary.positions, i),
            AlignedPosition(i) => (&summary.aligned_positions, i),
        };
        list.get(index).copied()
    }

    pub(super) fn bound(self, bound: &KinematicsBoundReport) -> Option<Estimate> {
        let (list, index) = match self {
            Coefficient(l) => (&bound.coefficients, l),
            Gram(l) => (&bound.gram, l),
            Position(i) => (&bound.positions, i),
            AlignedPosition(i) => (&bound.aligned_positions, i),
        };
        list.get(index).map(|&value| Estimate { value, standard_error: 0.0 })
    }
}

/// Where a claim about every number of stamps is hardest.
pub(super) fn at_worst(what: &str, stamps: usize) -> String {
    format!("{what}, worst at K = {stamps}")
}

/// A sweep that is asked for numbers which it may lack.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a>(&'a KinematicsSweepReport);

impl<'a> Reading<'a> {
    /// The sweep at a place in the list of experiments.
    pub(super) fn of(studies: &'a [Study], index: usize) -> Self {
        Self(studies[index].kinematics().expect("the figures of relative kinematics have such experiments"))
    }

    /// A study for each number of stamps.
    pub(super) fn points(self) -> &'a [KinematicsReport] {
        &self.0.points
    }

    /// A number of an estimator; none where it failed in some trial, for what is left of them is a choice of easy ones.
    pub(super) fn at(self, name: KinematicsName, stamps: usize, quantity: Quantity) -> Option<Estimate> {
        quantity.of(self.complete(name, stamps)?)
    }

    /// A number of a bound.
    pub(super) fn bound(self, bound: Bound, stamps: usize, quantity: Quantity) -> Option<Estimate> {
        quantity.bound(bound_of(self.point(stamps)?, bound)?)
    }

    /// Ratio of two estimators.
    pub(super) fn versus(
        self,
        a: KinematicsName,
        b: KinematicsName,
        stamps: usize,
        quantity: Quantity,
    ) -> Option<Estimate> {
        self.at(a, stamps, quantity)?.over(self.at(b, stamps, quantity)?)
    }

    /// Ratio of an estimator and a bound.
    pub(super) fn over_bound(
        self,
        name: KinematicsName,
        bound: Bound,
        stamps: usize,
        quantity: Quantity,
    ) -> Option<Estimate> {
        self.at(name, stamps, quantity)?.over(self.bound(bound, stamps, quantity)?)
    }

    /// What half of the trials of an estimator stay below in `Y_1`, m/s, with the standard error that the spread of the trials
    /// next to it gives.
    pub(super) fn median_velocity_error(self, name: KinematicsName, stamps: usize) -> Option<Estimate> {
        let errors = &self.complete(name, stamps)?.velocity_distribution;
        let at = |share| quantile(errors.iter().copied(), share);
        let reach = 0.5 / sqrt(errors.len() as f64);
        Some(Estimate { value: at(0.5)?, standard_error: 0.5 * (at(0.5 + reach)? - at(0.5 - reach)?) })
    }

    /// The number of stamps at which a number is largest, and the number.
    pub(super) fn most(self, number: impl Fn(usize) -> Option<Estimate>) -> (usize, Option<Estimate>) {
        let points = self.points();
        let (index, found) = extreme::most(points.len(), |i| number(points[i].stamps));
        (points.get(index).map_or(0, |point| point.stamps), found)
    }

    /// The summary of an estimator that gave an estimate in every trial.
    fn complete(self, name: KinematicsName, stamps: usize) -> Option<&'a KinematicsSummary> {
        summary(self.point(stamps)?, name).filter(|summary| summary.failures == 0)
    }

    fn point(self, stamps: usize) -> Option<&'a KinematicsReport> {
        self.points().iter().find(|point| point.stamps == stamps)
    }
}

/// The summary of an estimator, where it gave an estimate in some trial.
pub(super) fn summary(point: &KinematicsReport, name: KinematicsName) -> Option<&KinematicsSummary> {
    let found = point.estimators.iter().find(|each| each.name == name)?;
    Some(&found.summary).filter(|summary| summary.trials > 0)
}

/// The bound from distances, or with accelerations.
pub(super) fn bound_of(point: &KinematicsReport, bound: Bound) -> Option<&KinematicsBoundReport> {
    point.bounds.iter().find(|each| each.accelerations == (bound == Bound::Accelerations))
}
