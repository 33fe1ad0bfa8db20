//! What is drawn in the figures of \[A\].

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::experiments::{DEGREE_2, DEGREE_3, DEGREE_5, DEGREE_6, PAPER};
use super::reading::Quantity::{self, AlignedPosition, Coefficient, Gram, Position};
use super::reading::{Bound, Reading, bound_of, summary};
use crate::model::kinematics::settings::KinematicsName::{
    self, Algorithm1Literal, Algorithm1Rank1, Algorithm1So, Algorithm2Literal, Algorithm2Rank1, Algorithm2So,
    MaximumLikelihood, MaximumLikelihoodAccelerometers, MultidimensionalScaling, RangePolynomial,
    SnapshotSync,
};
use crate::study::figures::experiment::Study;
use crate::study::figures::report::{Axis, Curve, CurveKind, Panel, Point};
use crate::study::kinematics::report::KinematicsReport;

const BOUNDS: [(Bound, &str); 2] =
    [(Bound::Distances, "crb-distances"), (Bound::Accelerations, "crb-accelerometers")];

/// Places of the points of a curve, with the study and the quantity of each.
type Places<'a> = Vec<(f64, &'a KinematicsReport, Quantity)>;

pub(super) fn figure_1(studies: &[Study]) -> Vec<Panel> {
    let degrees = [(DEGREE_2, 2), (DEGREE_3, 3), (PAPER, 4), (DEGREE_5, 5), (DEGREE_6, 6)];
    let panel = |(l, unit): (usize, &str)| {
        let places = |index| over_stamps(Reading::of(studies, index), Gram(l));
        let own = places(PAPER);
        let mut curves = estimators(&[Algorithm1Rank1, Algorithm2Rank1], &own);
        // The fit of the Gram matrix knows nothing of how the second stage goes on.
        curves
            .iter_mut()
            .zip(["Algorithm 1", "Algorithm 2"])
            .for_each(|(curve, label)| curve.label = label.into());
        curves.extend(degrees.iter().filter_map(|&(index, degree)| {
            let name = format!("range-polynomial-{degree}");
            estimator(RangePolynomial, name, format!("Range polynomial, q = {degree}"), &places(index))
        }));
        curves.extend(bounds(&own));
        Panel {
            name: format!("b{l}"),
            title: format!("B{l}"),
            x: stamps(),
            y: Axis::log(&format!("RMSE of an entry of vech(B{l})"), unit),
            curves,
        }
    };
    [(0, "m^2"), (1, "m^2/s"), (2, "m^2/s^2")].map(panel).into()
}

pub(super) fn figure_2a(studies: &[Study]) -> Vec<Panel> {
    let names = [
        Algorithm1Literal,
        Algorithm1Rank1,
        Algorithm1So,
        Algorithm2Literal,
        Algorithm2Rank1,
        Algorithm2So,
        SnapshotSync,
        MaximumLikelihood,
        MaximumLikelihoodAccelerometers,
    ];
    let panel = |(l, (title, unit)): (usize, (&str, &str))| {
        let places = over_stamps(Reading::of(studies, PAPER), Coefficient(l));
        let curves = [estimators(&names, &places), bounds(&places)].concat();
        let y = Axis::log(&format!("RMSE of a coordinate of Y{l}"), unit);
        Panel { name: format!("y{l}"), title: title.to_string(), x: stamps(), y, curves }
    };
    let panels = [("Positions Y0", "m"), ("Velocities Y1", "m/s"), ("Accelerations Y2", "m/s^2")];
    panels.into_iter().enumerate().map(panel).collect()
}

pub(super) fn figure_2b(studies: &[Study]) -> Vec<Panel> {
    let names = [
        Algorithm1Rank1,
        Algorithm2Rank1,
        Algorithm2So,
        SnapshotSync,
        MaximumLikelihood,
        MaximumLikelihoodAccelerometers,
        MultidimensionalScaling,
    ];
    let panel = |(name, title, quantity): (&str, &str, fn(usize) -> Quantity)| {
        let places = over_time(Reading::of(studies, PAPER), quantity);
        let curves = [estimators(&names, &places), bounds(&places)].concat();
        let (x, y) = (Axis::linear("time", "s"), Axis::log("RMSE of a coordinate", "m"));
        Panel { name: name.to_string(), title: title.to_string(), x, y, curves }
    };
    [
        ("one-alignment", "Positions, aligned once, at t = 0", Position as fn(usize) -> Quantity),
        ("aligned-at-each", "Positions, aligned at each instant", AlignedPosition),
    ]
    .map(panel)
    .into()
}

fn stamps() -> Axis {
    Axis::log("number of stamps K", "")
}

fn over_stamps(sweep: Reading<'_>, quantity: Quantity) -> Places<'_> {
    sweep.points().iter().map(|point| (point.stamps as f64, point, quantity)).collect()
}

/// Of the sweep's first number of stamps.
fn over_time(sweep: Reading<'_>, quantity: fn(usize) -> Quantity) -> Places<'_> {
    let instants = sweep.points().iter().take(1).flat_map(|point| {
        point.instants.iter().enumerate().map(move |(i, &time)| (time, point, quantity(i)))
    });
    instants.collect()
}

fn estimators(names: &[KinematicsName], places: &Places<'_>) -> Vec<Curve> {
    let curve = |&name| estimator(name, called(name).to_string(), name.label().to_string(), places);
    names.iter().filter_map(curve).collect()
}

/// By its own name, where no other figure has an estimator of that name.
fn called(name: KinematicsName) -> &'static str {
    if name == MaximumLikelihood { "maximum-likelihood-distances" } else { name.name() }
}

/// Nothing where there is no point.
fn estimator(name: KinematicsName, called: String, label: String, places: &Places<'_>) -> Option<Curve> {
    let point = |&(x, point, quantity): &(f64, &KinematicsReport, Quantity)| {
        let summary = summary(point, name)?;
        let (trials, failures) = (summary.trials, summary.failures);
        Some(Point { x, y: quantity.of(summary)?, trials, failures, reflections: None })
    };
    curve(called, label, CurveKind::Estimator, places.iter().filter_map(point).collect())
}

fn bounds(places: &Places<'_>) -> Vec<Curve> {
    let bound = |(which, name): (Bound, &str)| {
        let point = |&(x, point, quantity): &(f64, &KinematicsReport, Quantity)| {
            let y = quantity.bound(bound_of(point, which)?)?;
            Some(Point { x, y, trials: point.trials, failures: 0, reflections: None })
        };
        let label = bound_of(places.first()?.1, which)?.label.clone();
        curve(name.to_string(), label, CurveKind::Bound, places.iter().filter_map(point).collect())
    };
    BOUNDS.into_iter().filter_map(bound).collect()
}

fn curve(name: String, label: String, kind: CurveKind, points: Vec<Point>) -> Option<Curve> {
    (!points.is_empty()).then_some(Curve { name, label, kind, points })
}
