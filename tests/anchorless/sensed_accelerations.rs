//! Accelerations from accelerometers alone, \[A\] eq. 24.

use nalgebra::DMatrix;
use rangelab::anchorless::estimate;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::coefficients::centred_columns;
use rangelab::model::kinematics::settings::KinematicsName::Algorithm2So;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::paper;
use crate::support::{at_most, caught};

const TRIALS: u64 = 300;

/// `Y~_2` less its truth in the frame of the accelerometers, trial by trial, as Algorithm 2 finds it.
fn errors(scenario: &KinematicsScenario) -> Vec<DMatrix<f64>> {
    let error = |trial| {
        let drawn = simulate_kinematics(scenario, trial).unwrap();
        let found = estimate(Algorithm2So, &scenario.estimators, &drawn.record).unwrap();
        let sensed = found.rotation.unwrap() * found.kinematics.unwrap().coefficient(2);
        sensed - &drawn.sensor_from_world * drawn.truth.coefficient(2)
    };
    (0..TRIALS).map(error).collect()
}

/// That of the first and last reading: unbiased too, and not optimal.
fn errors_of_two_readings(scenario: &KinematicsScenario) -> Vec<DMatrix<f64>> {
    let error = |trial| {
        let drawn = simulate_kinematics(scenario, trial).unwrap();
        let readings = &drawn.record.accelerometers().unwrap().readings;
        let mean = (&readings[0] + &readings[readings.len() - 1]) / 2.0;
        centred_columns(&mean) - &drawn.sensor_from_world * drawn.truth.coefficient(2)
    };
    (0..TRIALS).map(error).collect()
}

/// Root mean square over the bound on a centred coordinate, `sigma sqrt((1 - 1/N)/K)`.
fn over_bound(scenario: &KinematicsScenario, errors: &[DMatrix<f64>]) -> f64 {
    let (nodes, stamps) = (scenario.nodes() as f64, scenario.stamps.count() as f64);
    let bound = scenario.noise.sigma_acceleration * f64::sqrt((1.0 - 1.0 / nodes) / stamps);
    let square = errors.iter().map(DMatrix::norm_squared).sum::<f64>();
    f64::sqrt(square / (errors.len() * errors[0].len()) as f64) / bound
}

/// The mean of all trials in standard deviations of it, the largest of all coordinates.
fn bias(errors: &[DMatrix<f64>]) -> f64 {
    let count = errors.len() as f64;
    let sum = errors.iter().fold(errors[0].map(|_| 0.0), |sum, error| sum + error);
    let square = errors.iter().map(DMatrix::norm_squared).sum::<f64>() / (count * sum.len() as f64);
    (sum / count).amax() / f64::sqrt(square / count)
}

/// In white noise least squares is the best there is, at any number of stamps.
#[test]
fn the_fit_of_accelerometers_is_optimal_and_unbiased() {
    for stamps in [10, 100] {
        let scenario = paper(stamps);
        let found = errors(&scenario);
        // 5400 free numbers: the ratio is good to 1 %. The largest of twenty means stays below four by far the most times.
        at_most("off the bound", (over_bound(&scenario, &found) - 1.0).abs(), 0.04);
        at_most("bias", bias(&found), 4.0);
        let shifted: Vec<DMatrix<f64>> = found.iter().map(|error| error.add_scalar(3e-4)).collect();
        caught("a biased fit", bias(&shifted), 10.0);
        let two = over_bound(&scenario, &errors_of_two_readings(&scenario));
        caught("two readings", (two - 1.0).abs(), 0.4);
    }
}
