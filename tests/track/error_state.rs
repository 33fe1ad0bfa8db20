//! The error-state filter: its posterior is a stationary point of the cost on the manifold, its covariance the inverse of
//! the Gauss-Newton Hessian; both by finite differences.

use nalgebra::{DMatrix, DVector};
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::defect;
use rangelab::math::tangent::{TangentVector, join, split, tangent_dimension};
use rangelab::model::epoch::Epoch;
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::track::filter::{Step, Uncertainty};

use crate::scenario::{Options, Track, pose};
use crate::support::gain_form::{measurements, variance};
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense};

crate::in_plane_and_space!(
    the_posterior_is_stationary_and_the_covariance_is_its_curvature,
    the_raw_form_knows_more
);

/// White residuals of the update as functions of the pose: prior first, then the ranges.
struct Residuals<'a, const D: usize> {
    prior: Pose<D>,
    root: DMatrix<f64>,
    model: &'a RangeModel<D>,
    epoch: &'a Epoch<D>,
    raw: bool,
}

impl<const D: usize> Residuals<'_, D> {
    fn at(&self, pose: &Pose<D>) -> DVector<f64> {
        let (phi, shift) = self.prior.local(pose);
        let deviation = join(&phi, &shift);
        let prior = &self.root * DVector::from_fn(tangent_dimension(D), |i, _| deviation[i]);
        let theta = Theta::from(*pose);
        let ranges: Vec<f64> = if self.raw { self.raw_ranges(&theta) } else { self.projected(&theta) };
        DVector::from_iterator(prior.len() + ranges.len(), prior.iter().copied().chain(ranges))
    }

    fn raw_ranges(&self, theta: &Theta<D>) -> Vec<f64> {
        let (epoch, expected) = (self.epoch, self.model.exact_ranges(theta).unwrap());
        let pairs = (0..expected.sensors()).flat_map(|n| (0..expected.anchors()).map(move |m| (m, n)));
        pairs
            .filter_map(|(m, n)| {
                let error = epoch.ranges.get(m, n)? - expected.get(m, n)?;
                let weighting = self.model.weighting();
                Some(error / variance(self.model.noise(), weighting, epoch.weight_ranges(), m, n).sqrt())
            })
            .collect()
    }

    fn projected(&self, theta: &Theta<D>) -> Vec<f64> {
        let white = measurements(self.model, &self.epoch.ranges, self.epoch.weight_ranges());
        (white.values - white.matrix * dense::vector(theta)).iter().copied().collect()
    }

    fn slopes(&self, pose: &Pose<D>) -> DMatrix<f64> {
        let step = 1e-5;
        let moved = |i: usize, sign: f64| {
            let mut x = TangentVector::zeros();
            x[i] = sign * step;
            let (phi, shift) = split::<D>(&x);
            self.at(&pose.retract(&phi, &shift))
        };
        let columns: Vec<_> =
            (0..tangent_dimension(D)).map(|i| (moved(i, 1.0) - moved(i, -1.0)) / (2.0 * step)).collect();
        DMatrix::from_columns(&columns)
    }
}

fn tangent_covariance<const D: usize>(step: &Step<D>) -> DMatrix<f64> {
    match &step.uncertainty {
        Uncertainty::Tangent(p) => dense::tangent(p),
        _ => panic!("an error-state filter"),
    }
}

fn check<const D: usize>(track: &Track<D>, name: EstimatorName) {
    let (recording, angles) = (&track.recording, tangent_dimension(D) - D);
    let mut filter = track.estimator(name, &EstimatorSettings::default());
    let variance = recording.initial.variance;
    let mut covariance = DMatrix::from_fn(angles + D, angles + D, |i, j| {
        if i != j {
            0.0
        } else if i < angles {
            0.5 * variance
        } else {
            variance
        }
    });
    for epoch in &recording.epochs {
        for i in 0..angles + D {
            let sigma = if i < angles { recording.process.sigma_q } else { recording.process.sigma_t };
            covariance[(i, i)] += sigma * sigma;
        }
        let step = filter.step(epoch).unwrap();
        at_most("defect", defect(&step.posterior.orientation), 3e-15);
        let root = covariance.clone().cholesky().unwrap().l().try_inverse().unwrap();
        let raw = name == EstimatorName::EskfRaw;
        let residuals = Residuals { prior: pose(&step.prior), root, model: &recording.model, epoch, raw };
        let found = pose(&step.posterior);
        let (r, j) = (residuals.at(&found), residuals.slopes(&found));
        covariance = tangent_covariance(&step);
        let curvature = j.tr_mul(&j).cholesky().unwrap().inverse();
        at_most("covariance", dense::difference(&covariance, &curvature), 1e-6);
        // The Gauss-Newton step that is left, in standard deviations.
        let left = |slope: &DVector<f64>| slope.dot(&(&curvature * slope)).sqrt();
        at_most("distance to the minimum", left(&j.tr_mul(&r)), 1e-6);
        let spoiled = found.retract(&[1e-4, 0.0, 0.0], &(found.position * 0.0));
        caught("a turn by 1e-4", left(&j.tr_mul(&residuals.at(&spoiled))), 1e-5);
    }
}

fn the_posterior_is_stationary_and_the_covariance_is_its_curvature<const D: usize>() {
    let mut sampler = Sampler::new(600);
    for index in 0..12_u32 {
        let weighting = if index.is_multiple_of(2) { Weighting::Common } else { Weighting::PerPair };
        let sigma = [0.02, 0.1, 0.3][index as usize % 3];
        let noise = rangelab::model::noise::RangeNoise::Range { sigma };
        let options =
            Options { weighting, noise, centred: index < 6, missing: 0.1, steps: 5, ..Options::default() };
        let track = Track::<D>::random(&mut sampler, &options);
        check(&track, EstimatorName::Eskf);
        check(&track, EstimatorName::EskfRaw);
    }
}

/// `||s||^2` is one unknown for each sensor: projecting it out cannot make the covariance smaller.
fn the_raw_form_knows_more<const D: usize>() {
    let mut sampler = Sampler::new(601);
    for _ in 0..20 {
        let options = Options { steps: 1, anchors: D + 1, drawn: 0.0, variance: 1e-2, ..Options::default() };
        let mut track = Track::<D>::random(&mut sampler, &options);
        let (recording, epoch) = (&track.recording, &track.recording.epochs[0]);
        let prior = epoch.motion.predict_theta(&recording.initial.theta, &epoch.motion.rotation());
        // Ranges at the prior keep both forms where they start, so that the same pose is compared.
        let ranges = recording.model.exact_ranges(&prior).unwrap();
        track.recording.epochs[0] = Epoch { ranges, true_ranges: None, motion: epoch.motion };
        let [projected, raw] = [EstimatorName::Eskf, EstimatorName::EskfRaw].map(|name| {
            let step = track.estimator(name, &EstimatorSettings::default()).step(&track.recording.epochs[0]);
            tangent_covariance(&step.unwrap())
        });
        let gain = (&projected - &raw).symmetric_eigenvalues().min();
        at_most("covariance lost", -gain, 1e-9 * projected.norm());
        assert!(raw.trace() < projected.trace());
    }
}
