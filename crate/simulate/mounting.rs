//! Sensors that sit a little off the places that estimators are told.

use alloc::vec::Vec;

use nalgebra::SVector;

use super::random::{Part, Stream};
use crate::error::{Error, Result};
use crate::model::scenario::Scenario;
use crate::model::topology::Topology;

/// Most places of a [`mounting_cloud`].
pub const MAX_PLACES: u64 = 1_000_000;

/// Where the sensors of one trial really sit in the body frame, m.
///
/// ```text
/// c_n + e_n,  e_n ~ N(0, sigma_e^2 I)     \[L\] Sec. V and VII
/// ```
///
/// with `sigma_e` the scenario's `mounting_sigma`. The entries of `e_n / sigma_e` are drawn sensor by sensor, so that a
/// change of `sigma_e` scales the displacements, and a sensor appended leaves those of the others as they were.
pub fn mounted_sensors<const D: usize>(
    topology: &Topology<D>,
    scenario: &Scenario,
    trial: u64,
) -> Vec<SVector<f64, D>> {
    let sigma = scenario.mounting_sigma;
    if sigma == 0.0 {
        return topology.sensors().to_vec();
    }
    let mut stream = Stream::new(scenario.seed, trial, Part::Mounting);
    let mut displacement = || SVector::from_fn(|_, _| sigma * stream.normal());
    topology.sensors().iter().map(|c| c + displacement()).collect()
}

/// Where the sensors sit in trials `0..trials` of a scenario, in the body frame, m: trial by trial, sensor by sensor.
///
/// # Errors
/// [`Error::Invalid`] with every problem of the scenario, [`Error::Size`] where `D` is not its dimension,
/// [`Error::Number`] for more than [`MAX_PLACES`].
///
/// ```
/// use rangelab::model::presets::preset;
/// use rangelab::simulate::mounting::mounting_cloud;
/// let mut scenario = preset("room")?;
/// scenario.mounting_sigma = 0.01;
/// assert_eq!(mounting_cloud::<3>(&scenario, 48)?.len(), 48 * scenario.sensors.len());
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn mounting_cloud<const D: usize>(scenario: &Scenario, trials: u64) -> Result<Vec<SVector<f64, D>>> {
    let topology = scenario.setup::<D>()?.model.topology().clone();
    let places = trials.saturating_mul(topology.len() as u64);
    if places > MAX_PLACES {
        let (value, limit) = (places as f64, "at most 1000000: draw fewer trials");
        return Err(Error::Number { what: "the number of places (trials times sensors)", value, limit });
    }
    Ok((0..trials).flat_map(|trial| mounted_sensors(&topology, scenario, trial)).collect())
}
