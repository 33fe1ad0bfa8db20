//! Random tracks, drawn from the model that the filters assume.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};
use rangelab::math::float::sqrt;
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::rotation_angles;
use rangelab::math::tangent::{TangentVector, split};
use rangelab::model::epoch::Recording;
use rangelab::model::epoch::{Epoch, Initial};
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::motion::{Motion, ProcessNoise};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::track::estimator;
use rangelab::track::filter::Estimator;

use crate::support::gain_form::variance;
use crate::support::sampling::Sampler;

/// What the truth is.
#[derive(Clone, Copy, PartialEq)]
pub enum Truth {
    /// A rigid body: rotation noise on SO(D), perturbed on the right.
    Rigid,
    /// \[T\] eq. 12 taken at its word: noise on every entry of `Q`, the start drawn from the prior.
    Linear,
}

#[derive(Clone, Copy)]
pub struct Options {
    pub anchors: usize,
    pub sensors: usize,
    /// Half the edge of the cube of anchors, m.
    pub half: f64,
    pub centred: bool,
    pub weighting: Weighting,
    pub noise: RangeNoise,
    /// Scale of the noise that is really drawn; 0 gives exact ranges.
    pub drawn: f64,
    /// Probability that a range is missing.
    pub missing: f64,
    pub variance: f64,
    pub truth: Truth,
    pub steps: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            anchors: 6,
            sensors: 5,
            half: 10.0,
            centred: true,
            weighting: Weighting::Common,
            noise: RangeNoise::Range { sigma: 0.05 },
            drawn: 1.0,
            missing: 0.0,
            variance: 1.0,
            truth: Truth::Rigid,
            steps: 20,
        }
    }
}

pub struct Track<const D: usize> {
    pub recording: Recording<D>,
    pub truth: Vec<Theta<D>>,
}

impl<const D: usize> Track<D> {
    pub fn random(sampler: &mut Sampler, options: &Options) -> Self {
        let topology = sampler.topology(options.sensors, options.centred);
        let anchors = sampler.anchors(options.anchors, options.half);
        let model = RangeModel::new(anchors, topology, options.noise, options.weighting).unwrap();
        let process = ProcessNoise { sigma_q: 0.02, sigma_t: 0.05 };
        let initial = Initial { theta: Theta::from(Pose::identity()), variance: options.variance };
        let mut state = match options.truth {
            Truth::Rigid => initial.theta,
            Truth::Linear => {
                disturbed(sampler, &initial.theta, sqrt(options.variance), sqrt(options.variance))
            }
        };
        let (mut epochs, mut truth) = (Vec::new(), Vec::new());
        for _ in 0..options.steps {
            let motion = Motion {
                interval: 0.5,
                velocity: sampler.vector::<D>(0.3),
                angular_velocity: sampler.axis::<D>().map(|x| 0.1 * x),
            };
            state = motion.predict_theta(&state, &motion.rotation());
            state = match options.truth {
                Truth::Rigid => turned(sampler, &state, &process),
                Truth::Linear => disturbed(sampler, &state, process.sigma_q, process.sigma_t),
            };
            epochs.push(measure(sampler, &model, &state, motion, options));
            truth.push(state);
        }
        Self { recording: Recording { model, initial, process, epochs, truth: Vec::new() }, truth }
    }

    pub fn estimator(
        &self,
        name: EstimatorName,
        settings: &EstimatorSettings,
    ) -> Box<dyn Estimator<D> + Send> {
        estimator(name, settings, &self.recording)
    }
}

fn disturbed<const D: usize>(sampler: &mut Sampler, theta: &Theta<D>, q: f64, t: f64) -> Theta<D> {
    Theta {
        orientation: theta.orientation + sampler.matrix::<D>(q),
        position: theta.position + sampler.vector::<D>(t),
    }
}

fn turned<const D: usize>(sampler: &mut Sampler, theta: &Theta<D>, process: &ProcessNoise) -> Theta<D> {
    let angles = rotation_angles(D);
    let step = TangentVector::from_fn(|i, _| {
        sampler.normal() * if i < angles { process.sigma_q } else { process.sigma_t }
    });
    let (phi, shift) = split::<D>(&step);
    Theta::from(pose(theta).retract(&phi, &shift))
}

/// The pose behind a rigid `[Q | t]`.
pub fn pose<const D: usize>(theta: &Theta<D>) -> Pose<D> {
    let rotation = rangelab::math::rotation::Rotation::from_matrix(&theta.orientation).unwrap();
    Pose { rotation, position: theta.position }
}

/// Squared ranges with exactly the variance that the weights say: weights come from the true ranges.
fn measure<const D: usize>(
    sampler: &mut Sampler,
    model: &RangeModel<D>,
    state: &Theta<D>,
    motion: Motion<D>,
    options: &Options,
) -> Epoch<D> {
    let exact = model.exact_ranges(state).unwrap();
    let ranges = Ranges::from_fn(exact.anchors(), exact.sensors(), |m, n| {
        let deviation = sqrt(variance(model.noise(), options.weighting, &exact, m, n));
        let noise = options.drawn * deviation * sampler.normal();
        (sampler.uniform(0.0, 1.0) >= options.missing).then(|| exact.get(m, n).unwrap() + noise)
    });
    Epoch { motion, ranges: ranges.unwrap(), true_ranges: Some(exact) }
}

/// `F`, `u` and `M` of \[T\] eq. 17 as they stand, for `theta` as one long vector.
pub fn transition<const D: usize>(
    motion: &Motion<D>,
    process: &ProcessNoise,
) -> (DMatrix<f64>, DVector<f64>, DMatrix<f64>) {
    let size = D * (D + 1);
    let turn: SMatrix<f64, D, D> = *motion.rotation().matrix();
    let mut f = DMatrix::identity(size, size);
    for j in 0..D {
        f.fixed_view_mut::<D, D>(j * D, j * D).copy_from(&turn);
    }
    let shift: SVector<f64, D> = motion.velocity * motion.interval;
    let u = DVector::from_fn(size, |k, _| if k < D * D { 0.0 } else { shift[k - D * D] });
    let noise = DMatrix::from_fn(size, size, |i, j| match (i == j, i < D * D) {
        (false, _) => 0.0,
        (true, true) => process.sigma_q * process.sigma_q,
        (true, false) => process.sigma_t * process.sigma_t,
    });
    (f, u, noise)
}
