//! The error-state filter on the ranges themselves: tightly coupled.

use super::error_state::Navigation;
use super::filter::{ErrorVector, FixRecord, InertialFilter, InertialStep, check_epoch};
use super::trilateration::line_of_sight;
use crate::error::Result;
use crate::math::linalg::add_outer;
use crate::model::indoor::epoch::{IndoorEpoch, IndoorModel, IndoorStart};

/// Every range counts, also where a transmitter has too few to be found by itself. A range to a beacon that the transmitter
/// is believed to touch has no direction and is left out.
#[derive(Clone, Debug)]
pub struct TightFilter {
    model: IndoorModel,
    belief: Navigation,
}

impl TightFilter {
    /// Starts from the prior.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the prior is no covariance.
    pub fn new(model: &IndoorModel, start: &IndoorStart) -> Result<Self> {
        Ok(Self { model: model.clone(), belief: Navigation::before(start)? })
    }
}

/// Updates with one range after the other, all linearized at the prediction: the same as all at once, for their noise is
/// independent.
fn update(belief: &mut Navigation, model: &IndoorModel, epoch: &IndoorEpoch) -> Option<FixRecord> {
    let state = belief.state;
    let (mut error, mut nis, mut count) = (ErrorVector::zeros(), 0.0, 0);
    let variance = model.sigma * model.sigma;
    for (beacon, ranges) in model.beacons.iter().zip(&epoch.ranges) {
        for (c, range) in model.transmitters.iter().zip(ranges) {
            let Some(range) = range else { continue };
            let Ok((distance, direction)) = line_of_sight(beacon, &state.act(c)) else { continue };
            let turned = c.cross(&(state.rotation.matrix().transpose() * direction));
            let row = ErrorVector::from_fn(|k, _| match k {
                0..3 => turned[k],
                3..6 => direction[k - 3],
                _ => 0.0,
            });
            let cross = belief.covariance * row;
            let spread = row.dot(&cross) + variance;
            let innovation = range - distance - row.dot(&error);
            error += cross * (innovation / spread);
            add_outer(&mut belief.covariance, -1.0 / spread, &cross, &cross);
            nis += innovation * innovation / spread;
            count += 1;
        }
    }
    belief.correct(&error);
    (count > 0).then_some(FixRecord { nis, degrees_of_freedom: count })
}

impl InertialFilter for TightFilter {
    fn step(&mut self, epoch: &IndoorEpoch) -> Result<InertialStep> {
        check_epoch(epoch)?;
        let mut belief = self.belief;
        belief.predict(&self.model, epoch)?;
        let record = update(&mut belief, &self.model, epoch);
        belief.check()?;
        belief.symmetrize();
        self.belief = belief;
        Ok(belief.step(record))
    }
}
