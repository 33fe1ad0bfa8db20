//! What \[I\] says of the rate of the IMU, and what rangelab adds.
//!
//! "Improves" is made: twice as many samples a second leave at most seven tenths of the error; "diminishing": from 200 to
//! 500 at least three quarters of it are left.

use alloc::format;
use alloc::vec::Vec;

use super::experiments::{MATCHED, SAMPLED};
use super::reading::{POSITION, Reading};
use crate::model::indoor::filter_settings::FilterName::{self, Ekf, EkfRie, Mekf};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::wording::{across, beyond, paper};
use crate::study::moments::Estimate;

pub(super) fn figures_7_and_8(studies: &[Study]) -> Vec<Claim> {
    let [sampled, matched] = [SAMPLED, MATCHED].map(|index| Reading::of(studies, index));
    let position = |name, rate| sampled.at(name, rate, POSITION);
    let over =
        |name: FilterName, rate: f64, before: f64| across(position(name, rate), position(name, before));
    let mut claims = Vec::new();
    for name in [Ekf, EkfRie] {
        let what = |rate, before| format!("RMSE of {} at {rate} Hz over that at {before} Hz", name.label());
        claims.push(paper(what(10, 5), over(name, 10.0, 5.0), Interval::most(0.7)));
        claims.push(paper(what(500, 200), over(name, 500.0, 200.0), Interval::least(0.75)));
    }
    let gain = |rate| sampled.versus(EkfRie, Ekf, rate, POSITION);
    let ratio = |rate| format!("RMSE of EKFRie over that of EKF at {rate} Hz");
    claims.push(beyond(ratio(5), gain(5.0), Interval::most(0.95)));
    claims.push(beyond(ratio(500), gain(500.0), Interval::least(0.9)));
    let what = "RMSE of MEKF at 20 Hz over that of EKFRie at 50 Hz";
    let slower: Option<Estimate> = across(position(Mekf, 20.0), position(EkfRie, 50.0));
    claims.push(beyond(what, slower, Interval::most(1.0)));
    let found = matched.versus(EkfRie, Ekf, 10.0, POSITION);
    claims.push(beyond("IMU matched: RMSE of EKFRie over that of EKF at 10 Hz", found, Interval::most(0.5)));
    claims
}
