//! A second implementation, from the papers' stacked matrices: `U_M`, the whitening `W`, `H = C_e^T (x) Abar`.

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rangelab::math::block::BlockMatrix;
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::tangent::{TangentMatrix, tangent_dimension};
use rangelab::model::ranging::RangeModel;

pub fn of_blocks<const D: usize>(a: &BlockMatrix<D>) -> DMatrix<f64> {
    DMatrix::from_fn(D * (D + 1), D * (D + 1), |i, j| a.block(i / D, j / D)[(i % D, j % D)])
}

pub fn of_tangent<const D: usize>(a: &TangentMatrix<D>) -> DMatrix<f64> {
    DMatrix::from_fn(tangent_dimension(D), tangent_dimension(D), |i, j| a.entry(i, j))
}

/// `[Q | t]` with one entry moved, entries counted column by column.
pub fn moved<const D: usize>(pose: &Pose<D>, entry: usize, step: f64) -> Theta<D> {
    let mut theta = Theta::from(*pose);
    match entry / D {
        column if column < D => theta.orientation[(entry % D, column)] += step,
        _ => theta.position[entry % D] += step,
    }
    theta
}

/// The variance of the squared range of a pair at the true pose.
pub fn variance<const D: usize>(model: &RangeModel<D>, pose: &Pose<D>, m: usize, n: usize) -> f64 {
    let sensor_in_world = pose.act(&model.topology().sensors()[n]);
    model.noise().squared_range_variance((model.anchors().positions()[m] - sensor_in_world).norm_squared())
}

/// Orthonormal basis of the complement of the ones, by Helmert's contrasts: the papers' `U_M`.
fn isometry(count: usize) -> DMatrix<f64> {
    DMatrix::from_fn(count, count - 1, |i, j| {
        let k = (j + 1) as f64;
        let scale = 1.0 / (k * (k + 1.0)).sqrt();
        match i.cmp(&(j + 1)) {
            std::cmp::Ordering::Less => scale,
            std::cmp::Ordering::Equal => -k * scale,
            std::cmp::Ordering::Greater => 0.0,
        }
    })
}

/// `Abar = W U_M^T (-2 A^T)` with `W^T W = (U_M^T Sigma U_M)^-1`, the variances those of sensor `n` (\[L\] eq. 7 to 9).
pub fn whitened_anchors<const D: usize>(model: &RangeModel<D>, pose: &Pose<D>, n: usize) -> DMatrix<f64> {
    let anchors = model.anchors().positions();
    let u = isometry(anchors.len());
    let sigma = DVector::from_fn(anchors.len(), |m, _| variance(model, pose, m, n));
    let a = DMatrix::from_fn(anchors.len(), D, |m, i| -2.0 * anchors[m][i]);
    let l = (u.transpose() * DMatrix::from_diagonal(&sigma) * &u).cholesky().expect("positive definite").l();
    l.solve_lower_triangular(&(u.transpose() * a)).expect("positive definite")
}

/// `C_e = [C; 1^T]`.
pub fn extended<const D: usize>(model: &RangeModel<D>) -> DMatrix<f64> {
    let sensors = model.topology().sensors();
    DMatrix::from_fn(D + 1, sensors.len(), |i, n| if i < D { sensors[n][i] } else { 1.0 })
}

/// The whitened and stacked `H` of \[L\] eq. 39, every sensor with the variances of the sensor that `whom` names for it.
pub fn stacked<const D: usize>(
    model: &RangeModel<D>,
    pose: &Pose<D>,
    whom: impl Fn(usize) -> usize,
) -> DMatrix<f64> {
    let (c, rows) = (extended(model), model.anchors().len() - 1);
    let mut h = DMatrix::zeros(rows * c.ncols(), D * (D + 1));
    for n in 0..c.ncols() {
        let block = c.column(n).transpose().kronecker(&whitened_anchors(model, pose, whom(n)));
        h.rows_mut(n * rows, rows).copy_from(&block);
    }
    h
}

/// The whitened and stacked derivative of the squared ranges themselves, `2 c_e^T (x) (s_n - a_m)^T`.
pub fn stacked_raw<const D: usize>(model: &RangeModel<D>, pose: &Pose<D>) -> DMatrix<f64> {
    let (c, anchors) = (extended(model), model.anchors().positions());
    DMatrix::from_fn(anchors.len() * c.ncols(), D * (D + 1), |row, entry| {
        let (m, n) = (row % anchors.len(), row / anchors.len());
        let lever = pose.act(&model.topology().sensors()[n]) - anchors[m];
        2.0 * c[(entry / D, n)] * lever[entry % D] / variance(model, pose, m, n).sqrt()
    })
}

/// `U` of \[L\] eq. 47; in the plane its one column for `Q` is `[-q_2; q_1]`.
pub fn tangent_basis<const D: usize>(pose: &Pose<D>) -> DMatrix<f64> {
    let q = pose.rotation.matrix();
    let angles = D * (D - 1) / 2;
    let mut u = DMatrix::zeros(D * (D + 1), angles + D);
    let mut put = |block: usize, column: usize, sign: f64, from: usize| {
        for i in 0..D {
            u[(block * D + i, column)] = sign * q[(i, from)] / 2.0_f64.sqrt();
        }
    };
    if D == 2 {
        put(0, 0, -1.0, 1);
        put(1, 0, 1.0, 0);
    } else {
        for (block, column, sign, from) in [
            (0, 0, -1.0, 2),
            (2, 0, 1.0, 0),
            (1, 1, -1.0, 2),
            (2, 1, 1.0, 1),
            (0, 2, 1.0, 1),
            (1, 2, -1.0, 0),
        ] {
            put(block, column, sign, from);
        }
    }
    for i in 0..D {
        u[(D * D + i, angles + i)] = 1.0;
    }
    u
}

/// Largest difference of the entries, relative to the largest entry of `b`.
pub fn difference(a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
    (a - b).amax() / b.amax()
}

/// The eigenvalues of `b` in the metric of the positive definite `a`: all at most 1 if and only if `b <= a`.
pub fn order(b: &DMatrix<f64>, a: &DMatrix<f64>) -> DVector<f64> {
    let l = a.clone().cholesky().expect("positive definite").l();
    let half = l.solve_lower_triangular(b).unwrap();
    let both = l.solve_lower_triangular(&half.transpose()).unwrap();
    SymmetricEigen::new((&both + both.transpose()) * 0.5).eigenvalues
}
