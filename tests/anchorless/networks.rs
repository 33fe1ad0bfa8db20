//! Networks, records and errors that the tests share.

use nalgebra::DMatrix;
use rangelab::model::kinematics::KinematicsScenario;
use rangelab::model::kinematics::coefficients::RelativeKinematics;
use rangelab::model::kinematics::presets::kinematics_preset;
use rangelab::model::kinematics::stamps::Stamps;

use crate::support::sampling::Sampler;

/// The paper's network, measured K times over [-5, 5] s.
pub fn paper(k: usize) -> KinematicsScenario {
    let mut scenario = kinematics_preset("kinematics-paper").unwrap();
    scenario.stamps = Stamps::Regular { first: -5.0, last: 5.0, count: k };
    scenario
}

/// A network of nodes within a kilometre, with coefficients of the size of the paper's.
pub fn random(seed: u64, dimension: usize, nodes: usize, degree: usize) -> KinematicsScenario {
    let mut sampler = Sampler::new(seed);
    let scales = [1000.0, 10.0, 1.0, 0.1, 0.01];
    let mut scenario = paper(100);
    scenario.coefficients = (0..=degree)
        .map(|l| {
            let mut vector = || (0..dimension).map(|_| sampler.uniform(-scales[l], scales[l])).collect();
            (0..nodes).map(|_| vector()).collect()
        })
        .collect();
    scenario.estimators.degree = degree;
    scenario.seed = seed;
    scenario
}

/// Without noise.
pub fn exact(mut scenario: KinematicsScenario) -> KinematicsScenario {
    scenario.noise.sigma_distance = 0.0;
    scenario.noise.sigma_acceleration = 0.0;
    scenario
}

/// The motion as matrices, centred.
pub fn motion(scenario: &KinematicsScenario) -> RelativeKinematics {
    scenario.setup().unwrap().motion.centred()
}

/// The largest error of a coefficient after one alignment, in parts of that coefficient.
pub fn relative_error(found: &RelativeKinematics, truth: &RelativeKinematics) -> f64 {
    let found = found.aligned_to(truth).unwrap();
    let part = |(a, b): (&DMatrix<f64>, &DMatrix<f64>)| (a - b).norm() / b.norm();
    found.coefficients().iter().zip(truth.coefficients()).map(part).fold(0.0, f64::max)
}

/// Squared errors of each coefficient per coordinate, after one alignment.
pub fn squared_errors(found: &RelativeKinematics, truth: &RelativeKinematics) -> Vec<f64> {
    let found = found.aligned_to(truth).unwrap();
    let square = |(a, b): (&DMatrix<f64>, &DMatrix<f64>)| (a - b).norm_squared() / a.len() as f64;
    found.coefficients().iter().zip(truth.coefficients()).map(square).collect()
}

/// A root mean square and its standard error.
#[derive(Clone, Copy, Debug)]
pub struct Rmse {
    pub value: f64,
    pub standard_error: f64,
}

impl Rmse {
    pub fn of(squares: &[f64]) -> Self {
        let n = squares.len() as f64;
        let mean = squares.iter().sum::<f64>() / n;
        let variance =
            squares.iter().map(|square| (square - mean) * (square - mean)).sum::<f64>() / (n - 1.0);
        Self { value: mean.sqrt(), standard_error: 0.5 * (variance / n).sqrt() / mean.sqrt() }
    }

    pub fn over(self, unit: f64) -> Self {
        Self { value: self.value / unit, standard_error: self.standard_error / unit }
    }
}
