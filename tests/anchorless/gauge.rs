//! Centring, alignment and scaled time.

use nalgebra::{DMatrix, dmatrix};
use rangelab::Error;
use rangelab::model::kinematics::coefficients::RelativeKinematics;
use rangelab::model::kinematics::gauge::procrustes;
use rangelab::model::kinematics::pair_polynomial::{chebyshev_nodes, lagrange_values, pair_polynomials};
use rangelab::model::kinematics::time_scale::TimeScale;
use rangelab::simulate::kinematics::simulate_kinematics;

use crate::networks::{exact, paper, random};

/// The largest error of a coefficient as it stands, in parts of that coefficient.
fn largest_error(found: &RelativeKinematics, truth: &RelativeKinematics) -> f64 {
    let part = |(a, b): (&DMatrix<f64>, &DMatrix<f64>)| (a - b).norm() / b.norm();
    found.coefficients().iter().zip(truth.coefficients()).map(part).fold(0.0, f64::max)
}

fn motion(dimension: usize, seed: u64) -> RelativeKinematics {
    random(seed, dimension, 7, 3).setup().unwrap().motion
}

/// A rotation and a reflection, in the plane and in space.
fn turns(dimension: usize) -> [DMatrix<f64>; 2] {
    let turn = if dimension == 2 {
        dmatrix![0.6, -0.8; 0.8, 0.6]
    } else {
        dmatrix![0.6, -0.8, 0.0; 0.8, 0.6, 0.0; 0.0, 0.0, 1.0]
    };
    let mut mirror = turn.clone();
    mirror.row_mut(0).neg_mut();
    [turn, mirror]
}

#[test]
fn alignment_undoes_turns_mirrors_and_shifts() {
    for dimension in [2, 3] {
        let truth = motion(dimension, 5).centred();
        for turn in turns(dimension) {
            let shift = |each: &DMatrix<f64>| each.map(|value| value + 17.0);
            let moved = truth.rotated(&turn).coefficients().iter().map(shift).collect();
            let aligned = RelativeKinematics::new(moved).unwrap().aligned_to(&truth).unwrap();
            assert!(largest_error(&aligned, &truth) < 1e-12);
        }
    }
}

/// What aligning each coefficient by itself would hide: accelerations turned against the positions.
#[test]
fn networks_of_other_sizes_are_not_aligned() {
    let truth = motion(2, 1);
    let zeros = |dimension, nodes| RelativeKinematics::new(vec![DMatrix::zeros(dimension, nodes)]).unwrap();
    let refused = |other: &RelativeKinematics| match other.aligned_to(&truth).unwrap_err() {
        Error::Size { what, found, expected } => (what, found, expected),
        other => panic!("{other}"),
    };
    let nodes = truth.nodes();
    assert_eq!(refused(&zeros(2, nodes + 1)), ("nodes", nodes + 1, nodes));
    assert_eq!(refused(&zeros(3, nodes)), ("coordinates of a node", 3, 2));
    assert!(zeros(2, nodes).aligned_to(&truth).is_ok());
}

#[test]
fn one_alignment_shows_accelerations_turned_the_wrong_way() {
    let truth = motion(2, 6).centred();
    let [turn, _] = turns(2);
    let mut coefficients = truth.coefficients().to_vec();
    coefficients[2] = &turn * &coefficients[2];
    let wrong = RelativeKinematics::new(coefficients).unwrap();
    let aligned = wrong.aligned_to(&truth).unwrap();
    assert!(largest_error(&aligned, &truth) > 0.5);
    let by_itself = procrustes(wrong.coefficient(2), truth.coefficient(2)).unwrap();
    assert!((by_itself * wrong.coefficient(2) - truth.coefficient(2)).norm() < 1e-12);
}

#[test]
fn scaled_time_is_another_way_to_write_the_same_motion() {
    let motion = motion(3, 7);
    let scale = TimeScale::of(&[2.0, 12.0, 5.0]);
    let scaled = scale.scale(&motion);
    for time in [2.0, 4.5, 12.0] {
        let (here, there) = (motion.positions(time), scaled.positions(scale.scaled(time)));
        assert!((here - there).amax() < 1e-9);
    }
    assert!(largest_error(&scale.unscale(&scaled).unwrap(), &motion) < 1e-10);
    let once = TimeScale::of(&[3.0, 3.0]);
    assert_eq!((once.middle, once.half), (3.0, 1.0));
}

#[test]
fn derivatives_are_those_of_the_positions() {
    let motion = motion(2, 8);
    let (time, step) = (1.3, 1e-4);
    let slope = |order: usize, at: f64| {
        (motion.derivative(order, at + step) - motion.derivative(order, at - step)) / (2.0 * step)
    };
    for order in 0..3 {
        let difference = (slope(order, time) - motion.derivative(order + 1, time)).amax();
        let size = motion.derivative(order + 1, time).amax();
        assert!(difference < 1e-5 * size, "order {order}: {difference:e}");
        // At another time it is another derivative.
        assert!(
            (slope(order, time + 0.5) - motion.derivative(order + 1, time)).amax() > 1e-3 * size
                || order == 2
        );
    }
    assert!(motion.derivative(4, time).iter().all(|value| value.abs() < f64::MIN_POSITIVE));
}

#[test]
fn gram_coefficients_add_up_to_the_gram_matrix() {
    let motion = motion(2, 9).centred();
    let gram = motion.gram();
    assert_eq!(gram.len(), 7);
    let time = 1.7;
    let sum = gram.iter().rev().fold(DMatrix::zeros(7, 7), |sum, b| sum * time + b);
    let positions = motion.positions(time);
    let difference = (sum - positions.transpose() * &positions).amax();
    assert!(difference < 1e-9, "{difference:e}");
}

/// The cost of the compressed pair is, but for a constant, the weighted cost of its distances.
#[test]
fn pair_polynomials_keep_the_cost_of_their_distances() {
    let mut scenario = paper(60);
    scenario.noise.missing_probability = 0.1;
    let drawn = simulate_kinematics(&scenario, 0).unwrap();
    let nodes = chebyshev_nodes(5);
    let scale = drawn.record.time_scale();
    let sigma = drawn.record.sigma();
    let pair = 13;
    let compressed = &pair_polynomials(&drawn.record, 2)[pair];
    let small = |model: &[f64]| {
        (&compressed.factor * nalgebra::DVector::from_row_slice(model) - &compressed.target).norm_squared()
    };
    let full = |model: &[f64]| {
        let term = |k: usize| {
            let distance = drawn.record.distances(k)[pair]?;
            let at = lagrange_values(&nodes, scale.scaled(drawn.record.stamps()[k]));
            let squared: f64 = at.iter().zip(model).map(|(value, model)| value * model).sum();
            let variance = sigma * sigma * (4.0 * distance * distance + 2.0 * sigma * sigma);
            let residual = distance * distance - squared;
            Some(residual * residual / variance)
        };
        (0..60).filter_map(term).sum::<f64>()
    };
    let model = |step: f64| (0..5).map(|i| 1e6 + step * (f64::from(i) - 1.5)).collect::<Vec<f64>>();
    let (low, high) = (model(0.0), model(3e4));
    let (small, full) = (small(&high) - small(&low), full(&high) - full(&low));
    assert!((small - full).abs() < 1e-9 * full.abs(), "{small} {full}");
}

/// A pair with fewer distances than coefficients is no special case, and one without any says nothing.
#[test]
fn pair_polynomials_of_few_distances_have_few_rows() {
    let mut scenario = exact(paper(3));
    let drawn = simulate_kinematics(&scenario, 0).unwrap();
    assert_eq!(pair_polynomials(&drawn.record, 2)[0].factor.shape(), (3, 5));
    scenario.noise.missing_probability = 1.0;
    let drawn = simulate_kinematics(&scenario, 0).unwrap();
    let none = &pair_polynomials(&drawn.record, 2)[0];
    assert_eq!((none.factor.shape(), none.target.len()), ((0, 5), 0));
}
