//! The rules of a path.

use alloc::vec::Vec;

use super::PathSettings;
use crate::math::float::sqrt;
use crate::model::document::check::{Check, Limit};

/// Most points of a drawn path.
const MAX_POINTS: usize = 200;
/// Points closer than this, m, give a curve no direction.
const LEAST_DISTANCE: f64 = 1e-6;

/// Adds what is wrong with a path that begins at `start`.
pub fn check(check: &mut Check, settings: &PathSettings, dimension: Option<usize>, start: &[f64]) {
    let (PathSettings::Turn { period, .. }
    | PathSettings::FigureEight { period, .. }
    | PathSettings::Helix { period, .. }
    | PathSettings::Drawn { period, .. }) = settings;
    check.number("motion.path.period", *period, Limit::PERIOD);
    match settings {
        PathSettings::Turn { radius, .. } | PathSettings::FigureEight { radius, .. } => {
            check.number("motion.path.radius", *radius, Limit::LENGTH);
        }
        PathSettings::Helix { radius, climb, .. } => {
            if dimension == Some(2) {
                let allowed = "turn, figure_eight or drawn: the plane has no height to climb";
                check.problem("motion.path.kind", "helix", allowed);
            }
            check.number("motion.path.radius", *radius, Limit::LENGTH);
            check.number("motion.path.climb", *climb, Limit::COORDINATE);
        }
        PathSettings::Drawn { points, closed, .. } => drawn(check, points, *closed, dimension, start),
    }
}

fn drawn(check: &mut Check, points: &[Vec<f64>], closed: bool, dimension: Option<usize>, start: &[f64]) {
    check.count("motion.path.points", points.len(), 1, MAX_POINTS);
    for (i, point) in points.iter().enumerate() {
        check.vector(format_args!("motion.path.points[{i}]"), point, dimension, Limit::COORDINATE);
    }
    let befores = core::iter::once(start).chain(points.iter().map(Vec::as_slice));
    for (i, (before, point)) in befores.zip(points).enumerate() {
        let place = if i == 0 { "where the path starts" } else { "where the point before it is" };
        apart(check, i, before, point, place);
    }
    if let Some(last) = points.last().filter(|_| closed && points.len() > 1) {
        let place = "where the path starts, to which a closed path returns by itself";
        apart(check, points.len() - 1, start, last, place);
    }
}

fn apart(check: &mut Check, i: usize, before: &[f64], point: &[f64], place: &str) {
    let squared: f64 = before.iter().zip(point).map(|(a, b)| (a - b) * (a - b)).sum();
    if before.len() == point.len() && sqrt(squared) < LEAST_DISTANCE {
        let path = format_args!("motion.path.points[{i}]");
        check.problem(path, place, format_args!("points at least {LEAST_DISTANCE:e} m apart"));
    }
}
