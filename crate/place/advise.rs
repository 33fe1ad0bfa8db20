//! What the anchors of a scenario are worth, and which way each of them should go.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::Serialize;

use super::figure::Sharpness;
use super::{Placement, Zone};
use crate::error::Result;
use crate::model::document::entries::coordinates;
use crate::model::scenario::Scenario;
use crate::with_dimension;

/// The anchors as they are.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Advice {
    /// The unit of the value, m or rad.
    pub unit: String,
    /// What is to be small; null where no bound exists.
    pub value: Option<f64>,
    /// Why no bound exists; null where it does.
    pub cause: Option<String>,
    /// Derivative of the value with the position of each anchor, m/m or rad/m: anchors go against it. Where no bound
    /// exists a weak prior stands in for what is not seen.
    pub gradient: Vec<Vec<f64>>,
}

/// Judges the anchors of a scenario by its `placement`.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario; [`crate::Error::Number`] where sums overflow.
///
/// ```
/// use rangelab::model::presets::preset;
/// use rangelab::place::{advise, improve};
/// let room = preset("room")?;
/// assert_eq!(advise(&room)?.value, improve(&room, 0)?.before);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn advise(scenario: &Scenario) -> Result<Advice> {
    with_dimension!(scenario.dimension, D => judge::<D>(scenario))
}

fn judge<const D: usize>(scenario: &Scenario) -> Result<Advice> {
    let placement = Placement::<D>::of(scenario)?;
    let anchors = Placement::<D>::anchors_of(scenario);
    let value = placement.value(&anchors);
    let prior = match value {
        Ok(_) => None,
        Err(_) => Some(placement.weak_prior(&anchors, Zone::around(&anchors).extent())?),
    };
    let (_, gradient) = placement.differentiate(&anchors, prior, Sharpness::Exact)?;
    Ok(Advice {
        unit: placement.figure.unit().to_string(),
        cause: value.as_ref().err().map(ToString::to_string),
        value: value.ok(),
        gradient: coordinates(&gradient),
    })
}
