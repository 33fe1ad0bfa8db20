//! What \[A\] says of the coefficients of the Gram matrix, and what rangelab adds.
//!
//! "Lower" is at most 1 at the number of stamps where it is worst; "improves", lower by a twentieth; "optimal", at most a
//! twentieth above the bound.

use alloc::format;
use alloc::vec::Vec;

use super::experiments::{
    DEGREE_2, DEGREE_3, DEGREE_5, DEGREE_6, HUNDRED, LONG, ONE_SIDED, PAPER, SHORT, SHORTEST, THOUSAND,
};
use super::reading::Quantity::Gram;
use super::reading::{Bound, Reading, at_worst};
use crate::model::kinematics::settings::KinematicsName::{Algorithm1Rank1, Algorithm2Rank1, RangePolynomial};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::wording::{across, beyond, paper};

pub(super) fn figure_1(studies: &[Study]) -> Vec<Claim> {
    let mut claims = as_the_paper_says(studies);
    claims.extend(optimal(studies));
    claims.extend(of_other_intervals(studies));
    claims
}

fn as_the_paper_says(studies: &[Study]) -> Vec<Claim> {
    let own = Reading::of(studies, PAPER);
    let mut claims = Vec::new();
    for (index, degree) in [(DEGREE_2, 2), (DEGREE_3, 3), (PAPER, 4), (DEGREE_5, 5), (DEGREE_6, 6)] {
        let ranges = Reading::of(studies, index);
        for l in 0..3 {
            let (stamps, found) = own.most(|stamps| {
                across(own.at(Algorithm1Rank1, stamps, Gram(l)), ranges.at(RangePolynomial, stamps, Gram(l)))
            });
            let what = format!("RMSE(B{l}) of Algorithm 1 over that of ranges of degree {degree}");
            claims.push(paper(at_worst(&what, stamps), found, Interval::most(1.0)));
        }
    }
    for l in 0..3 {
        let (stamps, found) =
            own.most(|stamps| own.versus(Algorithm2Rank1, Algorithm1Rank1, stamps, Gram(l)));
        let what = format!("RMSE(B{l}) of Algorithm 2 over that of Algorithm 1");
        claims.push(paper(at_worst(&what, stamps), found, Interval::most(0.95)));
    }
    claims
}

/// Noise is white on distances, not on the entries of the Gram matrix, and those are of rank 2.
fn optimal(studies: &[Study]) -> Vec<Claim> {
    let own = Reading::of(studies, PAPER);
    let fits = [
        (Algorithm1Rank1, "Algorithm 1", Bound::Distances, "from distances"),
        (Algorithm2Rank1, "Algorithm 2", Bound::Accelerations, "with accelerations"),
    ];
    let each = fits.into_iter().flat_map(|fit| (0..3).map(move |l| (fit, l)));
    each.map(|((name, label, bound, from), l)| {
        let found = own.over_bound(name, bound, HUNDRED, Gram(l));
        let what = format!("RMSE(B{l}) of {label} over the CRB {from}, K = {HUNDRED}");
        paper(what, found, Interval::most(1.05))
    })
    .collect()
}

/// What is gained over ranges is the truncation that is not there, and that depends on the interval.
fn of_other_intervals(studies: &[Study]) -> Vec<Claim> {
    let mut claims = Vec::new();
    let places = [
        (PAPER, "-5 to 5 s", 4, HUNDRED, [Some(Interval::between(0.95, 1.05)); 3]),
        (PAPER, "-5 to 5 s", 4, THOUSAND, [None, Some(Interval::most(0.9)), Some(Interval::most(0.95))]),
        (LONG, "-10 to 10 s", 4, HUNDRED, [Some(Interval::most(0.6)); 3]),
        (SHORT, "-3 to 3 s", 3, HUNDRED, [Some(Interval::least(1.1)), None, Some(Interval::least(1.5))]),
        (SHORTEST, "-1 to 1 s", 2, HUNDRED, [1.1, 1.5, 2.0].map(|least| Some(Interval::least(least)))),
    ];
    for (index, interval, degree, stamps, targets) in places {
        for (l, target) in targets.into_iter().enumerate() {
            let Some(target) = target else { continue };
            let found = Reading::of(studies, index).versus(Algorithm1Rank1, RangePolynomial, stamps, Gram(l));
            let what = format!(
                "{interval}: RMSE(B{l}) of Algorithm 1 over that of ranges of degree {degree}, K = {stamps}"
            );
            claims.push(beyond(what, found, target));
        }
    }
    let found = Reading::of(studies, ONE_SIDED).versus(Algorithm2Rank1, Algorithm1Rank1, HUNDRED, Gram(1));
    let what = format!("0 to 10 s: RMSE(B1) of Algorithm 2 over that of Algorithm 1, K = {HUNDRED}");
    claims.push(beyond(what, found, Interval::most(0.7)));
    claims
}
