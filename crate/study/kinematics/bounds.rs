//! What no unbiased estimator of a kinematics scenario can beat, beside the errors that studies measure.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use super::errors::Yardstick;
use crate::bounds::kinematics::{Alignment, KinematicsBound, KinematicsDesign};
use crate::error::Result;
use crate::model::kinematics::KinematicsScenario;
use crate::model::kinematics::coefficients::RelativeKinematics;

/// The Cramér-Rao bounds of a scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsBounds {
    /// From distances alone.
    pub distances: KinematicsBoundCurves,
    /// From distances and accelerometers.
    pub accelerometers: KinematicsBoundCurves,
}

/// The bounds on the root mean square errors of a study, each list as in its summary; all are empty where there is no bound.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsBoundCurves {
    /// Why there is none, in a sentence.
    pub failure: Option<String>,
    /// Of a coordinate of `Y_0, Y_1, ...` after one alignment at time 0, m/s^l.
    pub coefficients: Vec<f64>,
    /// Of a coordinate of the positions at each instant with that alignment, m.
    pub positions: Vec<f64>,
    /// The same with an alignment at each instant, m.
    pub aligned_positions: Vec<f64>,
}

/// The bounds of a scenario, of its positions at some instants (s). The degree is that of the motion, or the one that
/// estimators assume where that is higher.
///
/// # Errors
/// When the scenario is not valid.
///
/// ```
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::study::kinematics::bounds::kinematics_bounds;
/// let bounds = kinematics_bounds(&kinematics_preset("kinematics-paper")?, &[0.0])?;
/// let gain = bounds.distances.coefficients[1] / bounds.accelerometers.coefficients[1];
/// assert!((gain - 7.2).abs() < 0.1); // what accelerometers buy for velocities
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn kinematics_bounds(scenario: &KinematicsScenario, instants: &[f64]) -> Result<KinematicsBounds> {
    let setup = scenario.setup()?;
    let yardstick = Yardstick::new(scenario, &setup);
    let curves = |accelerometers| {
        let design = design(scenario, &setup.stamps, accelerometers);
        curves(yardstick.motion(), &design, instants).unwrap_or_else(|error| KinematicsBoundCurves {
            failure: Some(error.to_string()),
            ..KinematicsBoundCurves::default()
        })
    };
    Ok(KinematicsBounds { distances: curves(false), accelerometers: curves(true) })
}

/// The bound on the covariance of the position of each node at a time (s), after one alignment at time 0, m^2: D x D, node by
/// node.
///
/// # Errors
/// When the scenario is not valid or has no bound.
pub fn node_covariances(
    scenario: &KinematicsScenario,
    accelerometers: bool,
    time: f64,
) -> Result<Vec<DMatrix<f64>>> {
    let setup = scenario.setup()?;
    let motion = Yardstick::new(scenario, &setup).motion().clone();
    let bound = KinematicsBound::new(&motion, &design(scenario, &setup.stamps, accelerometers))?;
    let covariance = bound.position_covariance(time, Alignment::AtZero)?;
    let dimension = motion.dimension();
    let of_node = |node: usize| {
        let at = node * dimension;
        covariance.view((at, at), (dimension, dimension)).into_owned()
    };
    Ok((0..motion.nodes()).map(of_node).collect())
}

fn design(scenario: &KinematicsScenario, stamps: &[f64], accelerometers: bool) -> KinematicsDesign {
    if accelerometers {
        KinematicsDesign::with_accelerometers(stamps, &scenario.noise)
    } else {
        KinematicsDesign::distances(stamps, &scenario.noise)
    }
}

fn curves(
    motion: &RelativeKinematics,
    design: &KinematicsDesign,
    instants: &[f64],
) -> Result<KinematicsBoundCurves> {
    let bound = KinematicsBound::new(motion, design)?;
    let positions = |alignment| -> Result<Vec<f64>> {
        instants.iter().map(|&time| bound.position_rmse(time, alignment)).collect()
    };
    Ok(KinematicsBoundCurves {
        failure: None,
        coefficients: (0..=motion.degree()).map(|l| bound.coefficient_rmse(l)).collect::<Result<_>>()?,
        positions: positions(Alignment::AtZero)?,
        aligned_positions: positions(Alignment::AtEach)?,
    })
}
