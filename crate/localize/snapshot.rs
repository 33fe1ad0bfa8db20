//! One epoch's ranges as the snapshot estimators read them.

use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};

use crate::error::{Error, Result};
use crate::math::linalg::{add_outer, spd_inverse};
use crate::math::pose::Theta;
use crate::math::singular::{Singular, singular};
use crate::model::lack::{Parameters, shortfall};
use crate::model::ranges::Ranges;
use crate::model::ranging::{RangeForm, RangeModel};
use crate::model::sensor_equations::SensorEquations;

/// Where knowing nothing of the other coordinates costs more than this factor in the variance of one, a matrix is singular
/// within double precision.
const MAX_INFLATION: f64 = 1e12;

/// Second moments of the sensors below this part of the largest are rounding.
const MIN_MOMENT: f64 = 1e-12;

/// The normal equations of each sensor about the centroid of the anchors, and the body about its own: the papers'
/// `R = Abar^T Abar` and `B = Abar^T Dbar`, column by column.
#[derive(Clone, Debug)]
pub struct Snapshot<'a, const D: usize> {
    /// Anchors, topology and noise.
    pub model: &'a RangeModel<D>,
    /// The ranges.
    pub ranges: &'a Ranges,
    /// The ranges that give the weights.
    pub weight_ranges: &'a Ranges,
    /// One for each sensor.
    pub equations: Vec<SensorEquations<D>>,
    /// All sensors share `R`: weights are common and no range is missing.
    pub shared: bool,
    /// The sensors about their centroid, m.
    pub levers: Vec<SVector<f64, D>>,
    /// Their centroid in the body frame, m.
    pub centre: SVector<f64, D>,
    /// The place that the equations are about: the centroid of the anchors, m.
    pub place: SVector<f64, D>,
    /// Principal axes and moments of the sensors about their centroid, m^2.
    pub moments: Singular<D>,
    /// `C C^T` about the centroid, m^2.
    pub gram: SMatrix<f64, D, D>,
}

impl<'a, const D: usize> Snapshot<'a, D> {
    /// Reads the ranges of one epoch.
    ///
    /// # Errors
    /// [`Error::Size`] where the ranges do not match anchors and sensors, [`Error::Number`] where the sums overflow.
    pub fn new(model: &'a RangeModel<D>, ranges: &'a Ranges, weight_ranges: &'a Ranges) -> Result<Self> {
        let mean = |points: &[SVector<f64, D>]| points.iter().sum::<SVector<f64, D>>() / points.len() as f64;
        let place = mean(model.anchors().positions());
        let centre = mean(model.topology().sensors());
        let levers: Vec<_> = model.topology().sensors().iter().map(|c| c - centre).collect();
        let mut gram = SMatrix::zeros();
        for c in &levers {
            add_outer(&mut gram, 1.0, c, c);
        }
        let mut equations = Vec::with_capacity(levers.len());
        let shared =
            model.sensor_equations(ranges, weight_ranges, RangeForm::Projected, |_| place, &mut equations)?;
        let moments = singular(&gram);
        Ok(Self { model, ranges, weight_ranges, equations, shared, levers, centre, place, moments, gram })
    }

    /// Number of ranges.
    pub fn range_count(&self) -> usize {
        self.ranges.anchors() * self.ranges.sensors() - self.ranges.missing()
    }

    /// In how many directions the sensors extend.
    pub fn sensor_rank(&self) -> usize {
        let floor = MIN_MOMENT * self.moments.values[0];
        self.moments.values.iter().filter(|&&x| x > floor).count()
    }

    /// The position of one sensor from its own ranges (\[L\] eq. 8), m; `None` where they do not show it.
    pub fn sensor_position(&self, n: usize) -> Option<SVector<f64, D>> {
        let equations = &self.equations[n];
        inverse(&equations.gram).map(|inverse| self.place + inverse * equations.vector)
    }

    /// `[Q | t]` of the body frame from that of the sensors' centroid.
    pub(super) fn in_body_frame(
        &self,
        orientation: SMatrix<f64, D, D>,
        centroid: SVector<f64, D>,
    ) -> Theta<D> {
        Theta { orientation, position: centroid - orientation * self.centre }
    }

    /// The typed error of an estimator that the ranges do not suffice for.
    pub(super) fn unobservable(&self, what: &'static str, form: RangeForm, parameters: Parameters) -> Error {
        let ranges = self.range_count();
        let reason = shortfall(self.model, ranges, form, parameters).map_or_else(
            || "The ranges tell some motion of the body from no motion only within rounding.".into(),
            |reason| reason.sentence,
        );
        Error::Unobservable { what, ranges, reason }
    }
}

/// The inverse of an information matrix that carries digits.
pub(super) fn inverse<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Option<SMatrix<f64, D, D>> {
    let inverse = spd_inverse(matrix).ok()?;
    let carries = |i: usize| matrix[(i, i)] * inverse[(i, i)] < MAX_INFLATION;
    (0..D).all(carries).then_some(inverse)
}
