//! What a geometry can see: bounds at a pose and over a plane, and where anchors should stand.

use pyo3::prelude::*;
use rangelab::bounds::field::{NONE, layout_of};
use rangelab::bounds::size::orientation_against_size;
use rangelab::model::scenario;
use rangelab::place;
use rangelab::study::exploration;
use rangelab::with_dimension;

use crate::array::{Numbers, array};
use crate::compute::compute;
use crate::documents::{Scenario, json};

/// JSON of the crate's `Exploration`.
#[pyfunction]
pub fn explore(py: Python<'_>, scenario: &Scenario) -> PyResult<String> {
    compute(py, || Ok(json(&exploration::explore(&scenario.0)?)))
}

/// JSON of the crate's `PointBound`.
#[pyfunction]
pub fn bound_at(py: Python<'_>, scenario: &Scenario, point: Numbers) -> PyResult<String> {
    compute(py, || Ok(json(&exploration::bound_at(&scenario.0, &point.entries)?)))
}

/// The field (rows x columns, NaN where there is no bound) and where its corner and its two edges are (3 x 3).
#[pyfunction]
pub fn field<'py>(
    py: Python<'py>,
    scenario: &Scenario,
    resolution: usize,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let scenario = &scenario.0;
    let (layout, values) = compute(py, || {
        let layout = with_dimension!(scenario.dimension, D => layout_of::<D>(scenario, resolution))?;
        let values = place::field_rows(scenario, &layout, 0, layout.height)?;
        Ok((layout, values))
    })?;
    let values = values.into_iter().map(|value| if value < NONE { value } else { f64::NAN });
    let edges = [layout.corner, layout.u, layout.v];
    Ok((array(py, &[layout.height, layout.width], values)?, array(py, &[3, 3], edges.into_iter().flatten())?))
}

/// The bound on the orientation (rad) of bodies so many times larger; NaN where there is none.
#[pyfunction]
pub fn size_curve<'py>(py: Python<'py>, scenario: &Scenario, scales: Numbers) -> PyResult<Bound<'py, PyAny>> {
    let scenario = &scenario.0;
    let curve = compute(py, || {
        with_dimension!(scenario.dimension, D => {
            let scenario::Setup { model, availability, start, .. } = &scenario.setup::<D>()?;
            orientation_against_size(model, availability, start, scenario.field.form, &scales.entries)
        })
    })?;
    array(py, &[curve.len()], curve.into_iter().map(|bound| bound.unwrap_or(f64::NAN)))
}

/// JSON of the crate's `Advice`.
#[pyfunction]
pub fn advise(py: Python<'_>, scenario: &Scenario) -> PyResult<String> {
    compute(py, || Ok(json(&place::advise(&scenario.0)?)))
}

/// JSON of the crate's `Improvement`, and the scenario with its anchors moved.
#[pyfunction]
pub fn improve(py: Python<'_>, scenario: &Scenario, restart: u64) -> PyResult<(String, Scenario)> {
    compute(py, || {
        let found = place::improve(&scenario.0, restart)?;
        Ok((json(&found), Scenario(found.applied_to(&scenario.0))))
    })
}

/// JSON of the crate's `NextPlace`.
#[pyfunction]
pub fn next_at(py: Python<'_>, scenario: &Scenario, point: Numbers) -> PyResult<String> {
    compute(py, || Ok(json(&place::next_at(&scenario.0, &point.entries)?)))
}

/// JSON of the crate's `NextPlace`, or null.
#[pyfunction]
pub fn best_next(py: Python<'_>, scenario: &Scenario) -> PyResult<String> {
    compute(py, || Ok(json(&place::best_next(&scenario.0)?)))
}
