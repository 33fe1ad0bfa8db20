//! A scenario with its dimension known to the compiler.

use alloc::vec;
use alloc::vec::Vec;

use super::{InitialSettings, Scenario};
use crate::error::{Error, Result};
use crate::math::pose::{Pose, Theta};
use crate::model::anchors::Anchors;
use crate::model::availability::Availability;
use crate::model::document::check::accept;
use crate::model::document::entries::{angles, matrix_from_rows, points, vector};
use crate::model::epoch::Initial;
use crate::model::motion::{Motion, ProcessNoise};
use crate::model::path::Path;
use crate::model::ranging::RangeModel;
use crate::model::topology::Topology;

/// The typed parts of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup<const D: usize> {
    /// Anchors (as given, not redrawn), topology, noise.
    pub model: RangeModel<D>,
    /// Which ranges can be measured.
    pub availability: Availability<D>,
    /// True pose before the first epoch; on a path it looks along it.
    pub start: Pose<D>,
    /// Undisturbed motion over each interval, one a step.
    pub motions: Vec<Motion<D>>,
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
        let (start, motions) = self.undisturbed(self.start.to_pose()?);
        Ok(Setup {
            model: RangeModel::new(
                Anchors::new(points(&self.anchors))?,
                Topology::new(points(&self.sensors))?,
                self.noise,
                self.weighting,
            )?,
            availability: Availability::new(&self.availability),
            start,
            motions,
            initial: self.initial.typed(),
            process: self.process,
        })
    }

    /// Where the body starts, and its motion over each interval: that of the path plus the constant velocities.
    fn undisturbed<const D: usize>(&self, start: Pose<D>) -> (Pose<D>, Vec<Motion<D>>) {
        let constant = Motion {
            interval: self.interval,
            velocity: vector(&self.motion.velocity),
            angular_velocity: angles::<D>(&self.motion.angular_velocity),
        };
        let Some(settings) = &self.motion.path else { return (start, vec![constant; self.steps]) };
        let path = Path::new(settings, &start);
        let along = path.motions(self.interval).take(self.steps);
        (path.start(), along.map(|motion| motion.plus(&constant)).collect())
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
