//! What \[L\] says of its figures with the body known exactly, and what rangelab adds, each as a number with a target.
//!
//! "Meets the bound" is made: within a twentieth; "similar": within a tenth. "Reasonable noise" is 60 dB, which the paper
//! does not say.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::experiments::{FIXED, FIXED_OVER_O, PAPER, REDRAWN, REDRAWN_OVER_O};
use super::panels::sweeps;
use super::reading::{Read, ReadBound, Reading, least, most};
use crate::math::float::sqrt;
use crate::model::localize_settings::LocalizerName::{ClassicalLs, Ls, OucLs, SucLs};
use crate::study::figures::claim::Source::{Beyond, Paper};
use crate::study::figures::claim::{Claim, Interval};
use crate::study::figures::experiment::Study;
use crate::study::localization::SnapshotBound::{Crb, UnitaryCrb};
use crate::study::moments::Estimate;

const MEETS: Interval = Interval::most(1.05);
const SIMILAR: Interval = Interval::between(0.9, 1.1);
const BELOW: Interval = Interval::most(1.0);

const ORIENTATION: Read = |s| s.rmse_orientation;
const POSITION: Read = |s| s.rmse_position;
const BOUND: ReadBound = |b| b.orientation;

pub(super) fn figure_2(studies: &[Study]) -> Vec<Claim> {
    let studies = sweeps(studies);
    let [fixed, redrawn] = [FIXED, REDRAWN].map(|index| Reading(studies[index]));
    let over_o = [FIXED_OVER_O, REDRAWN_OVER_O].map(|index| Reading(studies[index]));
    let mut claims = least_squares(fixed);
    let (zeta, found) = optimal(fixed, 60);
    claims.push(Claim::new(
        Paper,
        at("fixed: RMSE(Q) of OUC-LS over the UC-CRB, from 60 dB", zeta),
        found,
        MEETS,
    ));
    let (zeta, found) = optimal(over_o[1], 60);
    let what = "redrawn, over O(3): RMSE(Q) of OUC-LS over the UC-CRB, from 60 dB";
    claims.push(Claim::new(Paper, at(what, zeta), found, MEETS));
    let what = "fixed: RMSE(Q) of SUC-LS over that of OUC-LS, 80 dB";
    claims.push(Claim::new(Paper, what, fixed.versus(SucLs, OucLs, 80, ORIENTATION), SIMILAR));
    let (zeta, found) = most(0, 100, |zeta| fixed.at(OucLs, zeta, |s| Some(s.iterations)));
    let what = "fixed: mean Newton iterations of OUC-LS";
    claims.push(Claim::new(Paper, at(what, zeta), found, Interval::most(5.0)));
    for zeta in [0, 20] {
        let what = format!("fixed, over O(3): RMSE(Q) of OUC-LS over sqrt(6), {zeta} dB");
        let found = over_o[0].at(OucLs, zeta, ORIENTATION).map(|error| scaled(error, 1.0 / sqrt(6.0)));
        claims.push(Claim::new(Paper, what, found, SIMILAR));
    }
    let (zeta, found) = optimal(redrawn, 50);
    let what = "redrawn, over SO(3): RMSE(Q) of OUC-LS over the UC-CRB, from 50 dB";
    claims.push(Claim::new(Beyond, at(what, zeta), found, Interval::most(1.1)));
    claims.extend(reflections(fixed, over_o[0]));
    claims
}

pub(super) fn figure_3(studies: &[Study]) -> Vec<Claim> {
    let study = Reading(sweeps(studies)[FIXED]);
    let mut claims = Vec::new();
    for name in [SucLs, OucLs] {
        let bias = |zeta| study.at(name, zeta, |s| s.bias_orientation);
        let what = format!("fixed: bias of {}, 70 dB over 50 dB", name.label());
        let found = bias(70).zip(bias(50)).and_then(|(high, low)| high.over(low));
        claims.push(Claim::new(Paper, what, found, Interval::most(0.1)));
    }
    let (zeta, found) = most(20, 100, |zeta| over_sampling(study.at(Ls, zeta, |s| s.bias_orientation)?));
    let what = "fixed: bias of LS over what sampling alone gives, from 20 dB";
    claims.push(Claim::new(Paper, at(what, zeta), found, Interval::most(3.0)));
    // The part of the mean error along Q is -E||xi||^2/(2D) Q ([L] eq. 49).
    let over_least = |zeta| {
        let error = study.at(OucLs, zeta, ORIENTATION)?;
        let square = Estimate {
            value: error.value * error.value,
            standard_error: 2.0 * error.value * error.standard_error,
        };
        study.at(OucLs, zeta, |s| s.bias_orientation)?.over(scaled(square, 1.0 / (2.0 * sqrt(3.0))))
    };
    let what = "fixed: bias of OUC-LS over its least, RMSE(Q)^2/(2 sqrt 3), 50 dB";
    claims.push(Claim::new(Beyond, what, over_least(50), Interval::least(1.0)));
    claims
}

pub(super) fn figure_4(studies: &[Study]) -> Vec<Claim> {
    let study = Reading(sweeps(studies)[FIXED]);
    let mut claims = Vec::new();
    let versus_ls = |read: Read| most(60, 100, |zeta| study.versus(OucLs, Ls, zeta, read));
    let (zeta, found) = versus_ls(|s| s.paper_mae);
    claims.push(Claim::new(
        Paper,
        at("fixed: MAE of OUC-LS over that of LS, from 60 dB", zeta),
        found,
        BELOW,
    ));
    let (zeta, found) = versus_ls(|s| s.rms_angle);
    let what = "fixed: rotation angle of OUC-LS over that of LS, from 60 dB";
    claims.push(Claim::new(Beyond, at(what, zeta), found, BELOW));
    let (zeta, found) = most(60, 100, |zeta| {
        study.at(OucLs, zeta, |s| s.rms_angle)?.over(study.bound(UnitaryCrb, zeta, |b| b.angle)?)
    });
    let what = "fixed: rotation angle of OUC-LS over the UC-CRB, from 60 dB";
    claims.push(Claim::new(Beyond, at(what, zeta), found, MEETS));
    claims
}

pub(super) fn figure_5(studies: &[Study]) -> Vec<Claim> {
    let study = Reading(sweeps(studies)[FIXED]);
    let sensors = study.at(ClassicalLs, 60, |s| Some(s.rmse_sensors));
    let over_body = |sensors: Estimate| sensors.over(study.at(OucLs, 60, POSITION)?);
    let per_sensor = sensors.map(|all| scaled(all, 1.0 / sqrt(10.0)));
    let (zeta, met) = most(60, 100, |zeta| {
        study.at(OucLs, zeta, POSITION)?.over(study.bound(UnitaryCrb, zeta, |b| b.position)?)
    });
    let (at_most, spread) = most(20, 100, |zeta| spread(study, zeta));
    [
        Claim::new(
            Paper,
            "fixed: RMSE(S) of classical LS, all 10 sensors together, over RMSE(t) of OUC-LS, 60 dB",
            sensors.and_then(over_body),
            Interval::between(8.0, 12.0),
        ),
        Claim::new(
            Paper,
            "fixed: RMSE of one sensor by classical LS over RMSE(t) of OUC-LS, 60 dB",
            per_sensor.and_then(over_body),
            Interval::between(8.0, 12.0),
        ),
        Claim::new(
            Beyond,
            "fixed: the same over sqrt(10), 60 dB",
            per_sensor.and_then(over_body).map(|ratio| scaled(ratio, 1.0 / sqrt(10.0))),
            SIMILAR,
        ),
        Claim::new(Beyond, at("fixed: RMSE(t) of OUC-LS over the UC-CRB, from 60 dB", zeta), met, MEETS),
        Claim::new(
            Beyond,
            at("fixed: largest RMSE(t) of LS, SUC-LS, OUC-LS over the least, from 20 dB", at_most),
            spread,
            MEETS,
        ),
    ]
    .into()
}

/// The largest `RMSE(t)` of the paper's estimators over the least.
fn spread(study: Reading<'_>, zeta_db: usize) -> Option<Estimate> {
    let errors: Vec<Estimate> = PAPER.iter().filter_map(|name| study.at(*name, zeta_db, POSITION)).collect();
    let by_value = |a: &&Estimate, b: &&Estimate| a.value.total_cmp(&b.value);
    errors.iter().max_by(by_value)?.over(*errors.iter().min_by(by_value)?)
}

pub(super) fn figure_6(studies: &[Study]) -> Vec<Claim> {
    let study = Reading(sweeps(studies)[FIXED]);
    let sensors: Read = |s| Some(s.rmse_sensors);
    let (zeta, found) = most(60, 100, |zeta| study.versus(OucLs, ClassicalLs, zeta, sensors));
    let (met_at, met) = most(60, 100, |zeta| {
        study.at(OucLs, zeta, sensors)?.over(study.bound(UnitaryCrb, zeta, |b| b.sensors)?)
    });
    [
        Claim::new(
            Paper,
            at("fixed: RMSE(S) of OUC-LS over that of classical LS, from 60 dB", zeta),
            found,
            BELOW,
        ),
        Claim::new(Beyond, at("fixed: RMSE(S) of OUC-LS over the UC-CRB, from 60 dB", met_at), met, MEETS),
    ]
    .into()
}

fn least_squares(study: Reading<'_>) -> Vec<Claim> {
    let over_bound = |zeta| study.at(Ls, zeta, ORIENTATION)?.over(study.bound(Crb, zeta, BOUND)?);
    let (high, low) = (most(20, 100, over_bound), least(20, 100, over_bound));
    let what = "fixed: RMSE(Q) of LS over the CRB, from 20 dB";
    [
        Claim::new(Paper, at(&format!("{what}, most"), high.0), high.1, MEETS),
        Claim::new(Paper, at(&format!("{what}, least"), low.0), low.1, Interval::least(0.95)),
    ]
    .into()
}

fn optimal(study: Reading<'_>, from_db: usize) -> (usize, Option<Estimate>) {
    most(from_db, 100, |zeta| study.at(OucLs, zeta, ORIENTATION)?.over(study.bound(UnitaryCrb, zeta, BOUND)?))
}

fn reflections(over_so: Reading<'_>, over_o: Reading<'_>) -> Vec<Claim> {
    let share = |study: Reading<'_>, zeta| study.at(OucLs, zeta, |s| s.reflection_rate);
    let (zeta, least) = least(0, 30, |zeta| share(over_o, zeta));
    let (_, most) = most(0, 100, |zeta| share(over_so, zeta));
    [
        Claim::new(
            Beyond,
            at("fixed, over O(3): share of mirrored OUC-LS, up to 30 dB", zeta),
            least,
            Interval::least(0.4),
        ),
        Claim::new(Beyond, "fixed, over SO(3): share of mirrored OUC-LS", most, Interval::most(0.0)),
    ]
    .into()
}

/// A bias in units of what sampling alone gives, which is its standard error.
fn over_sampling(bias: Estimate) -> Option<Estimate> {
    let standard_error = 1.0 / sqrt(2.0);
    (bias.standard_error > 0.0).then(|| Estimate { value: bias.value / bias.standard_error, standard_error })
}

fn scaled(estimate: Estimate, factor: f64) -> Estimate {
    Estimate { value: estimate.value * factor, standard_error: estimate.standard_error * factor }
}

pub(super) fn at(what: &str, zeta_db: usize) -> String {
    format!("{what}, worst at {zeta_db} dB")
}
