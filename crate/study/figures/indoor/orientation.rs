//! What \[I\] says of the orientation on its paths, and what rangelab adds.
//!
//! "Marginally better" is made: by a hundredth.

use alloc::format;
use alloc::vec::Vec;

use super::experiments::{
    BRIDGE, PRINTED_DB, STAIR, STAIR_MATCHED, TUMBLE, TUMBLE_EXPONENTIAL, U, U_EXPONENTIAL, U_MATCHED,
    U_MATCHED_EXPONENTIAL, ZIGZAG,
};
use super::reading::{ANGLE, Reading, at_worst};
use crate::model::indoor::filter_settings::FilterName::{Ekf, EkfRie, Mekf, Ukf, UkfRie};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::wording::{across, beyond, paper};

const MARGINALLY_BETTER: Interval = Interval::most(0.99);

pub(super) fn figure_6(studies: &[Study]) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (index, path) in [(U, "U"), (ZIGZAG, "zigzag"), (BRIDGE, "bridge"), (STAIR, "stair")] {
        let sweep = Reading::of(studies, index);
        for (a, b) in [(EkfRie, Ekf), (UkfRie, Ukf)] {
            let ratio = format!("{path}: angle of {} over that of {}", a.label(), b.label());
            let found = sweep.versus(a, b, PRINTED_DB, ANGLE);
            claims.push(paper(format!("{ratio}, 20 dB"), found, MARGINALLY_BETTER));
            let (point, found) = sweep.worst(a, b, ANGLE);
            claims.push(paper(at_worst(&ratio, point), found, Interval::most(1.0)));
        }
    }
    let worse = [(TUMBLE, "tumble", 1.3), (STAIR_MATCHED, "stair, IMU matched", 1.1)];
    for (index, path, least) in worse {
        let found = Reading::of(studies, index).versus(EkfRie, Ekf, PRINTED_DB, ANGLE);
        let what = format!("{path}: angle of EKFRie over that of EKF, 20 dB");
        claims.push(beyond(what, found, Interval::least(least)));
    }
    let u = Reading::of(studies, U);
    let exponential = Reading::of(studies, U_EXPONENTIAL).at(EkfRie, PRINTED_DB, ANGLE);
    let by_the_map = [
        (U, U_EXPONENTIAL, "U", 0.9),
        (U_MATCHED, U_MATCHED_EXPONENTIAL, "U, IMU matched", 0.1),
        (TUMBLE, TUMBLE_EXPONENTIAL, "tumble", 0.7),
    ];
    for (plain, exponential, path, most) in by_the_map {
        let [plain, exponential] =
            [plain, exponential].map(|index| Reading::of(studies, index).at(EkfRie, PRINTED_DB, ANGLE));
        let what = format!("{path}: angle of EKFRie by the exponential map over that by the Q-factor, 20 dB");
        claims.push(beyond(what, across(exponential, plain), Interval::most(most)));
    }
    let found = across(exponential, u.at(Mekf, PRINTED_DB, ANGLE));
    let what = "U: angle of EKFRie by the exponential map over that of MEKF, 20 dB";
    claims.push(beyond(what, found, Interval::between(0.99, 1.01)));
    claims
}
