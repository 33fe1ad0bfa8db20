//! The field of a scenario, whatever it shows.

use alloc::vec::Vec;

use super::NextAnchor;
use crate::bounds::field::{FieldLayout, field_of};
use crate::error::Result;
use crate::model::field_settings::Subject;
use crate::model::scenario::Scenario;
use crate::with_dimension;

/// Some rows of the scenario's field, row by row: the bound of its body at each cell, or the value of its placement with
/// one more anchor there. m or rad; [`crate::bounds::field::NONE`] where there is none.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario; [`crate::Error::Number`] where sums overflow.
pub fn field_rows(scenario: &Scenario, layout: &FieldLayout, first: usize, count: usize) -> Result<Vec<f64>> {
    with_dimension!(scenario.dimension, D => Ok(match scenario.field.subject {
        Subject::Body => field_of::<D>(scenario)?.rows(layout, first, count),
        Subject::NextAnchor => NextAnchor::<D>::of(scenario)?.rows(layout, first, count),
    }))
}
