//! Singular values to their last relative digits, also where they differ by many orders of magnitude.

use nalgebra::{Matrix3, SMatrix, SVector};
use rangelab::math::singular::{Singular, singular};

use crate::support::at_most;
use crate::support::sampling::Sampler;

crate::in_plane_and_space!(
    factors_multiply_to_the_matrix,
    graded_columns_keep_the_relative_accuracy_of_the_least_value,
    deficient_rank_still_gives_orthogonal_factors,
    scale_does_not_matter,
);

fn product<const D: usize>(s: &Singular<D>) -> SMatrix<f64, D, D> {
    s.left * SMatrix::from_diagonal(&SVector::from(s.values)) * s.right.transpose()
}

#[track_caller]
fn check<const D: usize>(a: &SMatrix<f64, D, D>) {
    let s = singular(a);
    let identity = SMatrix::<f64, D, D>::identity();
    at_most("U^T U", (s.left.transpose() * s.left - identity).norm(), 3e-15);
    at_most("V^T V", (s.right.transpose() * s.right - identity).norm(), 3e-15);
    at_most("U S V^T", (product(&s) - a).norm(), 3e-15 * a.norm());
    assert!(s.values.is_sorted_by(|x, y| x >= y) && s.values[D - 1] >= 0.0, "{:?}", s.values);
}

fn factors_multiply_to_the_matrix<const D: usize>() {
    let mut sampler = Sampler::new(10);
    for _ in 0..2000 {
        check(&sampler.matrix::<D>(3.0));
        check(sampler.rotation::<D>().matrix());
    }
    check(&SMatrix::<f64, D, D>::identity());
    check(&SMatrix::<f64, D, D>::repeat(1.0));
}

/// `(orthogonal) diag(g)`: the columns' relative errors of one rounding move each singular value by as little.
fn graded_columns_keep_the_relative_accuracy_of_the_least_value<const D: usize>() {
    let mut sampler = Sampler::new(11);
    for exponent in [3, 6, 9, 12, 15, 40, 120] {
        let least = format!("1e-{exponent}").parse::<f64>().unwrap();
        for _ in 0..50 {
            let mut grades = [1.0; D];
            grades[D - 1] = least;
            grades[D / 2] = if D == 3 { 0.3 } else { least };
            let q = *sampler.rotation::<D>().matrix();
            let s = singular(&(q * SMatrix::from_diagonal(&SVector::from(grades))));
            for (found, expected) in s.values.iter().zip(grades) {
                at_most("a graded singular value", (found / expected - 1.0).abs(), 2e-15);
            }
        }
    }
}

fn deficient_rank_still_gives_orthogonal_factors<const D: usize>() {
    let mut sampler = Sampler::new(12);
    check(&SMatrix::<f64, D, D>::zeros());
    for _ in 0..500 {
        let line = sampler.vector::<D>(1.0) * sampler.vector::<D>(1.0).transpose();
        check(&line);
        check(&(line + sampler.vector::<D>(1.0) * sampler.vector::<D>(1.0).transpose()));
        let mut column = SMatrix::<f64, D, D>::zeros();
        column.set_column(sampler.below(D), &sampler.vector::<D>(1.0));
        check(&column);
        check(&column.transpose());
    }
}

fn scale_does_not_matter<const D: usize>() {
    let mut sampler = Sampler::new(13);
    for _ in 0..50 {
        let a = sampler.matrix::<D>(1.0);
        let plain = singular(&a);
        for scale in [1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300] {
            let scaled = singular(&(a * scale));
            for (x, y) in scaled.values.iter().zip(plain.values) {
                at_most("a scaled singular value", (x / scale / y - 1.0).abs(), 1e-12);
            }
            let identity = SMatrix::<f64, D, D>::identity();
            at_most("U^T U", (scaled.left.transpose() * scaled.left - identity).norm(), 3e-15);
        }
    }
}

/// The 3 x 3 Hilbert matrix, whose eigenvalues are tabulated.
#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn hilbert() {
    let hilbert = Matrix3::from_fn(|i, j| 1.0 / (i + j + 1) as f64);
    let tabulated = [1.408_318_927_123_653_9, 0.122_327_065_853_905_84, 0.002_687_340_355_773_529_4];
    for (found, expected) in singular(&hilbert).values.iter().zip(tabulated) {
        at_most("Hilbert", (found / expected - 1.0).abs(), 1e-13);
    }
}
