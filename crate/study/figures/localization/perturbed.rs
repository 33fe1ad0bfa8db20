//! What \[L\] says of its figures with misplaced sensors, and what rangelab adds.

use alloc::format;
use alloc::vec::Vec;

use super::claims::at;
use super::experiments::{FIXED, MOUNTING_SIGMA, TOTAL};
use super::panels::sweeps;
use super::reading::{Read, Reading, most};
use crate::math::float::sqrt;
use crate::model::localize_settings::LocalizerName::{self, OucLs, OucTls, OucTlsPrinted, SucTls};
use crate::study::figures::claim::Source::{Beyond, Paper};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::moments::Estimate;

const SIMILAR: Interval = Interval::between(0.9, 1.1);
const BELOW: Interval = Interval::most(1.0);

pub(super) fn figure_7(studies: &[Study]) -> Vec<Claim> {
    let study = Reading(sweeps(studies)[FIXED]);
    let orientation: Read = |s| s.rmse_orientation;
    let mut claims: Vec<Claim> =
        TOTAL.iter().map(|name| floor(study, *name, "RMSE(Q)", orientation)).collect();
    claims.extend(total_least_squares(study, "RMSE(Q)", orientation));
    claims
}

pub(super) fn figure_8(studies: &[Study]) -> Vec<Claim> {
    let study = Reading(sweeps(studies)[FIXED]);
    let (mae, angle): (Read, Read) = (|s| s.paper_mae, |s| s.rms_angle);
    let mut claims: Vec<Claim> =
        [SucTls, OucTlsPrinted, OucTls].iter().map(|name| floor(study, *name, "MAE", mae)).collect();
    claims.extend(total_least_squares(study, "rotation angle", angle));
    claims
}

pub(super) fn figure_9(studies: &[Study]) -> Vec<Claim> {
    let study = Reading(sweeps(studies)[FIXED]);
    let position: Read = |s| s.rmse_position;
    let mut claims: Vec<Claim> = TOTAL.iter().map(|name| floor(study, *name, "RMSE(t)", position)).collect();
    let least = MOUNTING_SIGMA * sqrt(3.0 / 10.0);
    let found = study.at(OucLs, 100, position).map(|error| scaled(error, 1.0 / least));
    let what = "RMSE(t) of OUC-LS over sigma_e sqrt(3/N), 100 dB";
    claims.push(Claim::new(Beyond, what, found, SIMILAR));
    claims
}

/// Without noise to speak of less noise changes nothing.
fn floor(study: Reading<'_>, name: LocalizerName, what: &str, read: Read) -> Claim {
    let found =
        study.at(name, 100, read).zip(study.at(name, 95, read)).and_then(|(last, before)| last.over(before));
    Claim::new(Paper, format!("{what} of {}, 100 dB over 95 dB", name.label()), found, SIMILAR)
}

/// Total least squares against OUC-LS, as printed and with the perturbation that there is.
fn total_least_squares(study: Reading<'_>, what: &str, read: Read) -> Vec<Claim> {
    let versus = |name, from, to| most(from, to, |zeta| study.versus(name, OucLs, zeta, read));
    let (middle, high) = (versus(OucTlsPrinted, 50, 75), versus(OucTlsPrinted, 85, 100));
    let matched = versus(OucTls, 50, 100);
    let over = |name: LocalizerName| format!("{what} of {} over that of OUC-LS", name.label());
    [
        Claim::new(Paper, at(&format!("{}, 50 to 75 dB", over(OucTlsPrinted)), middle.0), middle.1, BELOW),
        Claim::new(Paper, at(&format!("{}, from 85 dB", over(OucTlsPrinted)), high.0), high.1, BELOW),
        Claim::new(
            Beyond,
            at(&format!("{}, from 50 dB", over(OucTls)), matched.0),
            matched.1,
            Interval::most(1.01),
        ),
    ]
    .into()
}

fn scaled(estimate: Estimate, factor: f64) -> Estimate {
    Estimate { value: estimate.value * factor, standard_error: estimate.standard_error * factor }
}
