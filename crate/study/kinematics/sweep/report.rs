//! What a sweep found.

use alloc::vec::Vec;

use super::{KinematicsSweep, KinematicsSweepBlock};
use crate::study::kinematics::report::KinematicsReport;

/// The figures of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsSweepReport {
    /// Trials that were run at each K.
    pub trials: usize,
    /// A study for each K.
    pub points: Vec<KinematicsReport>,
}

impl KinematicsSweepReport {
    pub(super) fn new(sweep: &KinematicsSweep, done: &KinematicsSweepBlock) -> Self {
        let points = sweep.points.iter().zip(done.points()).enumerate().map(|(index, (point, block))| {
            let bounds = done.bounds().get(index).map_or_else(Vec::new, |bounds| bounds.to_vec());
            KinematicsReport::new(&sweep.scenario, (&point.setup, &point.yardstick), block, bounds)
        });
        Self { trials: done.trials(), points: points.collect() }
    }
}
