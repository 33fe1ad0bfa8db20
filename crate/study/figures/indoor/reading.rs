//! Numbers of a sweep by filter and point.

use alloc::format;
use alloc::string::String;

use crate::math::float::sqrt;
use crate::model::indoor::filter_settings::FilterName;
use crate::study::figures::experiment::Study;
use crate::study::figures::extreme;
use crate::study::indoor::report::IndoorSummary;
use crate::study::indoor::sweep::IndoorSweepReport;
use crate::study::moments::Estimate;
use crate::study::quantile::quantile;

/// A figure of a filter.
pub(super) type Read = fn(&IndoorSummary) -> Estimate;

pub(super) const POSITION: Read = |s| s.position;
pub(super) const ANGLE: Read = |s| s.angle;

/// Where a claim about every noise is hardest.
pub(super) fn at_worst(what: &str, decibels: f64) -> String {
    format!("{what}, worst at {decibels} dB")
}

/// A sweep that is asked for numbers which it may lack.
#[derive(Clone, Copy)]
pub(super) struct Reading<'a>(&'a IndoorSweepReport);

impl<'a> Reading<'a> {
    /// The sweep at a place in the list of experiments.
    pub(super) fn of(studies: &'a [Study], index: usize) -> Self {
        Self(studies[index].indoor().expect("the figures of indoor tracking have indoor experiments"))
    }

    /// The points of the sweep.
    pub(super) fn points(self) -> &'a [f64] {
        &self.0.points
    }

    /// The filters that ran.
    pub(super) fn filters(self) -> impl Iterator<Item = FilterName> {
        self.0.filters.iter().map(|filter| filter.name)
    }

    /// The summaries of a filter with their points, where there were trials.
    pub(super) fn of_filter(self, name: FilterName) -> impl Iterator<Item = (f64, &'a IndoorSummary)> {
        let filter = self.0.filters.iter().filter(move |filter| filter.name == name);
        let summaries = filter.flat_map(move |filter| self.0.points.iter().copied().zip(&filter.points));
        summaries.filter(|(_, summary)| summary.trials > 0)
    }

    /// A figure of a filter at a point; `None` where a trial failed, for what is left are the trials that went well.
    pub(super) fn at(self, name: FilterName, point: f64, read: Read) -> Option<Estimate> {
        let mut found = self.of_filter(name).filter(|(own, _)| own.to_bits() == point.to_bits());
        found.next().filter(|(_, summary)| summary.failures == 0).map(|(_, summary)| read(summary))
    }

    /// Ratio of two filters at a point.
    pub(super) fn versus(self, a: FilterName, b: FilterName, point: f64, read: Read) -> Option<Estimate> {
        self.at(a, point, read)?.over(self.at(b, point, read)?)
    }

    /// The ratio of two filters at the point where it is largest, and the point.
    pub(super) fn worst(self, a: FilterName, b: FilterName, read: Read) -> (f64, Option<Estimate>) {
        self.most(|point| self.versus(a, b, point, read))
    }

    /// The point at which a figure is largest, and the figure: none if it is missing at some point.
    pub(super) fn most(self, figure: impl Fn(f64) -> Option<Estimate>) -> (f64, Option<Estimate>) {
        let points = self.points();
        let (index, found) = extreme::most(points.len(), |i| figure(points[i]));
        (points[index], found)
    }

    /// The point at which it is least.
    pub(super) fn least(self, figure: impl Fn(f64) -> Option<Estimate>) -> (f64, Option<Estimate>) {
        let points = self.points();
        let (index, found) = extreme::least(points.len(), |i| figure(points[i]));
        (points[index], found)
    }
}

/// What nine tenths of the trials stay below, with the standard error that the spread of the trials next to it gives.
pub(super) const NINTH_DECILE: Read = |summary| {
    let at = |share| quantile(summary.position_distribution.iter().copied(), share).unwrap_or_default();
    let reach = sqrt(0.9 * 0.1 / summary.trials as f64);
    Estimate { value: at(0.9), standard_error: 0.5 * (at(0.9 + reach) - at(0.9 - reach)) }
};
