//! The linear model with the position eliminated: a quadratic cost of the orientation alone.

use nalgebra::{SMatrix, SVector};

use super::snapshot::{Snapshot, inverse};
use crate::error::Result;
use crate::math::block::BlockMatrix;
use crate::math::linalg::spd_inverse;
use crate::math::pose::Theta;
use crate::math::quadratic::{Kronecker, Metric};
use crate::math::singular::singular;
use crate::model::lack::Parameters;
use crate::model::ranging::RangeForm;
use crate::model::sensor_equations::SensorEquations;

/// Entries of `vec(Q)` in space; in the plane the first 4 are used.
pub(super) const ENTRIES: usize = 9;

/// Directions of `vec(Q)` below this part of the best seen one are rounding.
const MIN_PART: f64 = 1e-12;

/// `W` of the cost `(q - q_LS)^T W (q - q_LS)`.
#[allow(clippy::large_enum_variant, reason = "both live on the stack, for the time of one estimate")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ReducedMetric<const D: usize> {
    /// `(C C^T) (x) R`: all sensors share `R`.
    Shared(Kronecker<D>),
    /// Any other.
    Full(BlockMatrix<D>),
}

impl<const D: usize> Metric<D> for ReducedMetric<D> {
    #[inline]
    fn apply(&self, x: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
        match self {
            Self::Shared(metric) => metric.apply(x),
            Self::Full(metric) => metric.apply(x),
        }
    }
}

impl<const D: usize> ReducedMetric<D> {
    /// The metric entry by entry, zero for `t`.
    pub fn to_blocks(&self) -> BlockMatrix<D> {
        match self {
            Self::Shared(Kronecker { anchors, sensors }) => {
                let mut blocks = BlockMatrix::zeros();
                let of_columns = |i: usize, j: usize| if i < D && j < D { sensors[(i, j)] } else { 0.0 };
                blocks.add_kronecker(of_columns, anchors);
                blocks
            }
            Self::Full(blocks) => *blocks,
        }
    }
}

/// The cost of an orientation, `residual + (q - q_LS)^T W (q - q_LS)`, with the position that suits it best; in the frame of
/// the sensors' centroid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduced<const D: usize> {
    /// `W`.
    pub metric: ReducedMetric<D>,
    /// `Q_LS`, the matrix of least cost; the smallest of them where there are many.
    pub target: SMatrix<f64, D, D>,
    /// It is the only one.
    pub unique: bool,
    /// `W q_LS`.
    pub weighted: SMatrix<f64, D, D>,
    /// The least cost of all.
    pub residual: f64,
    /// The position of the centroid for `Q_LS`, m.
    centroid: SVector<f64, D>,
    /// The centroid moves by their products with the columns of the change of `Q`.
    gain: [SMatrix<f64, D, D>; D],
}

impl<const D: usize> Reduced<D> {
    /// The position of the centroid that suits an orientation best, m.
    pub fn centroid(&self, orientation: &SMatrix<f64, D, D>) -> SVector<f64, D> {
        let change = orientation - self.target;
        (0..D).fold(self.centroid, |centroid, j| centroid + self.gain[j] * change.column(j))
    }
}

impl<const D: usize> Snapshot<'_, D> {
    /// The quadratic cost of \[L\] eq. 22 (`mounting_sigma` 0) or 34.
    ///
    /// Mounting errors of `sigma_e` in each coordinate make of the information about a sensor's place
    /// `R (sigma_e^2 R + I)^-1 = (R^-1 + sigma_e^2 I)^-1`, which is all that total least squares change:
    /// `Lambda = sigma_e^2 Abar Abar^T + I` is that in the space of the ranges.
    ///
    /// # Errors
    /// [`crate::Error::Unobservable`] where the ranges do not show the position.
    pub fn reduced(&self, what: &'static str, mounting_sigma: f64) -> Result<Reduced<D>> {
        let discount = mounting_sigma * mounting_sigma;
        let found = if self.shared { self.shared(discount) } else { self.full(discount) };
        let mut reduced =
            found.ok_or_else(|| self.unobservable(what, RangeForm::Projected, Parameters::Sensors))?;
        reduced.residual = self.residual(&reduced, discount);
        Ok(reduced)
    }

    fn shared(&self, discount: f64) -> Option<Reduced<D>> {
        let gram = self.equations.first()?.gram;
        let covariance = inverse(&gram)?;
        let (anchors, factor) = discounted(&gram, discount)?;
        let (mut sum, mut moment) = (SVector::zeros(), SMatrix::<f64, D, D>::zeros());
        for (equations, lever) in self.equations.iter().zip(&self.levers) {
            sum += equations.vector;
            moment += equations.vector * lever.transpose();
        }
        let unique = self.sensor_rank() == D;
        Some(Reduced {
            metric: ReducedMetric::Shared(Kronecker { anchors, sensors: self.gram }),
            target: covariance * moment * self.inverse_gram(unique),
            unique,
            weighted: factor * moment,
            residual: 0.0,
            centroid: self.place + covariance * sum / self.levers.len() as f64,
            gain: [SMatrix::zeros(); D],
        })
    }

    /// `(C C^T)^-1`, the Moore-Penrose inverse where the body is flat.
    fn inverse_gram(&self, unique: bool) -> SMatrix<f64, D, D> {
        if unique && let Ok(inverse) = spd_inverse(&self.gram) {
            return inverse;
        }
        let mut result = SMatrix::zeros();
        for k in 0..self.sensor_rank() {
            let axis = self.moments.right.column(k);
            result += axis * axis.transpose() / self.moments.values[k];
        }
        result
    }

    fn full(&self, discount: f64) -> Option<Reduced<D>> {
        let mut information = BlockMatrix::zeros();
        let mut innovation = Theta::<D>::zeros();
        for (equations, lever) in self.equations.iter().zip(&self.levers) {
            let (gram, factor) = discounted(&equations.gram, discount)?;
            let extended = |i: usize| if i < D { lever[i] } else { 1.0 };
            information.add_kronecker(|i, j| extended(i) * extended(j), &gram);
            let vector = factor * equations.vector;
            (0..=D).for_each(|j| innovation.add_to_column(j, &(vector * extended(j))));
        }
        let covariance = inverse(&information.position_block())?;
        let gain = core::array::from_fn(|j| -(covariance * information.block(D, j)));
        let mut metric = BlockMatrix::zeros();
        let mut weighted = innovation.orientation;
        for i in 0..D {
            for j in 0..=i {
                metric.set_block(i, j, &(information.block(i, j) + information.block(i, D) * gain[j]));
            }
            let column = weighted.column(i) + gain[i].transpose() * innovation.position;
            weighted.set_column(i, &column);
        }
        let (target, unique) = minimum(&metric, &weighted);
        let mut centroid = self.place + covariance * innovation.position;
        for j in 0..D {
            centroid += gain[j] * target.column(j);
        }
        Some(Reduced {
            metric: ReducedMetric::Full(metric),
            target,
            unique,
            weighted,
            residual: 0.0,
            centroid,
            gain,
        })
    }

    /// The least cost: how far the sensors, each by itself, are from their own ranges and from the body.
    fn residual(&self, reduced: &Reduced<D>, discount: f64) -> f64 {
        let mut sum = 0.0;
        for (equations, lever) in self.equations.iter().zip(&self.levers) {
            let place = reduced.target * lever + reduced.centroid - self.place;
            sum += residual_at(equations, &place, discount).max(0.0);
        }
        sum
    }
}

/// What a sensor's ranges cost at a place (from the place that the equations are about).
fn residual_at<const D: usize>(
    equations: &SensorEquations<D>,
    place: &SVector<f64, D>,
    discount: f64,
) -> f64 {
    let Some(covariance) = inverse(&equations.gram) else {
        return equations.energy - place.dot(&(equations.vector * 2.0 - equations.gram * place));
    };
    let own = covariance * equations.vector;
    let off = own - place;
    let gram = discounted(&equations.gram, discount).map_or(equations.gram, |(gram, _)| gram);
    (equations.energy - own.dot(&equations.vector)).max(0.0) + off.dot(&(gram * off))
}

/// `(R^-1 + discount I)^-1` and the factor `(discount R + I)^-1` that makes it of `R`.
fn discounted<const D: usize>(
    gram: &SMatrix<f64, D, D>,
    discount: f64,
) -> Option<(SMatrix<f64, D, D>, SMatrix<f64, D, D>)> {
    if discount == 0.0 {
        return Some((*gram, SMatrix::identity()));
    }
    let factor = spd_inverse(&(gram * discount + SMatrix::identity())).ok()?;
    let product = factor * gram;
    Some(((product + product.transpose()) * 0.5, factor))
}

/// The smallest `q` with `W q = weighted`, and whether it is the only one.
fn minimum<const D: usize>(
    metric: &BlockMatrix<D>,
    weighted: &SMatrix<f64, D, D>,
) -> (SMatrix<f64, D, D>, bool) {
    let s = singular(&padded(metric));
    let used = D * D;
    let right = |k: usize| SMatrix::<f64, D, D>::from_fn(|i, j| s.right[(j * D + i, k)]);
    let largest = s.values[ENTRIES - used];
    let mut target = SMatrix::zeros();
    let mut unique = true;
    for k in ENTRIES - used..ENTRIES {
        if s.values[k] > MIN_PART * largest {
            target += right(k) * (right(k).dot(weighted) / s.values[k]);
        } else {
            unique = false;
        }
    }
    (target, unique)
}

/// `W` on 9 entries; unused ones (D = 2) carry its trace, so that they come first among its singular values.
pub(super) fn padded<const D: usize>(metric: &BlockMatrix<D>) -> SMatrix<f64, ENTRIES, ENTRIES> {
    let used = D * D;
    let trace = metric.orientation_trace();
    SMatrix::from_fn(|i, j| match (i < used && j < used, i == j) {
        (true, _) => metric.entry(i, j),
        (false, true) => 2.0 * trace,
        (false, false) => 0.0,
    })
}
