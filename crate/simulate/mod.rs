//! Floor 2: recordings drawn from a scenario. No estimator imports this: what is true reaches nobody but
//! [`Recording::truth`](crate::model::epoch::Recording::truth).

pub mod imu;
pub mod indoor;
pub mod kinematics;
pub mod measure;
pub mod mounting;
pub mod random;
pub mod trajectory;

use alloc::vec::Vec;

use nalgebra::SVector;

use crate::error::Result;
use crate::model::anchors::Anchors;
use crate::model::epoch::{Epoch, Recording};
use crate::model::ranging::RangeModel;
use crate::model::scenario::{Scenario, Setup, WeightSource};
use crate::model::topology::Topology;
use measure::measure;
use mounting::mounted_sensors;
use random::{Part, Stream};
use trajectory::trajectory;

/// Draws one trial of a scenario.
///
/// The same scenario and trial give the same bits everywhere, and trials may be drawn in any order. Random numbers are
/// common: a change of geometry or noise changes no draw, only what is made of it; more epochs leave the earlier ones
/// as they were, an anchor appended leaves the draws of the others as they were.
///
/// Ranges are measured to where the sensors really sit in this trial ([`mounting`]); the recording's model, by which
/// estimators and bounds read them, and the true ranges that may give the weights keep to the places given.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario, [`crate::Error::Number`] where a range overflows.
///
/// ```
/// use rangelab::model::presets::preset;
/// use rangelab::simulate::simulate;
/// let recording = simulate::<3>(&preset("room")?, 0)?;
/// assert_eq!(recording, simulate::<3>(&preset("room")?, 0)?);
/// assert_ne!(recording, simulate::<3>(&preset("room")?, 1)?);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn simulate<const D: usize>(scenario: &Scenario, trial: u64) -> Result<Recording<D>> {
    let setup = scenario.setup::<D>()?;
    let model = anchored(scenario, &setup, trial)?;
    let mounted = mounted(scenario, &model, trial)?;
    let mut stream = Stream::new(scenario.seed, trial, Part::Motion);
    let truth = trajectory(&setup, &scenario.motion, &mut stream);
    let mut epochs = Vec::with_capacity(truth.len());
    for (k, pose) in truth.iter().enumerate() {
        let exact = mounted.exact_ranges(&(*pose).into())?;
        let measurable = mounted.measurable(pose, &setup.availability);
        let weighs = scenario.weights == WeightSource::True;
        let mut stream = Stream::new(scenario.seed, trial, Part::Epoch(k));
        epochs.push(Epoch {
            motion: setup.motions[k],
            ranges: measure(&model, &exact, &measurable, scenario.missing_probability, &mut stream)?,
            true_ranges: weighs.then(|| model.exact_ranges(&(*pose).into())).transpose()?,
        });
    }
    Ok(Recording {
        model,
        initial: setup.initial,
        process: setup.process,
        epochs,
        truth: truth.into_iter().map(Some).collect(),
    })
}

/// The model with the anchors of this trial.
fn anchored<const D: usize>(scenario: &Scenario, setup: &Setup<D>, trial: u64) -> Result<RangeModel<D>> {
    let model = &setup.model;
    let Some(redraw) = scenario.redraw_anchors else { return Ok(model.clone()) };
    let mut stream = Stream::new(scenario.seed, trial, Part::Anchors);
    let mut point = || SVector::from_fn(|_, _| (2.0 * stream.uniform() - 1.0) * redraw.half_width);
    let anchors = (0..model.anchors().len()).map(|_| point()).collect();
    RangeModel::new(Anchors::new(anchors)?, model.topology().clone(), *model.noise(), model.weighting())
}

/// The model with the sensors where they really sit in this trial.
fn mounted<const D: usize>(scenario: &Scenario, model: &RangeModel<D>, trial: u64) -> Result<RangeModel<D>> {
    let topology = Topology::new(mounted_sensors(model.topology(), scenario, trial))?;
    RangeModel::new(model.anchors().clone(), topology, *model.noise(), model.weighting())
}
