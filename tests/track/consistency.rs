//! NIS and NEES follow their chi-square laws where truth and noise are drawn from the filter's own model.

use nalgebra::DVector;
use rangelab::math::rotation::rotation_angles;
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranging::Weighting;
use rangelab::track::filter::Consistency;

use crate::scenario::{Options, Track, Truth, pose};
use crate::support::sampling::Sampler;

crate::in_plane_and_space!(
    the_linear_filter_is_calibrated,
    manifold_filters_are_calibrated,
    rotation_covariances_are_calibrated,
    a_wrong_noise_is_seen,
);

const RUNS: usize = 400;

/// A sum of chi-square draws of independent runs.
#[derive(Clone, Copy, Default)]
struct Sum {
    value: f64,
    degrees: f64,
}

impl Sum {
    fn add(&mut self, one: Consistency) {
        self.value += one.value;
        self.degrees += one.degrees_of_freedom as f64;
    }

    /// Distance of the mean from its law, in standard errors: a chi-square of n degrees has variance 2n.
    fn deviation(&self) -> f64 {
        (self.value - self.degrees) / (2.0 * self.degrees).sqrt()
    }
}

/// NIS over all, and NEES at the first and last step (one draw a run each, so that draws are independent).
fn sums<const D: usize>(seed: u64, options: &Options, name: EstimatorName) -> [Sum; 3] {
    let mut sampler = Sampler::new(seed);
    let mut sums = [Sum::default(); 3];
    for _ in 0..RUNS {
        let track = Track::<D>::random(&mut sampler, options);
        let mut filter = track.estimator(name, &EstimatorSettings::default());
        for (k, (epoch, truth)) in track.recording.epochs.iter().zip(&track.truth).enumerate() {
            let step = filter.step(epoch).unwrap();
            sums[0].add(step.nis);
            if k == 0 || k + 1 == track.truth.len() {
                let nees = match options.truth {
                    Truth::Rigid => step.nees(&pose(truth)).unwrap(),
                    Truth::Linear => linear_nees(&step, truth),
                };
                sums[1 + usize::from(k > 0)].add(nees);
            }
        }
    }
    sums
}

/// NEES where the true `Q` is no rotation.
fn linear_nees<const D: usize>(
    step: &rangelab::track::filter::Step<D>,
    truth: &rangelab::math::pose::Theta<D>,
) -> Consistency {
    let error = step.posterior.minus(truth);
    let precision = crate::gain_form::covariance(step).to_blocks().inverse().unwrap();
    Consistency { value: error.dot(&precision.times(&error)), degrees_of_freedom: D * (D + 1) }
}

#[track_caller]
fn check<const D: usize>(seed: u64, options: &Options, name: EstimatorName, limit: f64) {
    for (what, sum) in ["NIS", "first NEES", "last NEES"].iter().zip(sums::<D>(seed, options, name)) {
        let (deviation, ratio) = (sum.deviation(), sum.value / sum.degrees);
        println!("D = {D} {name} {what}: {ratio:.4} of its mean, {deviation:+.2} standard errors");
        assert!(deviation.abs() < limit, "{name} {what}: {ratio} of its mean, {deviation} standard errors");
    }
}

fn the_linear_filter_is_calibrated<const D: usize>() {
    let plain = Options { truth: Truth::Linear, steps: 6, ..Options::default() };
    for (seed, options) in [
        (800, plain),
        (801, Options { centred: false, ..plain }),
        (802, Options { weighting: Weighting::PerPair, missing: 0.3, ..plain }),
        (803, Options { noise: RangeNoise::Toa { zeta_db: 30.0 }, ..plain }),
        (804, Options { noise: RangeNoise::SquaredRange { sigma: 0.2 }, anchors: D, ..plain }),
    ] {
        check::<D>(seed, &options, EstimatorName::Kf, 4.0);
    }
}

/// Small noise, so that the manifold is flat over its reach.
fn manifold_filters_are_calibrated<const D: usize>() {
    let options = Options { noise: RangeNoise::Range { sigma: 0.01 }, steps: 6, ..Options::default() };
    for name in [EstimatorName::Eskf, EstimatorName::EskfRaw] {
        check::<D>(810, &Options { variance: 1e-12, ..options }, name, 4.0);
    }
}

/// The rotation from the estimate to the truth, seen in the world frame, against its covariance.
fn rotation_sum<const D: usize>(seed: u64, options: &Options, name: EstimatorName) -> Sum {
    let (mut sampler, mut sum) = (Sampler::new(seed), Sum::default());
    for _ in 0..RUNS {
        let track = Track::<D>::random(&mut sampler, options);
        let mut filter = track.estimator(name, &EstimatorSettings::default());
        let step = track.recording.epochs.iter().map(|epoch| filter.step(epoch).unwrap()).last().unwrap();
        let truth = pose(track.truth.last().unwrap()).rotation;
        let angles = rotation_angles(D);
        let error = DVector::from_column_slice(&truth.compose(&step.rotation().inverse()).log()[..angles]);
        let covariance = step.rotation_covariance().unwrap();
        let precision = covariance.view((0, 0), (angles, angles)).into_owned().cholesky().unwrap().inverse();
        sum.add(Consistency { value: error.dot(&(&precision * &error)), degrees_of_freedom: angles });
    }
    sum
}

fn rotation_covariances_are_calibrated<const D: usize>() {
    let options = Options { noise: RangeNoise::Range { sigma: 0.01 }, steps: 6, ..Options::default() };
    for (name, variance) in
        [(EstimatorName::Kf, 1.0), (EstimatorName::Eskf, 1e-12), (EstimatorName::EskfRaw, 1e-12)]
    {
        let sum = rotation_sum::<D>(830, &Options { variance, ..options }, name);
        println!("D = {D} {name}: {:+.2} standard errors", sum.deviation());
        assert!(sum.deviation().abs() < 4.0, "{name}: {} standard errors", sum.deviation());
        let louder = Options { variance, drawn: 1.2, ..options };
        assert!(
            rotation_sum::<D>(830, &louder, name).deviation() > 4.0,
            "{name}: 20 % more noise is not seen"
        );
    }
}

/// Noise 10 % larger than the filter thinks.
fn a_wrong_noise_is_seen<const D: usize>() {
    let options = Options { truth: Truth::Linear, steps: 6, drawn: 1.1, ..Options::default() };
    let [nis, _, nees] = sums::<D>(820, &options, EstimatorName::Kf);
    assert!(nis.deviation() > 8.0 && nees.deviation() > 4.0, "{} {}", nis.deviation(), nees.deviation());
}
