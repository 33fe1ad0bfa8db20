//! The UC-KF against brute force on \[T\] eq. 23, joint and decoupled.

use nalgebra::{DMatrix, DVector, SMatrix};
use rangelab::math::block::BlockMatrix;
use rangelab::math::pose::Theta;
use rangelab::math::rotation::{Manifold, defect, determinant};
use rangelab::model::estimator_settings::{EstimatorName, EstimatorSettings};
use rangelab::model::ranging::Weighting;
use rangelab::track::filter::Step;

use crate::gain_form::{covariance, start};
use crate::projection::lowest_cost;
use crate::scenario::{Options, Track, transition};
use crate::support::gain_form::{Measurements, measurements};
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense};

crate::in_plane_and_space!(
    the_joint_form_is_the_minimum_of_the_papers_cost,
    centred_topologies_decouple,
    the_joint_form_beats_the_decoupled_one,
    the_covariance_is_the_plain_filters,
);

/// \[T\] eq. 23 in full: prior and whitened measurements, `D(D+1)` unknowns.
struct Cost {
    precision: DMatrix<f64>,
    prior: DVector<f64>,
    measured: Measurements,
}

impl Cost {
    fn at(&self, theta: &DVector<f64>) -> f64 {
        let (deviation, residual) =
            (theta - &self.prior, &self.measured.values - &self.measured.matrix * theta);
        deviation.dot(&(&self.precision * &deviation)) + residual.norm_squared()
    }

    /// The cost with the best `t` for each `Q`: `(q - center)^T metric (q - center) + least`.
    fn reduced<const D: usize>(&self) -> (SMatrix<f64, D, D>, BlockMatrix<D>, f64) {
        let h = &self.measured.matrix;
        let normal = &self.precision + h.tr_mul(h);
        let right = &self.precision * &self.prior + h.tr_mul(&self.measured.values);
        let covariance = normal.cholesky().unwrap().inverse();
        let center = &covariance * right;
        let split = D * D;
        let schur = covariance.view((0, 0), (split, split)).into_owned().cholesky().unwrap().inverse();
        let mut padded = DMatrix::zeros(D * (D + 1), D * (D + 1));
        padded.view_mut((0, 0), (split, split)).copy_from(&schur);
        (dense::theta::<D>(&center).orientation, dense::blocks(&padded), self.at(&center))
    }
}

/// The steps of a UC-KF with the cost that each had to minimize.
fn run<const D: usize>(track: &Track<D>, settings: &EstimatorSettings) -> Vec<(Step<D>, Cost)> {
    let mut filter = track.estimator(EstimatorName::UcKf, settings);
    let mut reference = start(track);
    let step = |epoch| {
        let step: Step<D> = filter.step(epoch).unwrap();
        let (f, u, noise) = transition(&epoch.motion, &track.recording.process);
        reference.predict(&f, &u, &noise);
        let measured = measurements(&track.recording.model, &epoch.ranges, epoch.weight_ranges());
        let precision = reference.covariance.clone().cholesky().unwrap().inverse();
        reference.update(&measured);
        let error = dense::difference(&dense::matrix(&covariance(&step).to_blocks()), &reference.covariance);
        at_most("P", error, 1e-10);
        let cost = Cost { precision, prior: dense::vector(&step.prior), measured };
        (step, cost)
    };
    track.recording.epochs.iter().map(step).collect()
}

fn options(index: u64) -> Options {
    let weighting = if index.is_multiple_of(2) { Weighting::Common } else { Weighting::PerPair };
    let sigma = [0.05, 0.3][(index / 2 % 2) as usize];
    let noise = rangelab::model::noise::RangeNoise::Range { sigma };
    Options { weighting, noise, centred: false, missing: 0.1, steps: 4, ..Options::default() }
}

fn the_joint_form_is_the_minimum_of_the_papers_cost<const D: usize>() {
    let mut sampler = Sampler::new(500);
    for index in 0..8 {
        let track = Track::<D>::random(&mut sampler, &options(index));
        for manifold in [Manifold::So, Manifold::O] {
            let settings = EstimatorSettings { manifold, decoupled: false, ..EstimatorSettings::default() };
            for (step, cost) in run(&track, &settings) {
                at_most("defect", defect(&step.posterior.orientation), 3e-15);
                let (center, metric, least) = cost.reduced::<D>();
                let mut lowest = least + lowest_cost(&mut sampler, &center, &metric);
                if manifold == Manifold::O {
                    lowest = lowest.min(least + mirrored_cost(&mut sampler, &center, &metric));
                } else {
                    assert!(determinant(&step.posterior.orientation) > 0.0);
                }
                let found = cost.at(&dense::vector(&step.posterior));
                at_most("cost above the lowest", found / lowest - 1.0, 1e-9);
                at_most("cost below the lowest", 1.0 - found / lowest, 1e-9);
                let polar =
                    rangelab::math::rotation::Rotation::project(&step.unprojected.orientation, manifold);
                let ortho = Theta { orientation: *polar.matrix(), ..step.unprojected };
                if index == 2 {
                    caught("KF-ortho instead", cost.at(&dense::vector(&ortho)) / lowest - 1.0, 1e-9);
                }
            }
        }
    }
}

/// The lowest cost over the reflections: mirror the last axis of the body.
fn mirrored_cost<const D: usize>(
    sampler: &mut Sampler,
    q: &SMatrix<f64, D, D>,
    metric: &BlockMatrix<D>,
) -> f64 {
    let mut q = *q;
    q.column_mut(D - 1).neg_mut();
    let mut metric = *metric;
    for j in 0..D - 1 {
        metric.set_block(D - 1, j, &-metric.block(D - 1, j));
    }
    lowest_cost(sampler, &q, &metric)
}

fn both<const D: usize>(track: &Track<D>) -> [Vec<(Step<D>, Cost)>; 2] {
    [false, true]
        .map(|decoupled| run(track, &EstimatorSettings { decoupled, ..EstimatorSettings::default() }))
}

fn centred_topologies_decouple<const D: usize>() {
    let mut sampler = Sampler::new(501);
    for _ in 0..10 {
        let track = Track::<D>::random(&mut sampler, &Options { steps: 10, ..Options::default() });
        let [joint, decoupled] = both(&track);
        for ((a, _), (b, _)) in joint.iter().zip(&decoupled) {
            let error = dense::vector_difference(&dense::vector(&a.posterior), &dense::vector(&b.posterior));
            at_most("joint - decoupled", error, 1e-12);
        }
    }
}

fn the_joint_form_beats_the_decoupled_one<const D: usize>() {
    let mut sampler = Sampler::new(502);
    let mut larger = 0;
    for index in 0..10 {
        let track = Track::<D>::random(&mut sampler, &Options { missing: 0.0, steps: 1, ..options(index) });
        let [joint, decoupled] = both(&track);
        for ((a, cost), (b, _)) in joint.iter().zip(&decoupled) {
            let (a, b) = (cost.at(&dense::vector(&a.posterior)), cost.at(&dense::vector(&b.posterior)));
            at_most("the joint cost above the decoupled", a / b - 1.0, 1e-11);
            larger += u32::from(b > a * (1.0 + 1e-9));
        }
    }
    assert!(larger > 5, "the decoupled form was the minimum in all but {larger} of 10: nothing was compared");
}

fn the_covariance_is_the_plain_filters<const D: usize>() {
    let mut sampler = Sampler::new(503);
    let track = Track::<D>::random(&mut sampler, &options(0));
    let settings = EstimatorSettings::default();
    let mut filters = [EstimatorName::Kf, EstimatorName::UcKf].map(|name| track.estimator(name, &settings));
    for epoch in &track.recording.epochs {
        let [plain, constrained] = [0, 1].map(|k| filters[k].step(epoch).unwrap());
        assert_eq!(covariance(&plain), covariance(&constrained));
    }
}
