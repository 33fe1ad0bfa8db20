//! The posterior bounds against dense recursions in other coordinates, against the Kalman filter, and without truth.

use nalgebra::{DMatrix, SMatrix};
use rangelab::bounds::{Bound, BoundKind, BoundMatrix, StepBounds, bounds_along};
use rangelab::math::float::radians;
use rangelab::math::pose::Pose;
use rangelab::math::rotation::hat;
use rangelab::model::epoch::Recording;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};
use rangelab::track::filter::{Estimator, Uncertainty};
use rangelab::track::kalman::KalmanFilter;

use crate::dense::{difference, of_blocks, of_tangent, stacked, stacked_raw};
use crate::scenes::{random, recording, tracking};

fn known<const D: usize>(step: &StepBounds<D>, kind: BoundKind) -> &Bound<D> {
    step.get(kind).expect("the truth is known").as_ref().expect("the bound exists")
}

fn matrix<const D: usize>(bound: &Bound<D>) -> DMatrix<f64> {
    match &bound.matrix {
        BoundMatrix::Linear(matrix) => of_blocks(matrix),
        BoundMatrix::Tangent(matrix) => of_tangent(matrix),
    }
}

/// The covariance update by the gain, in Joseph's form; `h` is whitened.
fn joseph(p: &DMatrix<f64>, h: &DMatrix<f64>) -> DMatrix<f64> {
    let identity = |size: usize| DMatrix::<f64>::identity(size, size);
    let s = h * p * h.transpose() + identity(h.nrows());
    let gain = p * h.transpose() * s.try_inverse().expect("positive definite");
    let rest = identity(p.nrows()) - &gain * h;
    &rest * p * rest.transpose() + &gain * gain.transpose()
}

/// Diagonal matrix of `count` entries `first`, then D entries `last`.
fn two_part<const D: usize>(count: usize, first: f64, last: f64) -> DMatrix<f64> {
    DMatrix::from_fn(count + D, count + D, |i, j| {
        if i != j {
            0.0
        } else if i < count {
            first
        } else {
            last
        }
    })
}

fn linear_bound_is_the_gain_form<const D: usize>(recording: &Recording<D>) {
    let bounds = bounds_along(recording).unwrap();
    let mut p = two_part::<D>(D * D, 100.0, 100.0);
    let noise = recording.process;
    for (k, epoch) in recording.epochs.iter().enumerate() {
        let turn = epoch.motion.rotation();
        let turn = DMatrix::from_fn(D, D, |i, j| turn.matrix()[(i, j)]);
        let mut f = DMatrix::identity(D * (D + 1), D * (D + 1));
        for column in 0..D {
            f.view_mut((column * D, column * D), (D, D)).copy_from(&turn);
        }
        let process = two_part::<D>(D * D, noise.sigma_q * noise.sigma_q, noise.sigma_t * noise.sigma_t);
        p = &f * p * f.transpose() + process;
        p = joseph(&p, &stacked(&recording.model, &recording.truth[k].unwrap(), |n| n));
        let error = difference(&matrix(known(&bounds[k], BoundKind::LinearPosteriorCrb)), &p);
        assert!(error < 1e-12, "step {k}: {error:e}");
    }
}

/// `d vec([exp(hat(psi)) R | t])/d(psi, t)`: the rotation perturbed on the **left**, so that the motion turns its error.
fn left_tangent<const D: usize>(pose: &Pose<D>) -> DMatrix<f64> {
    let angles = D * (D - 1) / 2;
    DMatrix::from_fn(D * (D + 1), angles + D, |row, column| {
        if column >= angles {
            return f64::from(u8::from(row == D * D + column - angles));
        }
        let mut psi = [0.0; 3];
        psi[column] = 1.0;
        let moved: SMatrix<f64, D, D> = hat::<D>(&psi) * pose.rotation.matrix();
        if row < D * D { moved[(row % D, row / D)] } else { 0.0 }
    })
}

/// `diag(A, I)` with `A` the rotation in space and 1 in the plane: what turns left angles into right ones and back.
fn turning<const D: usize>(rotation: &SMatrix<f64, D, D>) -> DMatrix<f64> {
    let mut f = two_part::<D>(D * (D - 1) / 2, 1.0, 1.0);
    for i in 0..if D == 3 { 3 } else { 0 } {
        for j in 0..3 {
            f[(i, j)] = rotation[(i, j)];
        }
    }
    f
}

fn intrinsic_bound_is_the_left_perturbed_one<const D: usize>(recording: &Recording<D>) {
    type Stack<const D: usize> = fn(&RangeModel<D>, &Pose<D>) -> DMatrix<f64>;
    let forms: [(BoundKind, Stack<D>); 2] = [
        (BoundKind::PosteriorCrb, |model, pose| stacked(model, pose, |n| n)),
        (BoundKind::PosteriorCrbRaw, |model, pose| stacked_raw(model, pose)),
    ];
    let (bounds, noise) = (bounds_along(recording).unwrap(), recording.process);
    let angles = D * (D - 1) / 2;
    for (kind, stack) in forms {
        let mut p = two_part::<D>(angles, 50.0, 100.0);
        for (k, epoch) in recording.epochs.iter().enumerate() {
            let pose = recording.truth[k].unwrap();
            let f = turning(epoch.motion.rotation().matrix());
            let process = two_part::<D>(angles, noise.sigma_q * noise.sigma_q, noise.sigma_t * noise.sigma_t);
            p = &f * p * f.transpose() + process;
            p = joseph(&p, &(stack(&recording.model, &pose) * left_tangent(&pose)));
            let right = turning(pose.rotation.matrix());
            let error = difference(&matrix(known(&bounds[k], kind)), &(right.transpose() * &p * right));
            assert!(error < 1e-12, "step {k}, {}: {error:e}", kind.name());
        }
    }
}

#[test]
fn the_linear_bound_is_the_gain_form_of_the_stacked_matrices() {
    linear_bound_is_the_gain_form(&tracking(Weighting::PerPair));
    linear_bound_is_the_gain_form(&recording(random::<2>(3, Weighting::PerPair).model, radians(2.0)));
}

#[test]
fn the_intrinsic_bound_does_not_depend_on_the_side_of_the_perturbation() {
    intrinsic_bound_is_the_left_perturbed_one(&tracking(Weighting::PerPair));
    intrinsic_bound_is_the_left_perturbed_one(&recording(
        random::<2>(3, Weighting::PerPair).model,
        radians(2.0),
    ));
}

/// Largest difference of `tr P_q` between the filter with true weights and the linear bound, relative.
fn filter_against_bound(recording: &Recording<3>) -> f64 {
    let bounds = bounds_along(recording).unwrap();
    let mut filter = KalmanFilter::new(recording.model.clone(), &recording.initial, recording.process);
    let relative = recording.epochs.iter().zip(&bounds).map(|(epoch, step)| {
        let Uncertainty::Linear(p) = filter.step(epoch).unwrap().uncertainty else {
            panic!("a linear filter")
        };
        (p.orientation_trace() / known(step, BoundKind::LinearPosteriorCrb).orientation_trace - 1.0).abs()
    });
    relative.fold(0.0, f64::max)
}

#[test]
fn the_linear_bound_is_the_covariance_of_the_kalman_filter_with_true_weights() {
    let same = filter_against_bound(&tracking(Weighting::PerPair));
    assert!(same < 1e-9, "weights per pair: {same:e}");
    // The papers' common weights are not the noise: the filter's covariance is off by what they neglect.
    let common = filter_against_bound(&tracking(Weighting::Common));
    println!("covariance with common weights differs from the bound by up to {common:.1e}");
    assert!(common > 1e-6 && common < 1e-2, "common weights: {common:e}");
}

#[test]
fn a_step_without_truth_silences_only_the_bounds_that_need_it() {
    let whole = tracking(Weighting::PerPair);
    let mut gap = whole.clone();
    gap.truth[3] = None;
    let (with, without) = (bounds_along(&whole).unwrap(), bounds_along(&gap).unwrap());
    for kind in [BoundKind::Crb, BoundKind::UnitaryCrb, BoundKind::UnitaryCrbRaw] {
        assert!(without[3].get(kind).is_none(), "{}", kind.name());
        assert_eq!(without[4].get(kind), with[4].get(kind), "{}", kind.name());
    }
    for kind in [BoundKind::PosteriorCrb, BoundKind::PosteriorCrbRaw] {
        assert_eq!(without[2].get(kind), with[2].get(kind), "{}", kind.name());
        assert!((3..20).all(|k| without[k].get(kind).is_none()), "{}", kind.name());
    }
    for k in 0..20 {
        let trace =
            |steps: &[StepBounds<3>]| known(&steps[k], BoundKind::LinearPosteriorCrb).orientation_trace;
        assert!((trace(&with) / trace(&without) - 1.0).abs() < 1e-12, "the true ranges of the epoch serve");
    }
    assert!(known(&without[3], BoundKind::LinearPosteriorCrb).angle_variance.is_none());
}

#[test]
fn an_epoch_without_ranges_needs_no_truth_and_only_adds_the_process_noise() {
    let mut quiet = tracking(Weighting::PerPair);
    quiet.truth[3] = None;
    quiet.epochs[3].ranges = Ranges::from_fn(4, 5, |_, _| None).unwrap();
    let bounds = bounds_along(&quiet).unwrap();
    for kind in [BoundKind::PosteriorCrb, BoundKind::PosteriorCrbRaw] {
        let growth =
            known(&bounds[3], kind).angle_variance.unwrap() - known(&bounds[2], kind).angle_variance.unwrap();
        assert!(
            (growth / (3.0 * radians(0.1) * radians(0.1)) - 1.0).abs() < 1e-9,
            "{}: {growth:e}",
            kind.name()
        );
        assert!(known(&bounds[4], kind).angle_variance < known(&bounds[3], kind).angle_variance);
    }
}
