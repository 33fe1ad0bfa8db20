//! The scenes that the bounds are tried on: the papers' set-ups and random ones.

use nalgebra::{SVector, Vector3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rangelab::bounds::{FisherInformation, fisher_information};
use rangelab::math::float::radians;
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::Rotation;
use rangelab::model::anchors::Anchors;
use rangelab::model::epoch::{Epoch, Initial, Recording};
use rangelab::model::motion::{Motion, ProcessNoise};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranging::{RangeForm, RangeModel, Weighting};
use rangelab::model::topology::Topology;

pub const FORMS: [RangeForm; 2] = [RangeForm::Projected, RangeForm::Raw];

/// A fixed draw of four anchors in a cube of 1 km (\[L\]) and one of 2 km (\[T\]).
pub const LOCALIZATION_ANCHORS: [[f64; 3]; 4] =
    [[364.7, -285.7, -119.4], [-225.2, 312.0, -466.1], [380.9, 59.64, 81.83], [-440.7, 337.0, 147.8]];
pub const TRACKING_ANCHORS: [[f64; 3]; 4] =
    [[-753.8, 161.8, 701.8], [-680.5, -511.0, 387.2], [-169.7, -647.0, -208.3], [703.6, 218.6, 968.2]];

pub struct Scene<const D: usize> {
    pub model: RangeModel<D>,
    pub pose: Pose<D>,
}

impl<const D: usize> Scene<D> {
    pub fn information(&self, form: RangeForm) -> FisherInformation<'_, D> {
        fisher_information(&self.model, &self.pose, form, &mut self.model.range_buffer()).unwrap()
    }
}

pub fn model<const D: usize>(
    anchors: &[[f64; D]],
    sensors: &[[f64; D]],
    noise: RangeNoise,
    weighting: Weighting,
) -> RangeModel<D> {
    let points = |list: &[[f64; D]]| list.iter().map(|&p| SVector::from(p)).collect();
    let anchors = Anchors::new(points(anchors)).unwrap();
    RangeModel::new(anchors, Topology::new(points(sensors)).unwrap(), noise, weighting).unwrap()
}

/// Anchors in a room of 10 m, a body of about 1 m with its frame anywhere, any orientation, each kind of noise.
pub fn random<const D: usize>(trial: usize, weighting: Weighting) -> Scene<D> {
    let mut random = Pcg64Mcg::seed_from_u64(trial as u64);

    let anchors = points(&mut random, D + 1 + trial % 4, 5.0);
    let sensors = points(&mut random, D + 1 + trial % 3, 0.5);
    let noise = match trial % 3 {
        0 => RangeNoise::Range { sigma: 0.05 },
        1 => RangeNoise::SquaredRange { sigma: 0.1 },
        _ => RangeNoise::Toa { zeta_db: 40.0 },
    };
    let phi = points::<3>(&mut random, 1, 2.0)[0];
    let pose = Pose { rotation: Rotation::exp(&phi), position: points(&mut random, 1, 3.0)[0].into() };
    Scene { model: model(&anchors, &sensors, noise, weighting), pose }
}

/// Uniform points in a cube about the origin.
pub fn points<const D: usize>(random: &mut Pcg64Mcg, count: usize, half_side: f64) -> Vec<[f64; D]> {
    (0..count).map(|_| std::array::from_fn(|_| random.random_range(-half_side..half_side))).collect()
}

fn centred<const N: usize>(sensors: [[f64; 3]; N]) -> [[f64; 3]; N] {
    let mean: [f64; 3] = std::array::from_fn(|i| sensors.iter().map(|c| c[i]).sum::<f64>() / N as f64);
    sensors.map(|c| std::array::from_fn(|i| c[i] - mean[i]))
}

/// \[L\] Sec. VII: ten sensors along the edges of a pyramid of 5 m.
pub fn localization(anchors: &[[f64; 3]], weighting: Weighting) -> Scene<3> {
    let h = 2.5;
    let sensors = centred([
        [h, h, 0.0],
        [-h, h, 0.0],
        [-h, -h, 0.0],
        [h, -h, 0.0],
        [0.0, 0.0, 5.0],
        [h / 2.0, h / 2.0, h],
        [-h / 2.0, h / 2.0, h],
        [-h / 2.0, -h / 2.0, h],
        [h / 2.0, -h / 2.0, h],
        [h, 0.0, 0.0],
    ]);
    let turn = |axis: usize, angle: f64| {
        let mut phi = [0.0; 3];
        phi[axis] = radians(angle);
        Rotation::exp(&phi)
    };
    let rotation = turn(2, 10.0).compose(&turn(1, -25.0)).compose(&turn(0, 20.0));
    let pose = Pose { rotation, position: Vector3::new(100.0, 100.0, 55.0) };
    Scene { model: model(anchors, &sensors, RangeNoise::Toa { zeta_db: 60.0 }, weighting), pose }
}

/// \[T\] Sec. V: five sensors on the vertices of a pyramid of 1 m.
pub fn tracking_model(anchors: &[[f64; 3]], weighting: Weighting) -> RangeModel<3> {
    let h = 0.5;
    let sensors = centred([[h, h, 0.0], [-h, h, 0.0], [-h, -h, 0.0], [h, -h, 0.0], [0.0, 0.0, 1.0]]);
    model(anchors, &sensors, RangeNoise::SquaredRange { sigma: 0.0316 }, weighting)
}

/// 20 steps of 1 s along a given noise-free motion from the identity; the ranges are exact.
pub fn recording<const D: usize>(model: RangeModel<D>, angular_velocity: f64) -> Recording<D> {
    let motion = Motion {
        interval: 1.0,
        velocity: SVector::from_element(1.0),
        angular_velocity: [angular_velocity; 3],
    };
    let mut pose = Pose::identity();
    let (mut epochs, mut truth) = (Vec::new(), Vec::new());
    for _ in 0..20 {
        pose = motion.predict_pose(&pose, &motion.rotation());
        let ranges = model.exact_ranges(&Theta::from(pose)).unwrap();
        epochs.push(Epoch { motion, true_ranges: Some(ranges.clone()), ranges });
        truth.push(Some(pose));
    }
    let initial = Initial { theta: Theta::from(Pose::identity()), variance: 100.0 };
    Recording { model, initial, process: ProcessNoise { sigma_q: radians(0.1), sigma_t: 1.0 }, epochs, truth }
}

/// The tracking paper's recording with the mean motion of 1 deg/s about each axis.
pub fn tracking(weighting: Weighting) -> Recording<3> {
    recording(tracking_model(&TRACKING_ANCHORS, weighting), radians(1.0))
}
