//! The Cramér-Rao bounds that a study is held against, at the true motion.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use super::errors::{GRAM_COEFFICIENTS, Yardstick};
use crate::bounds::kinematics::{Alignment, KinematicsBound, KinematicsDesign};
use crate::error::Result;
use crate::model::kinematics::{KinematicsScenario, KinematicsSetup};

/// A bound on the figures of a summary, in the same units.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsBoundReport {
    /// Its name for people.
    pub label: String,
    /// Whether accelerations are read.
    pub accelerations: bool,
    /// Why there is none, in a sentence; the lists are empty then.
    pub failure: Option<String>,
    /// On a coordinate of `Y_0, Y_1, ...`, m/s^l.
    pub coefficients: Vec<f64>,
    /// On an entry of `vech(B_0), vech(B_1), vech(B_2)`, m^2/s^l.
    pub gram: Vec<f64>,
    /// On a coordinate at each instant after one alignment, from `Y_0`, m.
    pub positions: Vec<f64>,
    /// The same with an alignment at each instant, m.
    pub aligned_positions: Vec<f64>,
}

/// The bounds of a scenario, from distances alone and with accelerations, each where there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsBounds([Result<KinematicsBound>; 2]);

impl KinematicsBounds {
    /// Those at the true motion of a yardstick.
    pub fn new(scenario: &KinematicsScenario, setup: &KinematicsSetup, yardstick: &Yardstick) -> Self {
        let (stamps, noise) = (&setup.stamps, &scenario.noise);
        let designs = [
            KinematicsDesign::distances(stamps, noise),
            KinematicsDesign::with_accelerometers(stamps, noise),
        ];
        Self(designs.map(|design| KinematicsBound::new(yardstick.motion(), &design)))
    }

    /// What they are at the instants of the yardstick.
    pub fn reports(&self, yardstick: &Yardstick) -> [KinematicsBoundReport; 2] {
        [0, 1].map(|index| {
            let found = self.0[index].clone().and_then(|bound| report(&bound, yardstick));
            let (found, failure) = match found {
                Ok(found) => (found, None),
                Err(error) => (KinematicsBoundReport::default(), Some(error.to_string())),
            };
            let label = ["CRB, distances", "CRB, distances and accelerations"][index].to_string();
            KinematicsBoundReport { label, accelerations: index == 1, failure, ..found }
        })
    }

    /// The covariance of a quantity of each node after one alignment from `Y_0`, m^2: D x D, node by node.
    ///
    /// # Errors
    /// Why there is no bound; [`crate::Error::Size`] where the motion has no such coefficient.
    pub fn node_covariances(&self, accelerations: bool, quantity: NodeQuantity) -> Result<Vec<DMatrix<f64>>> {
        let bound = self.0[usize::from(accelerations)].as_ref().map_err(Clone::clone)?;
        let covariance = match quantity {
            NodeQuantity::Position(time) => bound.position_covariance(time, Alignment::AtZero)?,
            NodeQuantity::Tip { coefficient, factor } => bound.tip_covariance(coefficient, factor)?,
        };
        let dimension = bound.motion().dimension();
        let of_node = |node: usize| {
            let at = node * dimension;
            covariance.view((at, at), (dimension, dimension)).into_owned()
        };
        Ok((0..bound.motion().nodes()).map(of_node).collect())
    }
}

/// From distances alone, and with accelerations.
pub fn kinematics_bounds(
    scenario: &KinematicsScenario,
    setup: &KinematicsSetup,
    yardstick: &Yardstick,
) -> [KinematicsBoundReport; 2] {
    KinematicsBounds::new(scenario, setup, yardstick).reports(yardstick)
}

fn report(bound: &KinematicsBound, yardstick: &Yardstick) -> Result<KinematicsBoundReport> {
    let motion = bound.motion();
    let [positions, aligned_positions] = bound.position_rmses(&yardstick.instants)?;
    let gram = GRAM_COEFFICIENTS.min(2 * motion.degree() + 1);
    Ok(KinematicsBoundReport {
        coefficients: (0..=motion.degree()).map(|l| bound.coefficient_rmse(l)).collect::<Result<_>>()?,
        gram: (0..gram).map(|l| bound.gram_rmse(l)).collect::<Result<_>>()?,
        positions,
        aligned_positions,
        ..KinematicsBoundReport::default()
    })
}

/// Of what a node's uncertainty is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NodeQuantity {
    /// Its position at a time, s.
    Position(f64),
    /// The tip of an arrow from its position at time 0: `Y_0 + factor Y_l`, the factor in s^l.
    Tip {
        /// l.
        coefficient: usize,
        /// How long the arrow is drawn.
        factor: f64,
    },
}
