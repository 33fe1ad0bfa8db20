//! What \[I\] says of a body at rest, and what rangelab adds.
//!
//! "Closely aligned" is made: within a hundredth; "linear in dB": the first 20 dB gain as much as the next 20, within a
//! quarter.

use alloc::vec::Vec;

use super::experiments::{PAPER, PRINTED_DB, REST, REST_ISOSCELES, REST_SQUARED};
use super::reading::{ANGLE, POSITION, Read, Reading, at_worst};
use crate::math::float::sqrt;
use crate::model::indoor::filter_settings::FilterName::{Ekf, Mekf, Ukf};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::figures::wording::{across, beyond, paper};
use crate::study::moments::Estimate;

const ALIGNED: Interval = Interval::most(1.01);

pub(super) fn figure_4(studies: &[Study]) -> Vec<Claim> {
    let [rest, isosceles] = [REST, REST_ISOSCELES].map(|index| Reading::of(studies, index));
    let mut claims = Vec::new();
    for (what, read) in [("position", POSITION), ("orientation", ANGLE)] {
        let (point, found) = rest.most(|point| spread(&[rest], point, read));
        let name = alloc::format!("{what}: largest RMSE of EKF, EKFRie, UKF, UKFRie over the least");
        claims.push(paper(at_worst(&name, point), found, ALIGNED));
        let (point, found) = rest.most(|point| spread(&[rest, isosceles], point, read));
        let name = alloc::format!("{what}: the same, with Iso too");
        claims.push(paper(at_worst(&name, point), found, ALIGNED));
    }
    let fall = |from, to| Some(minus(rest.at(Ekf, from, POSITION)?, rest.at(Ekf, to, POSITION)?));
    let found = fall(0.0, 20.0).zip(fall(20.0, 40.0)).and_then(|(first, second)| first.over(second));
    claims.push(paper(
        "position: how far the RMSE of EKF falls from 0 to 20 dB over how far from 20 to 40 dB",
        found,
        Interval::between(0.8, 1.25),
    ));
    let later = across(rest.at(Ekf, 40.0, POSITION), rest.at(Ekf, 20.0, POSITION));
    claims.push(beyond("position: RMSE of EKF at 40 dB over that at 20 dB", later, Interval::most(0.4)));
    let (point, found) = rest.worst(Ekf, Mekf, POSITION);
    claims.push(beyond(at_worst("position: RMSE of EKF over that of MEKF", point), found, ALIGNED));
    let squared = Reading::of(studies, REST_SQUARED);
    for (what, read, least) in [("position", POSITION, 5.0), ("orientation", ANGLE, 100.0)] {
        let found = across(squared.at(Ukf, PRINTED_DB, read), rest.at(Ukf, PRINTED_DB, read));
        let name = alloc::format!(
            "{what}: RMSE of UKF with the weights of step 5 squared, as printed, over without, 20 dB"
        );
        claims.push(beyond(name, found, Interval::least(least)));
    }
    claims
}

/// The largest figure of the paper's filters over the least.
fn spread(sweeps: &[Reading<'_>], point: f64, read: Read) -> Option<Estimate> {
    let each = sweeps.iter().flat_map(|sweep| PAPER.map(|name| sweep.at(name, point, read)));
    let figures = each.collect::<Option<Vec<Estimate>>>()?;
    let by_value = |a: &&Estimate, b: &&Estimate| a.value.total_cmp(&b.value);
    figures.iter().max_by(by_value)?.over(*figures.iter().min_by(by_value)?)
}

fn minus(a: Estimate, b: Estimate) -> Estimate {
    let variance = |of: Estimate| of.standard_error * of.standard_error;
    let standard_error = sqrt(variance(a) + variance(b));
    Estimate { value: a.value - b.value, standard_error }
}
