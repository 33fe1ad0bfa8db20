//! Where one more anchor helps most.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use nalgebra::SVector;
use serde::Serialize;

use super::{NextAnchor, Placement};
use crate::bounds::field::{FieldLayout, NONE, layout_of};
use crate::error::{Error, Result};
use crate::model::scenario::Scenario;
use crate::with_dimension;

/// What one more anchor is worth at a point.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct NextPlace {
    /// The point, m.
    pub point: Vec<f64>,
    /// The unit of the values, m or rad.
    pub unit: String,
    /// Value of the anchors of the scenario; null where no bound exists.
    pub before: Option<f64>,
    /// Value with one more anchor there; null where none may stand and where no bound exists even so.
    pub after: Option<f64>,
    /// Why there is no value with it; null where there is.
    pub cause: Option<String>,
}

/// Cells along the longer edge of the grid that the search starts from.
const GRID: usize = 24;
/// So many of its lowest dips are the starts.
const STARTS: usize = 6;
const DIRECTIONS: [[f64; 2]; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
/// A search ends where its steps are this part of an edge of the grid.
const LEAST_STEP: f64 = 1e-5;
/// More are not needed: each that gains nothing halves the next.
const MOST_STEPS: usize = 200;

/// One more anchor at a point (D coordinates, m), judged by the `placement` of a scenario.
///
/// # Errors
/// [`Error::Invalid`] with every problem of the scenario, [`Error::Size`] for too few or too many coordinates,
/// [`Error::Number`] where sums overflow.
pub fn next_at(scenario: &Scenario, point: &[f64]) -> Result<NextPlace> {
    with_dimension!(scenario.dimension, D => {
        if point.len() != D {
            let (what, found, expected) = ("coordinates of the point", point.len(), D);
            return Err(Error::Size { what, found, expected });
        }
        place_at::<D>(scenario, &NextAnchor::of(scenario)?, &SVector::from_column_slice(point))
    })
}

/// The best place of one more anchor in the plane of the scenario's field, within its rectangle: the lowest dips of
/// a grid, then ever shorter steps. None where no place gives a bound.
///
/// # Errors
/// As [`next_at`].
///
/// ```
/// use rangelab::model::presets::preset;
/// use rangelab::place::best_next;
/// let best = best_next(&preset("room")?)?.unwrap();
/// assert!(best.after < best.before);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn best_next(scenario: &Scenario) -> Result<Option<NextPlace>> {
    with_dimension!(scenario.dimension, D => {
        let (next, layout) = (NextAnchor::<D>::of(scenario)?, layout_of::<D>(scenario, GRID)?);
        let best = search(&next, &layout);
        best.map(|point| place_at(scenario, &next, &point)).transpose()
    })
}

fn place_at<const D: usize>(
    scenario: &Scenario,
    next: &NextAnchor<D>,
    point: &SVector<f64, D>,
) -> Result<NextPlace> {
    let (placement, mut anchors) = (Placement::<D>::of(scenario)?, Placement::<D>::anchors_of(scenario));
    let (before, value) = (placement.value(&anchors).ok(), next.value(point));
    anchors.push(*point);
    let unseen = || placement.value(&anchors).err().map(|error| error.to_string());
    let after = (value < NONE).then_some(value);
    Ok(NextPlace {
        point: point.as_slice().to_vec(),
        unit: placement.figure.unit().to_string(),
        before,
        after,
        cause: if after.is_some() { None } else { next.refusal(point).or_else(unseen) },
    })
}

fn search<const D: usize>(next: &NextAnchor<D>, layout: &FieldLayout) -> Option<SVector<f64, D>> {
    let point = |place: [f64; 2]| SVector::<f64, D>::from_column_slice(&layout.at(place)[..D]);
    let value = |place: [f64; 2]| {
        let inside = place.iter().all(|part| (0.0..=1.0).contains(part));
        if inside { next.value(&point(place)) } else { NONE }
    };
    let mut cells = dips(&next.rows(layout, 0, layout.height), layout);
    cells.sort_by(|a, b| a.1.total_cmp(&b.1));
    let step = 0.5 / layout.width.max(layout.height) as f64;
    let start = |&(k, least): &(usize, f64)| (layout.part(k % layout.width, k / layout.width), least);
    let found = cells.iter().take(STARTS).map(|cell| polished(start(cell), step, value));
    found.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(place, _)| point(place))
}

/// Cells with a value that is no larger than that of their neighbours.
fn dips(values: &[f64], layout: &FieldLayout) -> Vec<(usize, f64)> {
    let lowest = |k: usize| {
        let (column, row) = (k % layout.width, k / layout.width);
        let rows = row.saturating_sub(1)..=(row + 1).min(layout.height - 1);
        let columns = column.saturating_sub(1)..=(column + 1).min(layout.width - 1);
        rows.flat_map(|j| columns.clone().map(move |i| j * layout.width + i))
            .all(|other| values[k] <= values[other])
    };
    let cells = values.iter().copied().enumerate();
    cells.filter(|&(k, value)| value < NONE && lowest(k)).collect()
}

/// Steps along both edges and both diagonals, halved where none gains.
fn polished(
    (mut best, mut least): ([f64; 2], f64),
    mut step: f64,
    value: impl Fn([f64; 2]) -> f64,
) -> ([f64; 2], f64) {
    for _ in 0..MOST_STEPS {
        if step < LEAST_STEP {
            break;
        }
        let moved = DIRECTIONS.map(|[i, j]| [best[0] + i * step, best[1] + j * step]);
        let judged = moved.into_iter().map(|place| (place, value(place)));
        match judged.min_by(|a, b| a.1.total_cmp(&b.1)) {
            Some(found) if found.1 < least => (best, least) = found,
            _ => step *= 0.5,
        }
    }
    (best, least)
}
