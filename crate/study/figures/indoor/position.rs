//! What \[I\] says of the position on its paths, and what rangelab adds.
//!
//! A ratio that the paper prints numbers for is halved generously: where it prints 0.33 and less, at most a half is asked
//! for. "Consistently better" is at most 1 at the noise where it is worst. Numbers printed stand beside; an error is met
//! where it is within a fifth of the one printed.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::experiments::{
    BRIDGE, BRIDGE_GRAVITY, BRIDGE_MATCHED, PAPER, PRINTED_DB, STAIR, STAIR_MATCHED, STAIR_PRINTED_NOISE,
    STAIR_SINGLE, TUMBLE, TUMBLE_EXPONENTIAL, U, U_CONGRUENCE, U_EXPONENTIAL, U_FULL, U_ISOSCELES, U_MATCHED,
    U_MATCHED_EXPONENTIAL, U_MATCHED_SINGLE, U_PRINTED, U_PRINTED_UNSURE, U_SINGLE, ZIGZAG,
};
use super::reading::{POSITION, Reading, at_worst};
use crate::model::indoor::filter_settings::FilterName::{
    self, Ekf, EkfFull, EkfRetraction, EkfRie, Mekf, Ukf, UkfRie,
};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::wording::{across, beyond, paper};
use crate::study::moments::Estimate;

const HALF: Interval = Interval::most(0.5);
const BETTER: Interval = Interval::most(1.0);

/// EKFRie over EKF, and UKFRie over UKF.
const PAIRS: [(FilterName, FilterName); 2] = [(EkfRie, Ekf), (UkfRie, Ukf)];

pub(super) fn figure_5(studies: &[Study]) -> Vec<Claim> {
    let mut claims = as_printed(studies);
    claims.extend(consistently(studies));
    claims.extend(why(studies));
    claims.extend(averaging(studies));
    claims.extend(if_matched(studies));
    claims.extend(yardsticks(studies));
    claims.extend(by_the_exponential_map(studies));
    claims.extend(left_out(studies));
    claims
}

fn ratio(a: FilterName, b: FilterName) -> String {
    format!("RMSE of {} over that of {}", a.label(), b.label())
}

/// The numbers that the paper prints.
fn as_printed(studies: &[Study]) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (index, path, printed) in [(U, "U", [0.33, 0.23]), (STAIR, "stair", [0.21, 0.17])] {
        for ((a, b), printed) in PAIRS.into_iter().zip(printed) {
            let what = format!("{path}: {}, 20 dB (printed {printed})", ratio(a, b));
            let found = Reading::of(studies, index).versus(a, b, PRINTED_DB, POSITION);
            claims.push(paper(what, found, HALF));
        }
    }
    let u = Reading::of(studies, U);
    let found = u.versus(Ukf, Ekf, PRINTED_DB, POSITION);
    claims.push(paper(format!("U: {}, 20 dB (printed 1.19)", ratio(Ukf, Ekf)), found, Interval::least(1.05)));
    let found = u.versus(UkfRie, EkfRie, PRINTED_DB, POSITION);
    let what = format!("U: {}, 20 dB (printed 0.83)", ratio(UkfRie, EkfRie));
    claims.push(paper(what, found, Interval::between(0.8, 1.25)));
    claims
}

/// "All paths and noise levels".
fn consistently(studies: &[Study]) -> Vec<Claim> {
    let paths = [(U, "U"), (ZIGZAG, "zigzag"), (BRIDGE, "bridge"), (STAIR, "stair")];
    let each = paths.into_iter().flat_map(|path| PAIRS.map(|pair| (path, pair)));
    each.map(|((index, path), (a, b))| {
        let (point, found) = Reading::of(studies, index).worst(a, b, POSITION);
        paper(at_worst(&format!("{path}: {}", ratio(a, b)), point), found, BETTER)
    })
    .collect()
}

/// What the paper gives as reasons.
fn why(studies: &[Study]) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (index, path) in [(U, "U"), (STAIR, "stair")] {
        let sweep = Reading::of(studies, index);
        let (point, found) = sweep.least(|point| sweep.versus(EkfRie, EkfRetraction, point, POSITION));
        let what =
            format!("{path}: {}: what transport gains, best at {point} dB", ratio(EkfRie, EkfRetraction));
        claims.push(paper(what, found, Interval::most(0.95)));
    }
    let [one_by_one, isosceles] = [U, U_ISOSCELES].map(|index| Reading::of(studies, index));
    for name in PAPER {
        let gain = |point| across(isosceles.at(name, point, POSITION), one_by_one.at(name, point, POSITION));
        let (point, found) = one_by_one.least(gain);
        let what = format!("U: RMSE of {} with Iso over without, best at {point} dB", name.label());
        claims.push(paper(what, found, Interval::least(0.98)));
    }
    let repairs = |index| repairs(Reading::of(studies, index));
    let what = "U, P0 1e-4: repairs of the covariance in a trial, UKFRie with the transport as printed";
    claims.push(paper(what, repairs(U_PRINTED), Interval::least(1.0)));
    let what = "U, P0 1e-4: repairs of the covariance in a trial, UKFRie with all of it transported";
    claims.push(beyond(what, repairs(U_CONGRUENCE), Interval::most(0.0)));
    claims
}

fn repairs(sweep: Reading<'_>) -> Option<Estimate> {
    sweep.at(UkfRie, PRINTED_DB, |summary| summary.repairs)
}

/// Whether three receivers and no retraction are worse than one with.
fn averaging(studies: &[Study]) -> Vec<Claim> {
    let cases =
        [(U, U_SINGLE, "U"), (U_MATCHED, U_MATCHED_SINGLE, "U, IMU matched"), (STAIR, STAIR_SINGLE, "stair")];
    let claim = |(three, one, path): (usize, usize, &str)| {
        let averaged = Reading::of(studies, three).at(Ekf, PRINTED_DB, POSITION);
        let found = across(averaged, Reading::of(studies, one).at(EkfRie, PRINTED_DB, POSITION));
        let what = format!("{path}: RMSE of EKF with three transmitters over that of EKFRie with one, 20 dB");
        paper(what, found, Interval::least(1.0))
    };
    cases.map(claim).into()
}

/// What becomes of the claims where the inputs fit the discretization.
fn if_matched(studies: &[Study]) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (index, path) in [(U_MATCHED, "U"), (STAIR_MATCHED, "stair"), (BRIDGE_MATCHED, "bridge")] {
        let sweep = Reading::of(studies, index);
        for (a, b) in PAIRS {
            let found = sweep.versus(a, b, PRINTED_DB, POSITION);
            claims.push(beyond(format!("{path}, IMU matched: {}, 20 dB", ratio(a, b)), found, HALF));
        }
    }
    let (point, found) = Reading::of(studies, BRIDGE_MATCHED).worst(EkfRie, Ekf, POSITION);
    let what = at_worst(&format!("bridge, IMU matched: {}", ratio(EkfRie, Ekf)), point);
    claims.push(beyond(what, found, BETTER));
    claims
}

/// What integrating exactly gains, and what a wide prior costs.
fn yardsticks(studies: &[Study]) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (index, path, most) in [(U, "U", 0.25), (STAIR, "stair", 0.7)] {
        let found = Reading::of(studies, index).versus(Mekf, EkfRie, PRINTED_DB, POSITION);
        claims.push(beyond(format!("{path}: {}, 20 dB", ratio(Mekf, EkfRie)), found, Interval::most(most)));
    }
    let found = Reading::of(studies, U_PRINTED_UNSURE).versus(EkfRie, Mekf, PRINTED_DB, POSITION);
    let what = format!("U, P0 1, transport as printed: {}, 20 dB", ratio(EkfRie, Mekf));
    claims.push(beyond(what, found, Interval::least(5.0)));
    claims
}

/// The paper's future work.
fn by_the_exponential_map(studies: &[Study]) -> Vec<Claim> {
    let cases = [
        (U, U_EXPONENTIAL, "U", Interval::most(0.95)),
        (U_MATCHED, U_MATCHED_EXPONENTIAL, "U, IMU matched", Interval::most(0.7)),
        (TUMBLE, TUMBLE_EXPONENTIAL, "tumble", Interval::least(1.05)),
    ];
    let claim = |(plain, exponential, path, target): (usize, usize, &str, Interval)| {
        let [plain, exponential] =
            [plain, exponential].map(|index| Reading::of(studies, index).at(EkfRie, PRINTED_DB, POSITION));
        let what = format!("{path}: RMSE of EKFRie by the exponential map over that by the Q-factor, 20 dB");
        beyond(what, across(exponential, plain), target)
    };
    cases.map(claim).into()
}

/// What comes of what the simulation or the EKF leaves out: the rest of the Jacobian, which is all that the UKF adds, the
/// noise that is printed, and gravity.
fn left_out(studies: &[Study]) -> Vec<Claim> {
    let at_20_db = |index, name| Reading::of(studies, index).at(name, PRINTED_DB, POSITION);
    let found = across(at_20_db(U_FULL, Ukf), at_20_db(U_FULL, EkfFull));
    let what = format!("U: {}, 20 dB", ratio(Ukf, EkfFull));
    let mut claims = Vec::from([beyond(what, found, Interval::between(0.9999, 1.0001))]);
    let what = "stair, sigma_a^2 = 4.3e-4 m^2/s^4 as printed: RMSE of EKF, 20 dB (printed 0.24)";
    claims.push(paper(what, at_20_db(STAIR_PRINTED_NOISE, Ekf), Interval::between(0.192, 0.288)));
    let what = "stair, sigma_a^2 = 4.3e-4 m^2/s^4 as printed: RMSE of EKFRie, 20 dB (printed 0.05)";
    claims.push(paper(what, at_20_db(STAIR_PRINTED_NOISE, EkfRie), Interval::between(0.04, 0.06)));
    for name in [Ekf, EkfRie] {
        let found = across(at_20_db(BRIDGE_GRAVITY, name), at_20_db(BRIDGE_GRAVITY, Mekf));
        let what = format!("bridge, with gravity: {}, 20 dB", ratio(name, Mekf));
        claims.push(beyond(what, found, Interval::least(2.0)));
    }
    claims
}
