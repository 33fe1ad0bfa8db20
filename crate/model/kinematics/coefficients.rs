//! Positions, velocities, accelerations and so on of all nodes at time 0.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use crate::error::{Error, Result};

/// `Y_0, ..., Y_L`, each D x N: `X(t) = sum_l Y_l t^l/l!` (\[A\] eq. 4a), m/s^l.
#[derive(Clone, Debug, PartialEq)]
pub struct RelativeKinematics {
    coefficients: Vec<DMatrix<f64>>,
}

impl RelativeKinematics {
    /// Coefficients of one shape.
    ///
    /// # Errors
    /// [`Error::Size`] where there is none or their shapes differ, [`Error::Number`] where one is not finite.
    ///
    /// ```
    /// use nalgebra::dmatrix;
    /// use rangelab::model::kinematics::coefficients::RelativeKinematics;
    /// let motion = RelativeKinematics::new(vec![dmatrix![0.0, 2.0; 0.0, 4.0], dmatrix![1.0, 0.0; 0.0, 0.0]])?;
    /// assert_eq!((motion.dimension(), motion.nodes(), motion.degree()), (2, 2, 1));
    /// assert_eq!(motion.positions(3.0), dmatrix![3.0, 2.0; 0.0, 4.0]);
    /// assert_eq!(motion.centred().coefficient(0), &dmatrix![-1.0, 1.0; -2.0, 2.0]);
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn new(coefficients: Vec<DMatrix<f64>>) -> Result<Self> {
        let Some(first) = coefficients.first() else {
            return Err(Error::Size { what: "coefficients of the motion", found: 0, expected: 1 });
        };
        let expected = first.shape();
        if let Some(other) = coefficients.iter().find(|each| each.shape() != expected) {
            let what = "entries of a coefficient of the motion";
            return Err(Error::Size { what, found: other.len(), expected: expected.0 * expected.1 });
        }
        if let Some(&value) = coefficients.iter().flatten().find(|value| !value.is_finite()) {
            return Err(Error::Number { what: "a coefficient of the motion", value, limit: "finite" });
        }
        Ok(Self { coefficients })
    }

    /// Coefficients that are known to have one shape.
    pub(crate) fn from_coefficients(coefficients: Vec<DMatrix<f64>>) -> Self {
        Self { coefficients }
    }

    /// D.
    pub fn dimension(&self) -> usize {
        self.coefficients[0].nrows()
    }

    /// N.
    pub fn nodes(&self) -> usize {
        self.coefficients[0].ncols()
    }

    /// L.
    pub fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// `Y_l`, D x N.
    pub fn coefficient(&self, l: usize) -> &DMatrix<f64> {
        &self.coefficients[l]
    }

    /// `Y_0, ..., Y_L`.
    pub fn coefficients(&self) -> &[DMatrix<f64>] {
        &self.coefficients
    }

    /// `X(t)`, D x N, m.
    pub fn positions(&self, time: f64) -> DMatrix<f64> {
        self.derivative(0, time)
    }

    /// `d^order X/dt^order`, D x N: velocities for 1, accelerations for 2 (\[A\] eq. 4b, whose sum ends at L).
    pub fn derivative(&self, order: usize, time: f64) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(self.dimension(), self.nodes());
        // Horner: each power of time comes with its factorial.
        for l in (order..=self.degree()).rev() {
            sum *= time / (l - order + 1) as f64;
            sum += &self.coefficients[l];
        }
        sum
    }

    /// Each coefficient less the mean over the nodes, `Y_l C` with `C = I - 1 1^T/N`.
    #[must_use]
    pub fn centred(&self) -> Self {
        Self { coefficients: self.coefficients.iter().map(centred_columns).collect() }
    }

    /// `Q Y_l` for every l, `Q` D x D.
    #[must_use]
    pub fn rotated(&self, q: &DMatrix<f64>) -> Self {
        Self { coefficients: self.coefficients.iter().map(|each| q * each).collect() }
    }

    /// `B_l = sum_m Y_m^T Y_(l-m)/(m! (l-m)!)` for l = 0 to 2L (\[A\] eq. 7): `X(t)^T X(t) = sum_l B_l t^l`, N x N, m^2/s^l.
    pub fn gram(&self) -> Vec<DMatrix<f64>> {
        let mut factorial = 1.0;
        let mut powers = Vec::with_capacity(self.coefficients.len());
        for (l, coefficient) in self.coefficients.iter().enumerate() {
            factorial *= l.max(1) as f64;
            powers.push(coefficient / factorial);
        }
        let of_power = |l: usize| {
            let terms = l.saturating_sub(self.degree())..=l.min(self.degree());
            let zero = DMatrix::zeros(self.nodes(), self.nodes());
            terms.fold(zero, |sum, m| sum + powers[m].transpose() * &powers[l - m])
        };
        (0..=2 * self.degree()).map(of_power).collect()
    }

    /// Up to `degree`, coefficients beyond L being zero.
    #[must_use]
    pub fn with_degree(&self, degree: usize) -> Self {
        let mut coefficients = self.coefficients.clone();
        coefficients.resize(degree + 1, DMatrix::zeros(self.dimension(), self.nodes()));
        Self { coefficients }
    }
}

/// A D x N matrix less the mean of its columns.
pub fn centred_columns(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let mean: DVector<f64> = matrix.column_sum() / matrix.ncols() as f64;
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] - mean[i])
}

/// Squared distance between two columns of a D x N matrix.
pub fn squared_distance(matrix: &DMatrix<f64>, i: usize, j: usize) -> f64 {
    // Without a vector of its own: it is asked for at each stamp, for each pair.
    let square = |(a, b): (&f64, &f64)| (a - b) * (a - b);
    matrix.column(i).iter().zip(&matrix.column(j)).map(square).sum()
}
