//! Maximum likelihood ends in no minimum that is too high to be the right one.

use rangelab::anchorless::maximum_likelihood::{Detail, maximum_likelihood, refined};
use rangelab::anchorless::synchronization::snapshot_sync;
use rangelab::error::Result;
use rangelab::model::kinematics::distance_record::DistanceRecord;
use rangelab::model::kinematics::estimate::KinematicsEstimate;
use rangelab::model::kinematics::presets::kinematics_preset;
use rangelab::simulate::kinematics::simulate_kinematics;

const TRIALS: u64 = 30;

/// How many trials of a preset end above the minimum next to the truth, or nowhere.
fn lost(preset: &str, find: impl Fn(&DistanceRecord) -> Result<KinematicsEstimate>) -> usize {
    let scenario = kinematics_preset(preset).unwrap();
    let is_right = |&trial: &u64| {
        let drawn = simulate_kinematics(&scenario, trial).unwrap();
        let record = drawn.record.without_accelerometers();
        let right = refined(&record, &drawn.truth, Detail::Compressed).unwrap().cost;
        // A cost is a sum of squares of normal numbers: one more or less tells no motions apart.
        find(&record).is_ok_and(|found| found.cost < right + 1.0)
    };
    (0..TRIALS).filter(|trial| !is_right(trial)).count()
}

/// Synchronization, then the minimum next to it, whatever its cost.
fn from_one_start(record: &DistanceRecord) -> Result<KinematicsEstimate> {
    let start = snapshot_sync(record, 2)?.kinematics.expect("it finds the motion");
    refined(record, &start, Detail::Compressed)
}

#[test]
fn constant_velocities_and_four_nodes_end_where_the_truth_does() {
    for preset in ["kinematics-paper", "kinematics-constant", "kinematics-four"] {
        let ends = lost(preset, |record| maximum_likelihood(record, 2, Detail::Compressed));
        assert_eq!(ends, 0, "{preset}");
    }
}

#[test]
fn one_start_alone_does_not() {
    assert_eq!(lost("kinematics-paper", from_one_start), 0);
    let ends = lost("kinematics-constant", from_one_start);
    assert!(ends > 5, "{ends} of {TRIALS}");
}
