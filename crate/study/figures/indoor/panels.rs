//! What is drawn in the figures of \[I\].

use alloc::format;
use alloc::string::ToString;
use alloc::vec::Vec;

use super::experiments::{
    COARSE_DB, FINE_DB, MATCHED, REST, REST_ISOSCELES, SAMPLED, STAIR, STAIR_MATCHED, U, U_ISOSCELES,
    U_MATCHED,
};
use super::reading::{ANGLE, POSITION, Read, Reading};
use crate::math::float::{degrees, sqrt};
use crate::model::indoor::filter_settings::FilterName;
use crate::study::figures::experiment::Study;
use crate::study::figures::report::{Axis, Curve, CurveKind, Panel, Point};
use crate::study::indoor::report::IndoorSummary;
use crate::study::moments::Estimate;

/// What goes up in a panel.
struct Quantity {
    name: &'static str,
    axis: fn() -> Axis,
    read: Read,
}

const POSITIONS: Quantity =
    Quantity { name: "position", axis: || Axis::log("RMSE of the position", "m"), read: POSITION };
const ANGLES: Quantity = Quantity {
    name: "orientation",
    axis: || Axis::log("RMSE of the orientation", "deg"),
    read: |s| {
        let Estimate { value, standard_error } = ANGLE(s);
        Estimate { value: degrees(value), standard_error: degrees(standard_error) }
    },
};

/// Place in the list of experiments, name and title of a panel.
type Place = (usize, &'static str, &'static str);

const PATHS: [Place; 5] = [
    (U, "u", "U"),
    (STAIR, "stair", "Stairs"),
    (U_ISOSCELES, "u-iso", "U, triangle fitted as a whole (Iso)"),
    (U_MATCHED, "u-matched", "U, IMU matched to eq. 13"),
    (STAIR_MATCHED, "stair-matched", "Stairs, IMU matched to eq. 13"),
];

fn accuracy() -> Axis {
    Axis::linear("accuracy of a range, 1/sigma", "dB")
}

fn rate() -> Axis {
    Axis::log("samples of the IMU", "Hz")
}

pub(super) fn figure_4(studies: &[Study]) -> Vec<Panel> {
    let places = [(REST, "rest", "At rest"), (REST_ISOSCELES, "rest-iso", "At rest, triangle fitted (Iso)")];
    let each = places.iter().flat_map(|place| [&POSITIONS, &ANGLES].map(|quantity| (place, quantity)));
    each.map(|(place, quantity)| panel(studies, place, quantity, accuracy())).collect()
}

pub(super) fn figure_5(studies: &[Study]) -> Vec<Panel> {
    PATHS.iter().map(|place| panel(studies, place, &POSITIONS, accuracy())).collect()
}

pub(super) fn figure_6(studies: &[Study]) -> Vec<Panel> {
    PATHS.iter().map(|place| panel(studies, place, &ANGLES, accuracy())).collect()
}

pub(super) fn rates(studies: &[Study]) -> Vec<Panel> {
    let places = [(SAMPLED, "sampled", "IMU as sampled"), (MATCHED, "matched", "IMU matched to eq. 13")];
    let each = places.iter().flat_map(|place| [&POSITIONS, &ANGLES].map(|quantity| (place, quantity)));
    each.map(|(place, quantity)| panel(studies, place, quantity, rate())).collect()
}

fn panel(studies: &[Study], (index, name, title): &Place, quantity: &Quantity, x: Axis) -> Panel {
    let sweep = Reading::of(studies, *index);
    let curve = |name: FilterName| {
        let point = |(x, summary): (f64, &IndoorSummary)| {
            let IndoorSummary { trials, failures, .. } = *summary;
            Point { x, y: (quantity.read)(summary), trials, failures, reflections: None }
        };
        estimator(name, sweep.of_filter(name).map(point).collect())
    };
    Panel {
        name: format!("{}-{name}", quantity.name),
        title: (*title).to_string(),
        x,
        y: (quantity.axis)(),
        curves: sweep.filters().filter_map(curve).collect(),
    }
}

/// Nothing where there is no point.
fn estimator(name: FilterName, points: Vec<Point>) -> Option<Curve> {
    let (label, kind) = (name.label().to_string(), CurveKind::Estimator);
    (!points.is_empty()).then(|| Curve { name: name.to_string(), label, kind, points })
}

pub(super) fn figure_9(studies: &[Study]) -> Vec<Panel> {
    let noises = [(FINE_DB, "1e-3"), (COARSE_DB, "1e-1")];
    let places = [(SAMPLED, "sampled", "IMU as sampled"), (MATCHED, "matched", "IMU matched to eq. 13")];
    let each = places.iter().flat_map(|place| noises.map(|noise| (place, noise)));
    each.map(|((index, name, title), (decibels, variance))| {
        let sweep = Reading::of(studies, *index);
        Panel {
            name: format!("distribution-{variance}-{name}"),
            title: format!("Bridge, sigma^2 = {variance} m^2, {title}"),
            x: Axis::linear("RMSE of the position in one trial", "m"),
            y: Axis::linear("share of the trials below", ""),
            curves: distributions(sweep, decibels),
        }
    })
    .collect()
}

/// Places at which distributions are drawn.
const PLACES: u32 = 80;

/// How many trials stay below each of the same places for all filters.
fn distributions(sweep: Reading<'_>, decibels: f64) -> Vec<Curve> {
    let at = |name| sweep.of_filter(name).find(|(x, _)| x.to_bits() == decibels.to_bits());
    let found: Vec<(FilterName, &IndoorSummary)> =
        sweep.filters().filter_map(|name| Some((name, at(name)?.1))).collect();
    let largest = found.iter().filter_map(|(_, summary)| summary.position_distribution.last().copied());
    let largest = largest.fold(0.0, f64::max);
    let curve = |(name, summary): &(FilterName, &IndoorSummary)| {
        let points = (0..=PLACES).map(|k| share(summary, largest * f64::from(k) / f64::from(PLACES)));
        estimator(*name, points.collect())
    };
    found.iter().filter_map(curve).collect()
}

/// The share of the trials up to `x`, with the standard error of a share; a trial that failed is up to none.
fn share(summary: &IndoorSummary, x: f64) -> Point {
    let IndoorSummary { trials, failures, .. } = *summary;
    let below = summary.position_distribution.partition_point(|error| *error <= x);
    let value = below as f64 / (trials + failures) as f64;
    let standard_error = sqrt(value * (1.0 - value) / (trials + failures) as f64);
    Point { x, y: Estimate { value, standard_error }, trials, failures, reflections: None }
}
