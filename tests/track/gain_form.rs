//! The Kalman filter in blocks of information against the textbook on long matrices.

use nalgebra::{DMatrix, DVector};
use rangelab::math::pose::Theta;
use rangelab::model::covariance::Covariance;
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::ranging::{RangeForm, Weighting};
use rangelab::track::filter::{Step, Uncertainty};

use crate::scenario::{Options, Track, Truth, transition};
use crate::support::gain_form::{KalmanState, measurements};
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense};

crate::in_plane_and_space!(
    the_fast_path_is_the_textbook,
    the_general_path_is_the_textbook,
    the_papers_scale_is_the_textbook,
    decoupled_covariance_is_the_full_one,
);

pub fn start<const D: usize>(track: &Track<D>) -> KalmanState {
    let size = D * (D + 1);
    let initial = &track.recording.initial;
    KalmanState {
        theta: dense::vector(&initial.theta),
        covariance: DMatrix::identity(size, size) * initial.variance,
    }
}

pub fn covariance<const D: usize>(step: &Step<D>) -> &Covariance<D> {
    match &step.uncertainty {
        Uncertainty::Linear(p) | Uncertainty::Constrained(p) => p,
        Uncertainty::Tangent(_) => panic!("a linear filter"),
    }
}

/// Largest relative differences of estimate, covariance and NIS over a track.
fn compare<const D: usize>(track: &Track<D>, fast: bool) -> [f64; 3] {
    let mut filter = track.estimator(EstimatorName::Kf, &EstimatorSettings::default());
    let mut textbook = start(track);
    let mut worst = [0.0_f64; 3];
    for epoch in &track.recording.epochs {
        let step = filter.step(epoch).unwrap();
        let (f, u, noise) = transition(&epoch.motion, &track.recording.process);
        textbook.predict(&f, &u, &noise);
        let nis =
            textbook.update(&measurements(&track.recording.model, &epoch.ranges, epoch.weight_ranges()));
        let p = covariance(&step);
        assert_eq!(matches!(p, Covariance::Decoupled { .. }), fast);
        let errors = [
            dense::vector_difference(&dense::vector(&step.posterior), &textbook.theta),
            dense::difference(&dense::matrix(&p.to_blocks()), &textbook.covariance),
            (step.nis.value - nis).abs() / nis.max(1.0),
        ];
        for (all, one) in worst.iter_mut().zip(errors) {
            *all = all.max(one);
        }
    }
    worst
}

#[track_caller]
fn check<const D: usize>(seed: u64, options: &Options, fast: bool, limits: [f64; 3]) {
    let mut sampler = Sampler::new(seed);
    for _ in 0..20 {
        let worst = compare(&Track::<D>::random(&mut sampler, options), fast);
        for ((what, error), limit) in ["theta", "P", "NIS"].iter().zip(worst).zip(limits) {
            at_most(what, error, limit);
        }
    }
}

const TIGHT: [f64; 3] = [1e-11, 1e-11, 1e-9];

fn the_fast_path_is_the_textbook<const D: usize>() {
    for truth in [Truth::Rigid, Truth::Linear] {
        check::<D>(200, &Options { truth, ..Options::default() }, true, TIGHT);
    }
}

fn the_general_path_is_the_textbook<const D: usize>() {
    let plain = Options::default();
    for options in [
        Options { centred: false, ..plain },
        Options { weighting: Weighting::PerPair, ..plain },
        Options { missing: 0.3, ..plain },
        Options { missing: 0.7, centred: false, weighting: Weighting::PerPair, ..plain },
        Options { anchors: D, ..plain },
    ] {
        let fast = options.anchors == D;
        check::<D>(201, &options, fast, TIGHT);
    }
}

/// Two kilometres of anchors around a body of one metre.
fn the_papers_scale_is_the_textbook<const D: usize>() {
    let noise = rangelab::model::noise::RangeNoise::SquaredRange { sigma: 0.0316 };
    let options = Options { half: 1000.0, noise, variance: 100.0, ..Options::default() };
    check::<D>(202, &options, true, [1e-7, 1e-7, 1e-6]);
}

/// Everything that both forms of a covariance answer.
#[track_caller]
fn same<const D: usize>(fast: &Covariance<D>, full: &Covariance<D>, theta: &Theta<D>) {
    let (a, b) = (dense::matrix(&fast.to_blocks()), dense::matrix(&full.to_blocks()));
    at_most("P", dense::difference(&a, &b), 1e-12);
    let product: DVector<f64> = &b * dense::vector(theta);
    let split = D * D;
    let expected = b.view((0, 0), (split, split)).into_owned().cholesky().unwrap().inverse();
    for covariance in [fast, full] {
        at_most("P x", dense::vector_difference(&dense::vector(&covariance.times(theta)), &product), 1e-12);
        at_most("tr P_q", (covariance.orientation_trace() / full.orientation_trace() - 1.0).abs(), 1e-12);
        let metric = dense::matrix(&covariance.orientation_metric().unwrap().metric);
        let metric = metric.view((0, 0), (split, split)).into_owned();
        at_most("P_q^-1", dense::difference(&metric, &expected), 1e-11);
    }
}

fn decoupled_covariance_is_the_full_one<const D: usize>() {
    let mut sampler = Sampler::new(203);
    let track = Track::<D>::random(&mut sampler, &Options::default());
    let (model, process) = (&track.recording.model, &track.recording.process);
    let mut fast = Covariance::isotropic(1.0, model.topology());
    let mut full = Covariance::Full(fast.to_blocks());
    let mut buffer = model.range_buffer();
    for epoch in &track.recording.epochs {
        let normal = model
            .normal_equations(
                &epoch.ranges,
                epoch.weight_ranges(),
                &track.truth[0],
                RangeForm::Projected,
                &mut buffer,
            )
            .unwrap();
        for covariance in [&mut fast, &mut full] {
            covariance.predict(epoch.motion.rotation().matrix(), process);
            covariance.update(&normal.information).unwrap();
        }
        same(&fast, &full, &sampler.theta(1.0));
        let mut other = fast;
        other.predict(epoch.motion.rotation().matrix(), process);
        caught(
            "one prediction more",
            dense::difference(&dense::matrix(&other.to_blocks()), &dense::matrix(&full.to_blocks())),
            1e-4,
        );
    }
}
