//! What \[I\] says of the distribution of the errors on the bridge, and what rangelab adds.
//!
//! "Better" is less than the other; where numbers are printed, whose ratios are 0.42 and 0.46, at most a half.

use alloc::format;
use alloc::vec::Vec;

use super::experiments::{COARSE_DB, FINE_DB, MATCHED, SAMPLED};
use super::reading::{NINTH_DECILE, Reading};
use crate::model::indoor::filter_settings::FilterName::{Ekf, EkfRie, Mekf, Ukf, UkfRie};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::wording::{beyond, paper};

pub(super) fn figure_9(studies: &[Study]) -> Vec<Claim> {
    let [sampled, matched] = [SAMPLED, MATCHED].map(|index| Reading::of(studies, index));
    let pairs = [(EkfRie, Ekf, "0.42"), (UkfRie, Ukf, "0.46")];
    let mut claims = Vec::new();
    for (a, b, printed) in pairs {
        let ratio = format!("what 90 % of the trials of {} are below over that of {}", a.label(), b.label());
        let found = |sweep: Reading<'_>, decibels| sweep.versus(a, b, decibels, NINTH_DECILE);
        let what = format!("1e-3: {ratio} (printed {printed})");
        claims.push(paper(what, found(sampled, FINE_DB), Interval::most(0.5)));
        claims.push(paper(format!("1e-1: {ratio}"), found(sampled, COARSE_DB), Interval::most(1.0)));
        let what = format!("1e-3, IMU matched: {ratio}");
        claims.push(beyond(what, found(matched, FINE_DB), Interval::most(0.5)));
    }
    let found = sampled.versus(Mekf, Ekf, FINE_DB, NINTH_DECILE);
    let what = "1e-3: what 90 % of the trials of MEKF are below over that of EKF";
    claims.push(beyond(what, found, Interval::most(0.5)));
    claims
}
