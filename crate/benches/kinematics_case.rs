//! The estimate that is timed: the paper's network, ten nodes and 100 stamps.

use rangelab::anchorless::estimate;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::distance_record::DistanceRecord;
use rangelab::model::kinematics::presets::kinematics_preset;
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::simulate::kinematics::simulate_kinematics;

/// A record and what runs on it.
pub struct KinematicsCase {
    scenario: KinematicsScenario,
    record: DistanceRecord,
}

impl KinematicsCase {
    /// One trial.
    pub fn new() -> Self {
        let scenario = kinematics_preset("kinematics-paper").expect("it comes with the crate");
        let record = simulate_kinematics(&scenario, 0).expect("a preset is valid").record;
        Self { scenario, record }
    }

    /// Runs an estimator; the number keeps the work from being optimized away.
    pub fn run(&self, name: KinematicsName) -> f64 {
        let found = estimate(name, &self.scenario.estimators, &self.record).expect("the record is sound");
        found.kinematics.map_or(0.0, |motion| motion.coefficient(0)[(0, 0)])
    }
}
