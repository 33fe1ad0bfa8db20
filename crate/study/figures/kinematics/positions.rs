//! What \[A\] says of positions over time, and what rangelab adds.
//!
//! "Worsens" is made: at least twice the error at time 0 at either end. Were it the Taylor approximation that worsens, the
//! error at the ends would stay when the noise goes: at least half of it is asked for.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::experiments::{HUNDRED, LITTLE_NOISE, MANY_STAMPS, PAPER, THOUSAND};
use super::reading::Quantity::{AlignedPosition, Position};
use super::reading::{Bound, Quantity, Reading};
use crate::model::kinematics::settings::KinematicsName::{
    self, Algorithm1Rank1, Algorithm2Rank1, Algorithm2So, MaximumLikelihood, MultidimensionalScaling,
};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::extreme::{least, most};
use crate::study::figures::wording::{across, beyond, paper};
use crate::study::moments::Estimate;

pub(super) fn figure_2b(studies: &[Study]) -> Vec<Claim> {
    let own = OverTime { sweep: Reading::of(studies, PAPER), stamps: HUNDRED };
    let mut claims = as_the_paper_says(own, studies);
    claims.extend(why_it_grows(own));
    claims.extend(beside_single_epochs(own, studies));
    claims
}

/// One number of stamps.
#[derive(Clone, Copy)]
struct OverTime<'a> {
    sweep: Reading<'a>,
    stamps: usize,
}

impl OverTime<'_> {
    fn at(self, name: KinematicsName, quantity: Quantity) -> Option<Estimate> {
        self.sweep.at(name, self.stamps, quantity)
    }

    fn instants(&self) -> &[f64] {
        self.sweep.points().first().map_or(&[], |point| &point.instants)
    }

    fn last(self) -> usize {
        self.instants().len().saturating_sub(1)
    }

    fn middle(self) -> usize {
        self.last() / 2
    }

    /// The end at which a number is larger; it is called by its instant.
    fn worst_end(self, number: impl Fn(usize) -> Option<Estimate>) -> (String, Option<Estimate>) {
        let ends = [0, self.last()];
        let (end, found) = most(2, |i| number(ends[i]));
        (self.called(ends[end]), found)
    }

    /// The end at which it is less.
    fn better_end(self, number: impl Fn(usize) -> Option<Estimate>) -> (String, Option<Estimate>) {
        let ends = [0, self.last()];
        let (end, found) = least(2, |i| number(ends[i]));
        (self.called(ends[end]), found)
    }

    fn called(self, instant: usize) -> String {
        format!("t = {} s", self.instants().get(instant).copied().unwrap_or_default())
    }
}

fn as_the_paper_says(own: OverTime<'_>, studies: &[Study]) -> Vec<Claim> {
    let mut claims = Vec::new();
    let (instant, found) = most(own.instants().len(), |i| {
        across(own.at(Algorithm2Rank1, Position(i)), own.at(Algorithm1Rank1, Position(i)))
    });
    let what = format!("RMSE of Algorithm 2 over that of Algorithm 1, worst at {}", own.called(instant));
    claims.push(paper(what, found, Interval::most(0.9)));
    let calm = OverTime { sweep: Reading::of(studies, LITTLE_NOISE), ..own };
    for (name, label) in [(Algorithm1Rank1, "Algorithm 1"), (Algorithm2Rank1, "Algorithm 2")] {
        let at_zero = own.at(name, Position(own.middle()));
        let (end, found) = own.better_end(|i| across(own.at(name, Position(i)), at_zero));
        let what = format!("RMSE of {label} at {end} over that at 0");
        claims.push(paper(what, found, Interval::least(2.0)));
        let (end, found) = own.worst_end(|i| across(calm.at(name, Position(i)), own.at(name, Position(i))));
        let what = format!("RMSE of {label} at {end}, the noise a thousandth, over that at full noise");
        claims.push(paper(what, found, Interval::least(0.5)));
    }
    claims
}

/// The rate of a common turn is what is not known: the bound grows with it, and hardly without.
fn why_it_grows(own: OverTime<'_>) -> Vec<Claim> {
    let mut claims = Vec::new();
    let bound = |quantity| own.sweep.bound(Bound::Distances, own.stamps, quantity);
    let (end, found) = own.better_end(|i| across(bound(Position(i)), bound(Position(own.middle()))));
    let what = format!("CRB from distances, aligned at 0 only, at {end} over that at 0");
    claims.push(beyond(what, found, Interval::least(50.0)));
    let (end, found) =
        own.worst_end(|i| across(bound(AlignedPosition(i)), bound(AlignedPosition(own.middle()))));
    let what = format!("CRB from distances, aligned at each instant, at {end} over that at 0");
    claims.push(beyond(what, found, Interval::most(3.0)));
    for (name, most) in [(MaximumLikelihood, 0.1), (Algorithm2So, 0.5)] {
        let (end, found) =
            own.worst_end(|i| across(own.at(name, AlignedPosition(i)), own.at(name, Position(i))));
        let what = format!("RMSE of {}, aligned at {end}, over that aligned at 0 only", name.label());
        claims.push(beyond(what, found, Interval::most(most)));
    }
    let ml = |i| own.at(MaximumLikelihood, AlignedPosition(i));
    let half = |sign: f64| own.instants().iter().position(|time| (time - 2.5 * sign).abs() < 1e-9);
    for sign in [-1.0, 1.0] {
        let found = half(sign).and_then(|i| across(ml(i), ml(own.middle())));
        let what =
            format!("aligned at each instant: RMSE of ML, distances, at {} s over that at 0", 2.5 * sign);
        claims.push(beyond(what, found, Interval::most(0.98)));
    }
    let (end, found) = own.worst_end(|i| across(ml(i), ml(own.middle())));
    let what = format!("aligned at each instant: RMSE of ML, distances, at {end} over that at 0");
    claims.push(beyond(what, found, Interval::between(1.5, 2.5)));
    claims
}

/// MDS of the one epoch there and then, for which other stamps do nothing.
fn beside_single_epochs(own: OverTime<'_>, studies: &[Study]) -> Vec<Claim> {
    let many = OverTime { sweep: Reading::of(studies, MANY_STAMPS), stamps: THOUSAND };
    let epoch = |i| own.at(MultidimensionalScaling, AlignedPosition(i));
    let mut claims = Vec::new();
    let at_ends = [
        (own, Algorithm1Rank1, Interval::least(10.0)),
        (many, Algorithm1Rank1, Interval::least(10.0)),
        (own, Algorithm2So, Interval::least(1.5)),
        (many, Algorithm2So, Interval::most(1.0)),
    ];
    for (over_time, name, target) in at_ends {
        let (end, found) = own.worst_end(|i| across(over_time.at(name, AlignedPosition(i)), epoch(i)));
        let (name, stamps) = (name.label(), over_time.stamps);
        let what = format!("aligned at {end}: RMSE of {name} over that of MDS of one epoch, K = {stamps}");
        claims.push(beyond(what, found, target));
    }
    let (instant, found) =
        most(own.instants().len(), |i| across(own.at(MaximumLikelihood, AlignedPosition(i)), epoch(i)));
    let instant = own.called(instant);
    let what =
        format!("aligned at {instant}, the worst: RMSE of ML, distances, over that of MDS of one epoch");
    claims.push(beyond(what, found, Interval::most(0.3)));
    claims
}
