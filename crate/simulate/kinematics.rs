//! Distances and accelerations of mobile nodes.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::random::{Part, Stream};
use crate::error::Result;
use crate::math::float::sqrt;
use crate::model::kinematics::coefficients::{RelativeKinematics, squared_distance};
use crate::model::kinematics::distance_record::{Accelerometers, DistanceRecord, pairs};
use crate::model::kinematics::{KinematicsScenario, KinematicsSetup};

/// One trial: what was measured, and what was true.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulatedKinematics {
    /// What estimators see.
    pub record: DistanceRecord,
    /// The motion, centred, in the frame of the scenario.
    pub truth: RelativeKinematics,
    /// `Q`, from that frame to that of the accelerometers: proper, and another one in each trial.
    pub sensor_from_world: DMatrix<f64>,
}

/// Draws one trial of a scenario.
///
/// The same scenario and trial give the same bits everywhere, and trials may be drawn in any order. Random numbers are
/// common: a change of the motion, of the noise or of the estimators changes no draw, only what is made of it.
///
/// # Errors
/// [`crate::Error::Invalid`] with every problem of the scenario, [`crate::Error::Number`] where a distance overflows.
///
/// ```
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// use rangelab::simulate::kinematics::simulate_kinematics;
/// let trial = simulate_kinematics(&kinematics_preset("kinematics-paper")?, 0)?;
/// assert_eq!((trial.record.nodes(), trial.record.stamps().len()), (10, 100));
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn simulate_kinematics(scenario: &KinematicsScenario, trial: u64) -> Result<SimulatedKinematics> {
    draw(scenario, &scenario.setup()?, trial)
}

/// [`simulate_kinematics`] for a scenario whose parts are already there.
///
/// # Errors
/// [`crate::Error::Number`] where a distance overflows.
pub fn draw(
    scenario: &KinematicsScenario,
    setup: &KinematicsSetup,
    trial: u64,
) -> Result<SimulatedKinematics> {
    let (motion, noise) = (&setup.motion, &scenario.noise);
    let stream = |part| Stream::new(scenario.seed, trial, part);
    let sensor_from_world = random_rotation(motion.dimension(), &mut stream(Part::Motion));
    let mut distances = Vec::new();
    let mut readings = Vec::with_capacity(setup.stamps.len());
    for (k, &time) in setup.stamps.iter().enumerate() {
        measure_distances(scenario, &motion.positions(time), &mut stream(Part::Epoch(2 * k)), &mut distances);
        let mut stream = stream(Part::Epoch(2 * k + 1));
        let exact = &sensor_from_world * motion.derivative(2, time);
        readings.push(exact.map(|value| value + noise.sigma_acceleration * stream.normal()));
    }
    let (dimension, nodes) = (motion.dimension(), motion.nodes());
    let record =
        DistanceRecord::new(dimension, nodes, setup.stamps.clone(), distances, noise.sigma_distance)?
            .with_accelerometers(Accelerometers { readings, sigma: noise.sigma_acceleration })?;
    Ok(SimulatedKinematics { record, truth: motion.centred(), sensor_from_world })
}

/// Each pair draws a uniform number, which loses the distance, then the noise, needed or not.
fn measure_distances(
    scenario: &KinematicsScenario,
    positions: &DMatrix<f64>,
    stream: &mut Stream,
    distances: &mut Vec<Option<f64>>,
) {
    let noise = &scenario.noise;
    for (i, j) in pairs(positions.ncols()) {
        let lost = stream.uniform() < noise.missing_probability;
        let error = noise.sigma_distance * stream.normal();
        let exact = sqrt(squared_distance(positions, i, j));
        distances.push((!lost).then_some(exact + error));
    }
}

/// Uniform on SO(D), without a sine: a unit complex number or a unit quaternion from normal numbers.
fn random_rotation(dimension: usize, stream: &mut Stream) -> DMatrix<f64> {
    let count = if dimension == 2 { 2 } else { 4 };
    let mut q = DVector::from_fn(count, |_, _| stream.normal());
    q /= sqrt(q.norm_squared());
    if dimension == 2 {
        return DMatrix::from_row_slice(2, 2, &[q[0], -q[1], q[1], q[0]]);
    }
    let (w, x, y, z) = (q[0], q[1], q[2], q[3]);
    let rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    DMatrix::from_fn(3, 3, |i, j| rows[i][j])
}
