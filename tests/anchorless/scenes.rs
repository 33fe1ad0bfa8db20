//! What the closed forms find in a network.

use rangelab::anchorless::estimate;
use rangelab::error::Result;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::relative_error;

/// The largest error of a coefficient of trial 0, in parts of that coefficient.
pub fn error_of(name: KinematicsName, scenario: &KinematicsScenario) -> Result<f64> {
    let trial = simulate_kinematics(scenario, 0)?;
    let found = estimate(name, &scenario.estimators, &trial.record)?;
    Ok(relative_error(&found.kinematics.expect("it finds the motion"), &trial.truth))
}
