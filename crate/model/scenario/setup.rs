//! A scenario with its dimension known to the compiler.

use super::{InitialSettings, Scenario};
use crate::error::{Error, Result};
use crate::math::pose::{Pose, Theta};
use crate::model::anchors::Anchors;
use crate::model::document::check::accept;
use crate::model::document::entries::{angles, matrix_from_rows, points, vector};
use crate::model::epoch::Initial;
use crate::model::motion::{Motion, ProcessNoise};
use crate::model::ranging::RangeModel;
use crate::model::topology::Topology;

/// The typed parts of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup<const D: usize> {
    /// Anchors (as given, not redrawn), topology, noise.
    pub model: RangeModel<D>,
    /// True pose before the first epoch.
    pub start: Pose<D>,
    /// Undisturbed motion over each interval.
    pub motion: Motion<D>,
    /// What estimators believe before the first epoch.
    pub initial: Initial<D>,
    /// The process noise that estimators assume.
    pub process: ProcessNoise,
}

impl Scenario {
    /// The typed parts, after validation.
    ///
    /// # Errors
    /// [`Error::Invalid`] with every problem; [`Error::Size`] where `D` is not the scenario's dimension.
    pub fn setup<const D: usize>(&self) -> Result<Setup<D>> {
        accept("scenario", self.validate())?;
        require_dimension::<D>(self.dimension)?;
        Ok(Setup {
            model: RangeModel::new(
                Anchors::new(points(&self.anchors))?,
                Topology::new(points(&self.sensors))?,
                self.noise,
                self.weighting,
            )?,
            start: self.start.to_pose()?,
            motion: Motion {
                interval: self.interval,
                velocity: vector(&self.motion.velocity),
                angular_velocity: angles::<D>(&self.motion.angular_velocity),
            },
            initial: self.initial.typed(),
            process: self.process,
        })
    }
}

impl InitialSettings {
    pub(in crate::model) fn typed<const D: usize>(&self) -> Initial<D> {
        Initial {
            theta: Theta {
                orientation: matrix_from_rows(&self.orientation),
                position: vector(&self.position),
            },
            variance: self.covariance,
        }
    }
}

pub(in crate::model) fn require_dimension<const D: usize>(found: usize) -> Result<()> {
    if found == D {
        Ok(())
    } else {
        Err(Error::Size { what: "dimensions in the document", found, expected: D })
    }
}
