//! What a geometry can see: the bound at a pose and over a plane.

use rangelab::bounds::field::{FieldLayout, field_of, layout_of};
use rangelab::bounds::size::orientation_against_size;
use rangelab::model::scenario::Scenario;
use rangelab::simulate::mounting;
use rangelab::study::exploration;
use rangelab::with_dimension;
use rangelab_wasm_shared::json;
use wasm_bindgen::prelude::*;

/// What the geometry of a scenario (JSON) can and cannot see at the pose its body starts from: the JSON of the crate's
/// `Exploration`.
///
/// # Errors
/// A sentence with every problem of the scenario.
#[wasm_bindgen]
pub fn explore(scenario: &str) -> Result<String, JsError> {
    Ok(json(&exploration::explore(&Scenario::from_json(scenario)?)?))
}

/// Where the cells of the scenario's field lie, `resolution` of them along the longer edge: the JSON of the crate's
/// `FieldLayout`.
///
/// # Errors
/// A sentence for a bad scenario or resolution.
#[wasm_bindgen]
pub fn field_layout(scenario: &str, resolution: usize) -> Result<String, JsError> {
    Ok(json(&layout(&Scenario::from_json(scenario)?, resolution)?))
}

/// Some rows of the scenario's field, of its body or of one more anchor, row by row: m or rad, 1e30 where there is no
/// bound and where no anchor may stand.
///
/// # Errors
/// As [`field_layout`].
#[wasm_bindgen]
pub fn field_rows(
    scenario: &str,
    resolution: usize,
    first_row: usize,
    rows: usize,
) -> Result<Vec<f32>, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    let layout = layout(&scenario, resolution)?;
    let values = rangelab::place::field_rows(&scenario, &layout, first_row, rows)?;
    #[allow(clippy::cast_possible_truncation, reason = "colours need no more digits; read-outs are probes")]
    Ok(values.into_iter().map(|value| value as f32).collect())
}

/// The program (WGSL) by which a graphics device computes the field of the scenario's body from [`field_parameters`]. There
/// is none for one more anchor.
///
/// # Errors
/// As [`field_layout`].
#[wasm_bindgen]
pub fn field_program(scenario: &str) -> Result<String, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    Ok(with_dimension!(scenario.dimension, D => field_of::<D>(&scenario))?.program())
}

/// The numbers that [`field_program`] reads; the grid over the same rectangle may have any number of cells.
///
/// # Errors
/// As [`field_layout`].
#[wasm_bindgen]
pub fn field_parameters(scenario: &str) -> Result<Vec<f32>, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    let layout = layout(&scenario, 1)?;
    Ok(with_dimension!(scenario.dimension, D => field_of::<D>(&scenario))?.parameters(&layout))
}

/// The bound of the scenario's body at a point of the world (D coordinates, m): the JSON of the crate's `PointBound`.
///
/// # Errors
/// A sentence for a bad scenario or point.
#[wasm_bindgen]
pub fn field_probe(scenario: &str, point: &[f64]) -> Result<String, JsError> {
    Ok(json(&exploration::bound_at(&Scenario::from_json(scenario)?, point)?))
}

/// The bound on the orientation (rad) where the sensors are as many times farther from the body's origin as each scale
/// says; NaN where there is none.
///
/// # Errors
/// A sentence for a bad scenario or scale.
#[wasm_bindgen]
pub fn size_curve(scenario: &str, scales: &[f64]) -> Result<Vec<f64>, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    let curve = with_dimension!(scenario.dimension, D => {
        let setup = scenario.setup::<D>()?;
        orientation_against_size(&setup.model, &setup.availability, &setup.start, scenario.field.form, scales)
    })?;
    Ok(curve.into_iter().map(|bound| bound.unwrap_or(f64::NAN)).collect())
}

/// Where the sensors sit on the body in trials `0..trials`, in the body frame, m: trial by trial, sensor by sensor, D
/// numbers each.
///
/// # Errors
/// A sentence for a bad scenario or for more than a million places.
#[wasm_bindgen]
pub fn mounting_cloud(scenario: &str, trials: u32) -> Result<Vec<f64>, JsError> {
    let scenario = Scenario::from_json(scenario)?;
    let places = with_dimension!(scenario.dimension, D => {
        let places = mounting::mounting_cloud::<D>(&scenario, u64::from(trials))?;
        Ok(places.iter().flat_map(|place| place.iter().copied()).collect())
    })?;
    Ok(places)
}

fn layout(scenario: &Scenario, resolution: usize) -> rangelab::Result<FieldLayout> {
    with_dimension!(scenario.dimension, D => layout_of::<D>(scenario, resolution))
}
