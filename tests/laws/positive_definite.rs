//! Inverses of small positive definite matrices, plain and in blocks; what is not positive definite is refused.

use nalgebra::{DMatrix, SMatrix, SVector};
use rangelab::math::block::BlockMatrix;
use rangelab::math::linalg::{add_outer, spd_inverse};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense};

crate::in_plane_and_space!(
    inverse_times_matrix_is_the_identity,
    badly_scaled_matrices_keep_their_digits,
    what_is_not_positive_definite_is_refused,
    products_are_what_they_say,
    block_inverse_is_the_dense_inverse,
    block_products_are_dense_products,
    block_matrices_that_are_not_positive_definite_are_refused,
);

/// A random positive definite matrix on `theta` with condition `10^(2 spread)`.
pub fn blocks<const D: usize>(sampler: &mut Sampler, scale: impl Fn(usize) -> f64) -> BlockMatrix<D> {
    let size = D * (D + 1);
    let root = DMatrix::from_fn(size, size + 3, |i, _| scale(i) * sampler.normal());
    dense::blocks(&(&root * root.transpose()))
}

fn inverse_times_matrix_is_the_identity<const D: usize>() {
    let mut sampler = Sampler::new(30);
    for condition in [1.0, 1e3, 1e6, 1e9] {
        for _ in 0..100 {
            let a = sampler.spd::<D>(&[condition, 0.5 * condition + 0.5, 1.0]);
            let a = (a + a.transpose()) * 0.5;
            let inverse = spd_inverse(&a).unwrap();
            assert_eq!(inverse, inverse.transpose());
            let defect = (inverse * a - SMatrix::<f64, D, D>::identity()).norm();
            at_most("A^-1 A - I", defect, 1e-15 * condition);
            if condition == 1e3 {
                let spoiled = (inverse * 1.000_001 * a - SMatrix::<f64, D, D>::identity()).norm();
                caught("an error of 1e-6", spoiled, 1e-15 * condition);
            }
        }
    }
}

/// Scaling rows and columns is no loss of digits.
fn badly_scaled_matrices_keep_their_digits<const D: usize>() {
    let mut sampler = Sampler::new(31);
    let scale = SMatrix::<f64, D, D>::from_diagonal(&SVector::from_fn(|i, _| [1e100, 1.0, 1e-100][i]));
    let back = SMatrix::<f64, D, D>::from_diagonal(&SVector::from_fn(|i, _| [1e-100, 1.0, 1e100][i]));
    for _ in 0..100 {
        let a = sampler.spd::<D>(&[3.0, 2.0, 1.0]);
        let a = (a + a.transpose()) * 0.5;
        let inverse = spd_inverse(&(scale * a * scale)).unwrap();
        let expected = spd_inverse(&a).unwrap();
        at_most("scaled", (scale * inverse * scale - expected).norm(), 1e-14);
        at_most("scaled twice", (back * expected * back - inverse).component_div(&inverse).amax(), 1e-11);
    }
}

fn what_is_not_positive_definite_is_refused<const D: usize>() {
    let mut sampler = Sampler::new(32);
    for least in [-1.0, -1e-3, -1e-12, 0.0] {
        for _ in 0..100 {
            let a = sampler.spd::<D>(if D == 2 { [1.0, least, 0.0] } else { [1.0, 0.5, least] }.as_slice());
            match spd_inverse(&a) {
                Err(pivot) => at_most("the pivot", pivot, 1e-14),
                // Rounding may leave a singular matrix positive; a negative eigenvalue stays one.
                Ok(_) => assert!(least == 0.0, "eigenvalue {least} was taken"),
            }
        }
    }
    let identity = SMatrix::<f64, D, D>::identity();
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e-320] {
        assert!(spd_inverse(&(identity * bad)).is_err(), "{bad} I was taken");
    }
    let mut denormal = identity;
    denormal[(D - 1, D - 1)] = 1e-320;
    assert!(spd_inverse(&denormal).is_err(), "a pivot whose inverse overflows was taken");
    assert!(spd_inverse(&SMatrix::<f64, D, D>::repeat(1.0)).is_err());
}

fn products_are_what_they_say<const D: usize>() {
    let mut sampler = Sampler::new(33);
    let (a, x, y) = (sampler.matrix::<D>(1.0), sampler.vector::<D>(1.0), sampler.vector::<D>(1.0));
    let mut sum = a;
    add_outer(&mut sum, 2.0, &x, &y);
    at_most("A + 2 x y^T", (sum - (a + x * y.transpose() * 2.0)).norm(), 1e-14);
}

fn block_inverse_is_the_dense_inverse<const D: usize>() {
    let mut sampler = Sampler::new(34);
    for spread in [0.0, 1.0, 3.0] {
        for _ in 0..100 {
            let scale = |i: usize| {
                rangelab::math::float::pow(10.0, if i.is_multiple_of(2) { spread } else { -spread })
            };
            let a = blocks::<D>(&mut sampler, scale);
            let inverse = dense::matrix(&a.inverse().unwrap());
            let scaled = |power: f64, m: &DMatrix<f64>| {
                DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| {
                    m[(i, j)] * rangelab::math::float::pow(scale(i) * scale(j), power)
                })
            };
            let reference = scaled(-1.0, &dense::matrix(&a)).cholesky().unwrap().inverse();
            at_most("inverse", dense::difference(&scaled(1.0, &inverse), &reference), 1e-11);
            let theta = sampler.theta::<D>(1.0);
            let x = dense::vector(&theta);
            let expected = x.dot(&(&inverse * &x));
            let found = a.inverse_quadratic_form(&theta).unwrap();
            at_most("x^T A^-1 x", (found - expected).abs() / expected, 1e-11);
        }
    }
}

fn block_products_are_dense_products<const D: usize>() {
    let mut sampler = Sampler::new(35);
    let a = blocks::<D>(&mut sampler, |_| 1.0);
    let (full, theta) = (dense::matrix(&a), sampler.theta::<D>(1.0));
    let x = dense::vector(&theta);
    at_most("A x", (dense::vector(&a.times(&theta)) - &full * &x).norm(), 1e-13);
    at_most("trace", (a.orientation_trace() - full.view((0, 0), (D * D, D * D)).trace()).abs(), 1e-13);
    let mut sum = a;
    sum.add(&BlockMatrix::isotropic(2.0, 3.0));
    let shift = DMatrix::from_fn(full.nrows(), full.ncols(), |i, j| {
        if i != j {
            0.0
        } else if i < D * D {
            2.0
        } else {
            3.0
        }
    });
    assert_eq!(dense::matrix(&sum), dense::matrix(&a) + shift);
    assert_eq!(dense::theta::<D>(&x), theta);
}

/// Rank lost between the blocks, not inside one: what is left of a block after the ones before it is rounding.
fn block_matrices_that_are_not_positive_definite_are_refused<const D: usize>() {
    let mut sampler = Sampler::new(36);
    let size = D * (D + 1);
    let mut taken = 0;
    for _ in 0..200 {
        let root = DMatrix::from_fn(size, size - 1, |_, _| sampler.normal());
        taken += usize::from(dense::blocks::<D>(&(&root * root.transpose())).inverse().is_ok());
        let mut indefinite = blocks::<D>(&mut sampler, |_| 1.0);
        let mut corner = indefinite.block(D, D);
        corner[(0, 0)] -= 100.0 * size as f64;
        indefinite.set_block(D, D, &corner);
        assert!(indefinite.inverse().is_err(), "an indefinite matrix was taken");
    }
    // What is left is rounding of either sign; held against the wrong diagonal, half of the matrices pass.
    assert!(taken < 40, "{taken} of 200 singular matrices were taken");
    assert!(BlockMatrix::<D>::zeros().inverse().is_err());
    assert!(BlockMatrix::<D>::isotropic(f64::NAN, 1.0).inverse().is_err());
    let mut correlated = BlockMatrix::<D>::isotropic(0.1, 0.1);
    correlated.set_block(1, 0, &(SMatrix::identity() * 0.1));
    assert!(correlated.inverse().is_err(), "two columns that are equal were taken");
}
