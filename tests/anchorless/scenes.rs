//! Networks to test with.

use nalgebra::DMatrix;
use rangelab::anchorless::estimate;
use rangelab::error::Result;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::coefficients::RelativeKinematics;
use rangelab::model::kinematics::presets::kinematics_preset;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::model::kinematics::stamps::Stamps;
use rangelab::simulate::kinematics::simulate_kinematics;
use rangelab::simulate::random::{Part, Stream};

/// The paper's network at K stamps.
pub fn paper(stamps: usize) -> KinematicsScenario {
    let mut scenario = kinematics_preset("kinematics-paper").unwrap();
    scenario.stamps = Stamps::Regular { first: -5.0, last: 5.0, count: stamps };
    scenario
}

/// Positions within 1 km, velocities within 10 m/s, accelerations within 1 m/s^2 and so on.
pub fn random(dimension: usize, nodes: usize, degree: usize, seed: u64) -> KinematicsScenario {
    let mut stream = Stream::new(seed, 0, Part::Anchors);
    let mut scenario = paper(100);
    let mut size = 1e4;
    scenario.coefficients.clear();
    for l in 0..=degree {
        size *= [0.1, 0.01, 0.1, 0.1, 0.1][l.min(4)];
        let mut point = || (0..dimension).map(|_| size * (2.0 * stream.uniform() - 1.0)).collect();
        scenario.coefficients.push((0..nodes).map(|_| point()).collect());
    }
    scenario.estimators.degree = degree;
    scenario
}

/// Without noise.
pub fn exact(mut scenario: KinematicsScenario) -> KinematicsScenario {
    scenario.noise.sigma_distance = 0.0;
    scenario.noise.sigma_acceleration = 0.0;
    scenario
}

/// The largest error of a coefficient, relative to it; of trial 0, after one alignment.
pub fn relative_error(name: KinematicsName, scenario: &KinematicsScenario) -> Result<f64> {
    let trial = simulate_kinematics(scenario, 0)?;
    let found = estimate(name, &scenario.estimators, &trial.record)?;
    let found = found.kinematics.expect("it finds the motion").aligned_to(&trial.truth)?;
    Ok(largest_error(&found, &trial.truth))
}

/// The largest error of a coefficient, relative to it.
pub fn largest_error(found: &RelativeKinematics, truth: &RelativeKinematics) -> f64 {
    let error = |(found, truth): (&DMatrix<f64>, &DMatrix<f64>)| (found - truth).norm() / truth.norm();
    found.coefficients().iter().zip(truth.coefficients()).map(error).fold(0.0, f64::max)
}
