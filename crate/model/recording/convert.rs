//! Recordings with their dimension known to the compiler, and back.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::{EpochDocument, RecordingDocument};
use crate::error::Result;
use crate::math::pose::{Pose, Theta};
use crate::math::rotation::rotation_angles;
use crate::model::anchors::Anchors;
use crate::model::document::VERSION;
use crate::model::document::check::accept;
use crate::model::document::entries::{PoseEntries, angles, coordinates, points, rows, vector};
use crate::model::epoch::{Epoch, Recording};
use crate::model::motion::Motion;
use crate::model::ranges::Ranges;
use crate::model::ranging::RangeModel;
use crate::model::scenario::setup::require_dimension;
use crate::model::scenario::{InitialSettings, WeightSource};
use crate::model::topology::Topology;

impl RecordingDocument {
    /// The typed recording, after validation.
    ///
    /// # Errors
    /// [`crate::Error::Invalid`] with every problem; [`crate::Error::Size`] where `D` is not its dimension.
    pub fn recording<const D: usize>(&self) -> Result<Recording<D>> {
        accept("recording", self.validate())?;
        require_dimension::<D>(self.dimension)?;
        let model = RangeModel::new(
            Anchors::new(points(&self.anchors))?,
            Topology::new(points(&self.sensors))?,
            self.noise,
            self.weighting,
        )?;
        let mut epochs = Vec::with_capacity(self.epochs.len());
        let mut truth = Vec::with_capacity(self.epochs.len());
        for epoch in &self.epochs {
            let pose = epoch.truth.as_ref().map(PoseEntries::to_pose::<D>).transpose()?;
            epochs.push(epoch.typed(&model, pose.filter(|_| self.weights == WeightSource::True))?);
            truth.push(pose);
        }
        Ok(Recording { model, initial: self.initial.typed(), process: self.process, epochs, truth })
    }

    /// The document of a typed recording.
    pub fn new<const D: usize>(name: &str, recording: &Recording<D>) -> Self {
        let Recording { model, initial, process, epochs, truth } = recording;
        let Theta { orientation, position } = initial.theta;
        let weighted_by_truth = epochs.iter().any(|epoch| epoch.true_ranges.is_some());
        Self {
            version: VERSION,
            name: name.to_string(),
            dimension: D,
            anchors: coordinates(model.anchors().positions()),
            sensors: coordinates(model.topology().sensors()),
            noise: *model.noise(),
            weights: if weighted_by_truth { WeightSource::True } else { WeightSource::Measured },
            weighting: model.weighting(),
            initial: InitialSettings {
                orientation: rows(&orientation),
                position: position.as_slice().to_vec(),
                covariance: initial.variance,
            },
            process: *process,
            epochs: epochs.iter().zip(truth).map(|(epoch, pose)| EpochDocument::new(epoch, *pose)).collect(),
        }
    }
}

impl EpochDocument {
    fn typed<const D: usize>(&self, model: &RangeModel<D>, truth: Option<Pose<D>>) -> Result<Epoch<D>> {
        // Validation saw to it that one of the two is there, in this size.
        let entry = |m: usize, n: usize| match (&self.squared_ranges, &self.ranges) {
            (Some(squared), _) => squared[m][n],
            (None, Some(ranges)) => ranges[m][n].map(|range| range * range),
            (None, None) => None,
        };
        Ok(Epoch {
            motion: Motion {
                interval: self.interval,
                velocity: vector(&self.velocity),
                angular_velocity: angles::<D>(&self.angular_velocity),
            },
            ranges: Ranges::from_fn(model.anchors().len(), model.topology().len(), entry)?,
            true_ranges: truth.map(|pose| model.exact_ranges(&pose.into())).transpose()?,
        })
    }

    fn new<const D: usize>(epoch: &Epoch<D>, truth: Option<Pose<D>>) -> Self {
        let Epoch { motion, ranges, .. } = epoch;
        let row = |m: usize| (0..ranges.sensors()).map(|n| ranges.get(m, n)).collect();
        Self {
            interval: motion.interval,
            velocity: motion.velocity.as_slice().to_vec(),
            angular_velocity: motion.angular_velocity[..rotation_angles(D)].to_vec(),
            squared_ranges: Some((0..ranges.anchors()).map(row).collect()),
            ranges: None,
            truth: truth.map(Into::into),
        }
    }
}
