//! What is returned is the least of the cost, written here a second time.

use nalgebra::DMatrix;
use rangelab::anchorless::estimate;
use rangelab::anchorless::maximum_likelihood::{
    Detail, maximum_likelihood, maximum_likelihood_with_accelerometers,
};
use rangelab::anchorless::synchronization::snapshot_sync;
use rangelab::bounds::kinematics::{KinematicsBound, KinematicsDesign};
use rangelab::model::kinematics::coefficients::{RelativeKinematics, centred_columns};
use rangelab::model::kinematics::distance_record::{DistanceRecord, pairs};
use rangelab::model::kinematics::settings::KinematicsName;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::{Rmse, motion, paper, random, squared_errors};
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};

/// `sum (residual/sigma)^2` of every distance, and of every acceleration where there are any.
fn cost(record: &DistanceRecord, motion: &RelativeKinematics) -> f64 {
    let mut sum = 0.0;
    for (k, &time) in record.stamps().iter().enumerate() {
        let x = motion.positions(time);
        for ((a, b), distance) in pairs(record.nodes()).zip(record.distances(k)) {
            let residual = (x.column(a) - x.column(b)).norm() - distance.unwrap();
            sum += residual * residual / (record.sigma() * record.sigma());
        }
        if let Some(accelerometers) = record.accelerometers() {
            let difference = centred_columns(&accelerometers.readings[k]) - motion.derivative(2, time);
            sum += difference.norm_squared() / (accelerometers.sigma * accelerometers.sigma);
        }
    }
    sum
}

/// Slope over curvature along some random changes of all coefficients, as a part of the standard deviation along them: 0 at
/// a minimum.
fn slope(record: &DistanceRecord, at: &RelativeKinematics) -> f64 {
    let mut sampler = Sampler::new(5);
    let mut largest = 0.0_f64;
    for _ in 0..5 {
        // Metres, and as much less in m/s and m/s^2 as moves nodes by metres at the ends.
        let sizes = [1.0, 0.2, 0.04];
        let change: Vec<DMatrix<f64>> = sizes
            .iter()
            .map(|size| DMatrix::from_fn(at.dimension(), at.nodes(), |_, _| size * sampler.normal()))
            .map(|change| centred_columns(&change))
            .collect();
        let moved = |h: f64| {
            let parts = at.coefficients().iter().zip(&change).map(|(y, change)| y + change * h).collect();
            cost(record, &RelativeKinematics::new(parts).unwrap())
        };
        let h = 1e-3;
        let (up, down, here) = (moved(h), moved(-h), moved(0.0));
        let (first, second) = ((up - down) / (2.0 * h), (up + down - 2.0 * here) / (h * h));
        assert!(second > 0.0, "a minimum bends upwards");
        largest = largest.max((first / second).abs() * (0.5 * second).sqrt());
    }
    largest
}

#[test]
fn every_distance_is_a_minimum() {
    for (dimension, nodes) in [(2, 8), (3, 10)] {
        let trial = simulate_kinematics(&random(6, dimension, nodes, 2), 0).unwrap();
        let record = trial.record.without_accelerometers();
        let found = maximum_likelihood(&record, 2, Detail::Every).unwrap();
        let least = found.kinematics.unwrap();
        let own = cost(&record, &least);
        at_most("its cost", (found.cost - own).abs() / own, 1e-9);
        at_most("its slope", slope(&record, &least), 1e-3);
        let near = snapshot_sync(&record, 2).unwrap().kinematics.unwrap();
        caught("the slope at the start", slope(&record, &near), 1e-2);
    }
}

#[test]
fn every_distance_and_acceleration_is_a_minimum() {
    for (dimension, nodes) in [(2, 8), (3, 10)] {
        let trial = simulate_kinematics(&random(7, dimension, nodes, 2), 0).unwrap();
        let found = maximum_likelihood_with_accelerometers(&trial.record, 2, Detail::Every).unwrap();
        at_most("its slope", slope(&trial.record, found.kinematics.as_ref().unwrap()), 1e-3);
        let distances = maximum_likelihood(&trial.record, 2, Detail::Every).unwrap();
        caught("without accelerations", slope(&trial.record, &distances.kinematics.unwrap()), 1e-2);
    }
}

#[test]
fn the_frame_is_that_of_the_accelerometers() {
    let trial = simulate_kinematics(&paper(100), 3).unwrap();
    let found = maximum_likelihood_with_accelerometers(&trial.record, 2, Detail::Compressed).unwrap();
    let expected = trial.truth.rotated(&trial.sensor_from_world);
    let error = (found.kinematics.unwrap().coefficient(2) - expected.coefficient(2)).amax();
    at_most("accelerations without any alignment", error, 2e-3);
}

#[test]
fn compressed_pairs_lose_nothing() {
    let scenario = paper(100);
    let bound = KinematicsBound::new(
        &motion(&scenario),
        &KinematicsDesign::distances(&scenario.setup().unwrap().stamps, &scenario.noise),
    )
    .unwrap();
    for trial in 0..5 {
        let record = simulate_kinematics(&scenario, trial).unwrap().record;
        let found = |detail| maximum_likelihood(&record, 2, detail).unwrap().kinematics.unwrap();
        let every = found(Detail::Every);
        let difference = squared_errors(&found(Detail::Compressed), &every);
        for l in 0..3 {
            // A hundredth of the standard deviation changes an RMSE in its fourth digit at most.
            at_most("compressed from full", difference[l].sqrt(), 0.01 * bound.coefficient_rmse(l).unwrap());
        }
    }
}

/// RMSE over its bound, with distances alone and with accelerometers.
pub fn ratios(
    scenario: &rangelab::model::kinematics::KinematicsScenario,
    name: KinematicsName,
    trials: u64,
) -> Vec<Rmse> {
    let setup = scenario.setup().unwrap();
    let design = if name.reads_accelerations() {
        KinematicsDesign::with_accelerometers(&setup.stamps, &scenario.noise)
    } else {
        KinematicsDesign::distances(&setup.stamps, &scenario.noise)
    };
    let bound = KinematicsBound::new(&setup.motion, &design).unwrap();
    let mut squares = vec![Vec::new(); scenario.coefficients.len()];
    for trial in 0..trials {
        let drawn = simulate_kinematics(scenario, trial).unwrap();
        let found = estimate(name, &scenario.estimators, &drawn.record).unwrap();
        for (l, square) in squared_errors(&found.kinematics.unwrap(), &drawn.truth).into_iter().enumerate() {
            squares[l].push(square);
        }
    }
    let ratio = |(l, squares): (usize, &Vec<f64>)| Rmse::of(squares).over(bound.coefficient_rmse(l).unwrap());
    squares.iter().enumerate().map(ratio).collect()
}

#[test]
fn it_attains_the_bound() {
    for (name, limit) in
        [(KinematicsName::MaximumLikelihood, 4.5), (KinematicsName::MaximumLikelihoodAccelerometers, 4.5)]
    {
        for ratio in ratios(&paper(20), name, 60) {
            at_most(name.name(), (ratio.value - 1.0).abs(), limit * ratio.standard_error);
        }
    }
    for ratio in ratios(&paper(20), KinematicsName::SnapshotSync, 60) {
        caught("snapshots", ratio.value - 1.0, 4.5 * ratio.standard_error);
    }
}
