//! The papers' own route, kept as slow and literal as they print it: project out `||s||^2` with an isometry `U_M`, whiten,
//! stack `H = C_e^T (x) Abar`, and run the Kalman filter in gain form on matrices as long as the data.

use nalgebra::{DMatrix, DVector};
use rangelab::model::noise::RangeNoise;
use rangelab::model::ranges::Ranges;
use rangelab::model::ranging::{RangeModel, Weighting};

/// White linear measurements `z = H theta + noise`, unit covariance.
pub struct Measurements {
    pub matrix: DMatrix<f64>,
    pub values: DVector<f64>,
}

/// An isometry whose columns span the complement of the vector of ones (Householder's reflection without its first column).
pub fn isometry(rows: usize) -> DMatrix<f64> {
    let mut v = DVector::from_element(rows, 1.0 / (rows as f64).sqrt());
    v[0] -= 1.0;
    let squared = v.norm_squared();
    let reflection = if squared == 0.0 {
        DMatrix::identity(rows, rows)
    } else {
        DMatrix::identity(rows, rows) - &v * v.transpose() * (2.0 / squared)
    };
    reflection.columns(1, rows - 1).into_owned()
}

/// Variance of the squared range of a pair: its own ([`Weighting::PerPair`]), or that of the anchor's first sensor.
pub fn variance(noise: &RangeNoise, weighting: Weighting, weight_ranges: &Ranges, m: usize, n: usize) -> f64 {
    let squared_range = match weighting {
        Weighting::PerPair => weight_ranges.get(m, n),
        Weighting::Common => (0..weight_ranges.sensors()).find_map(|n| weight_ranges.get(m, n)),
    };
    noise.squared_range_variance(squared_range.unwrap())
}

/// \[T\] eq. (4) to (8), sensor by sensor, rows of missing ranges deleted.
pub fn measurements<const D: usize>(
    model: &RangeModel<D>,
    ranges: &Ranges,
    weight_ranges: &Ranges,
) -> Measurements {
    let size = D * (D + 1);
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for n in 0..ranges.sensors() {
        let present: Vec<usize> = (0..ranges.anchors()).filter(|&m| ranges.get(m, n).is_some()).collect();
        if present.len() < 2 {
            continue;
        }
        let u = isometry(present.len());
        let variances = DVector::from_fn(present.len(), |k, _| {
            variance(model.noise(), model.weighting(), weight_ranges, present[k], n)
        });
        let whiten = (u.transpose() * DMatrix::from_diagonal(&variances) * &u)
            .cholesky()
            .unwrap()
            .l()
            .try_inverse()
            .unwrap();
        let positions = DMatrix::from_fn(present.len(), D, |k, i| model.anchors().positions()[present[k]][i]);
        let data = DVector::from_fn(present.len(), |k, _| {
            ranges.get(present[k], n).unwrap() - model.anchors().positions()[present[k]].norm_squared()
        });
        let anchors_white = &whiten * u.transpose() * positions * -2.0;
        let c = model.topology().sensors()[n];
        let extended = DMatrix::from_fn(1, D + 1, |_, j| if j < D { c[j] } else { 1.0 });
        rows.push(extended.kronecker(&anchors_white));
        values.push(whiten * u.transpose() * data);
    }
    stack(size, &rows, &values)
}

fn stack(size: usize, rows: &[DMatrix<f64>], values: &[DVector<f64>]) -> Measurements {
    let count = rows.iter().map(DMatrix::nrows).sum();
    let mut result = Measurements { matrix: DMatrix::zeros(count, size), values: DVector::zeros(count) };
    let mut first = 0;
    for (block, data) in rows.iter().zip(values) {
        result.matrix.view_mut((first, 0), block.shape()).copy_from(block);
        result.values.rows_mut(first, data.len()).copy_from(data);
        first += data.len();
    }
    result
}

/// Estimate and covariance of the plain Kalman filter of \[T\] Sec. IV-A.
pub struct KalmanState {
    pub theta: DVector<f64>,
    pub covariance: DMatrix<f64>,
}

impl KalmanState {
    /// \[T\] eq. (17): `theta <- F theta + u`, `P <- F P F^T + M`, all `D(D+1)` square.
    pub fn predict(&mut self, transition: &DMatrix<f64>, input: &DVector<f64>, noise: &DMatrix<f64>) {
        self.theta = transition * &self.theta + input;
        self.covariance = transition * &self.covariance * transition.transpose() + noise;
    }

    /// \[T\] eq. (19) to (22) with the symmetric (Joseph) form of the covariance; returns the normalized innovation squared.
    pub fn update(&mut self, measured: &Measurements) -> f64 {
        let h = &measured.matrix;
        let identity = DMatrix::identity(h.nrows(), h.nrows());
        let spread = h * &self.covariance * h.transpose() + &identity;
        let inverse = spread.cholesky().unwrap().inverse();
        let gain = &self.covariance * h.transpose() * &inverse;
        let innovation = &measured.values - h * &self.theta;
        self.theta += &gain * &innovation;
        let keep = DMatrix::identity(self.theta.len(), self.theta.len()) - &gain * h;
        self.covariance = &keep * &self.covariance * keep.transpose() + &gain * gain.transpose();
        innovation.dot(&(inverse * &innovation))
    }
}
