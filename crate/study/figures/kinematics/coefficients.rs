//! What \[A\] says of positions, velocities and accelerations at time 0, and what rangelab adds.
//!
//! "Significantly" is made: by a tenth. The closed forms of the paper are read without their division (rank one), which
//! spoils velocities in rare trials: its cost is held against them by the median.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::experiments::{HUNDRED, PAPER, TEN, THOUSAND};
use super::reading::Quantity::Coefficient;
use super::reading::{Bound, Reading, at_worst};
use crate::model::kinematics::settings::KinematicsName::{
    self, Algorithm1Literal, Algorithm1Rank1, Algorithm1So, Algorithm2Literal, Algorithm2Rank1, Algorithm2So,
    MaximumLikelihood, MaximumLikelihoodAccelerometers, SnapshotSync,
};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::wording::{across, beyond, paper};
use crate::study::moments::Estimate;

const A_TENTH_BELOW: Interval = Interval::most(0.9);
/// Maximum likelihood meets its bound.
const MET: Interval = Interval::between(0.9, 1.1);
/// A closed form that loses, and by no more than a factor of five.
const NEAR: Interval = Interval::between(1.5, 5.0);

pub(super) fn figure_2a(studies: &[Study]) -> Vec<Claim> {
    let own = Reading::of(studies, PAPER);
    let mut claims: Vec<Claim> = over(own, Algorithm2Rank1, Algorithm1Rank1)
        .into_iter()
        .map(|(what, found)| paper(what, found, A_TENTH_BELOW))
        .collect();
    for (a, b) in [(MaximumLikelihood, Algorithm2Rank1), (SnapshotSync, Algorithm1Rank1)] {
        claims.extend(over(own, a, b).into_iter().map(|(what, found)| beyond(what, found, A_TENTH_BELOW)));
    }
    claims.extend(from_the_bounds(own));
    claims.extend(of_velocities(own));
    claims
}

/// Ratios of two estimators, each where it is worst.
fn over(own: Reading<'_>, a: KinematicsName, b: KinematicsName) -> [(String, Option<Estimate>); 3] {
    [0, 1, 2].map(|l| {
        let (stamps, found) = own.most(|stamps| own.versus(a, b, stamps, Coefficient(l)));
        let what = format!("RMSE(Y{l}) of {} over that of {}", a.label(), b.label());
        (at_worst(&what, stamps), found)
    })
}

fn from_the_bounds(own: Reading<'_>) -> Vec<Claim> {
    let above = [
        (Algorithm1Rank1, Bound::Distances, [1.5, 3.0, 20.0].map(Interval::least)),
        (Algorithm2Rank1, Bound::Accelerations, [1.5, 5.0, 10.0].map(Interval::least)),
        (SnapshotSync, Bound::Distances, [NEAR; 3]),
    ];
    let mut claims: Vec<Claim> =
        above.into_iter().flat_map(|each| over_the_bound(own, HUNDRED, each)).collect();
    for stamps in [TEN, HUNDRED, THOUSAND] {
        for (name, bound) in
            [(MaximumLikelihood, Bound::Distances), (MaximumLikelihoodAccelerometers, Bound::Accelerations)]
        {
            claims.extend(over_the_bound(own, stamps, (name, bound, [MET; 3])));
        }
    }
    for (l, least) in [1.2, 5.0, 10.0].into_iter().enumerate() {
        let [distances, accelerations] =
            [Bound::Distances, Bound::Accelerations].map(|bound| own.bound(bound, HUNDRED, Coefficient(l)));
        let what = format!("CRB of Y{l} from distances over that with accelerations, K = {HUNDRED}");
        claims.push(beyond(what, across(distances, accelerations), Interval::least(least)));
    }
    claims
}

/// Each coefficient of an estimator, over its bound.
fn over_the_bound(
    own: Reading<'_>,
    stamps: usize,
    (name, bound, targets): (KinematicsName, Bound, [Interval; 3]),
) -> Vec<Claim> {
    let from = if bound == Bound::Distances { "from distances" } else { "with accelerations" };
    let each = targets.into_iter().enumerate().map(|(l, target)| {
        let found = own.over_bound(name, bound, stamps, Coefficient(l));
        let what = format!("RMSE(Y{l}) of {} over the CRB {from}, K = {stamps}", name.label());
        beyond(what, found, target)
    });
    each.collect()
}

/// What the solver of the second stage does to them.
fn of_velocities(own: Reading<'_>) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (a, b) in [(Algorithm1Literal, Algorithm1Rank1), (Algorithm2Literal, Algorithm2Rank1)] {
        let [printed, rank_one] = [a, b].map(|name| own.median_velocity_error(name, HUNDRED));
        let what = format!("median error of Y1 of {} over that of {}, K = {HUNDRED}", a.label(), b.label());
        claims.push(beyond(what, across(printed, rank_one), Interval::least(1.1)));
    }
    let found = own.versus(Algorithm1Literal, Algorithm1Rank1, HUNDRED, Coefficient(1));
    let what = format!(
        "RMSE(Y1) of {} over that of {}, K = {HUNDRED}",
        Algorithm1Literal.label(),
        Algorithm1Rank1.label()
    );
    claims.push(beyond(what, found, Interval::least(2.0)));
    for (a, b) in [(Algorithm1So, Algorithm1Rank1), (Algorithm2So, Algorithm2Rank1)] {
        let found = own.versus(a, b, HUNDRED, Coefficient(1));
        let what = format!("RMSE(Y1) of {} over that of {}, K = {HUNDRED}", a.label(), b.label());
        claims.push(beyond(what, found, A_TENTH_BELOW));
    }
    claims
}
