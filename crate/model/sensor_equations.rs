//! What the ranges say about each sensor's own position, before anything is known of the body.

use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};

use super::ranges::Ranges;
use super::ranging::{RangeForm, RangeModel, Weighting};
use crate::error::{Error, Result};
use crate::math::linalg::add_outer;

/// Squared ranges shorter than this part of the longest get no more weight than it: at zeta = 0 dB a range measured near
/// zero would outweigh all others, and `R` would be singular within double precision.
const WEIGHT_FLOOR: f64 = 1e-3;

/// Normal equations of one sensor about a place in the world: `R (s - place) = b`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorEquations<const D: usize> {
    /// `R = 4 sum_m w_m (a_m - z)(a_m - z)^T`, 1/m^2.
    pub gram: SMatrix<f64, D, D>,
    /// `b = -2 sum_m w_m (a_m - z)(e_m - e)`, 1/m.
    pub vector: SVector<f64, D>,
    /// `sum_m w_m (e_m - e)^2` at the place.
    pub energy: f64,
    /// `e`, m^2; 0 in the raw form.
    pub offset: f64,
    /// `z` from the place, m; 0 in the raw form.
    pub centre: SVector<f64, D>,
    /// Number of ranges.
    pub ranges: usize,
}

impl<const D: usize> RangeModel<D> {
    /// Fills the equations of all sensors, each about its own place; true where all share `R`.
    ///
    /// `z` and `e` are the weighted means of anchors and residuals, in the raw form the place itself and 0, as in
    /// [`RangeModel::normal_equations`], which is the sum of these over the sensors. Only the floor under the weights is
    /// added.
    ///
    /// # Errors
    /// [`Error::Size`] where ranges do not match anchors and sensors, [`Error::Number`] where the sums overflow.
    pub fn sensor_equations(
        &self,
        ranges: &Ranges,
        weight_ranges: &Ranges,
        form: RangeForm,
        place: impl Fn(usize) -> SVector<f64, D>,
        equations: &mut Vec<SensorEquations<D>>,
    ) -> Result<bool> {
        self.check_size(ranges)?;
        self.check_size(weight_ranges)?;
        let longest = (0..weight_ranges.sensors()).flat_map(|n| weight_ranges.of_sensor(n));
        let floor = WEIGHT_FLOOR * longest.fold(0.0, |most: f64, &d| most.max(d));
        let common = self.weighting() == Weighting::Common;
        let law = self.noise().law();
        equations.clear();
        for n in 0..ranges.sensors() {
            let weight = |m: usize| {
                let squared = if common { first_range(weight_ranges, m) } else { weight_ranges.get(m, n) };
                squared.map(|d| 1.0 / law.variance(d.max(floor)))
            };
            equations.push(self.equations_of(ranges.of_sensor(n), weight, form, &place(n)));
        }
        let finite = |e: &SensorEquations<D>| e.energy.is_finite() && e.gram.iter().all(|x| x.is_finite());
        if let Some(found) = equations.iter().find(|e| !finite(e)) {
            return Err(Error::Number {
                what: "the weighted sum of squared residuals of a sensor",
                value: found.energy,
                limit: "finite: noise and ranges must not differ by hundreds of orders of magnitude",
            });
        }
        let complete = ranges.missing() == 0 && weight_ranges.missing() == 0;
        Ok(common && complete && form == RangeForm::Projected)
    }

    fn equations_of(
        &self,
        squared_ranges: &[f64],
        weight: impl Fn(usize) -> Option<f64>,
        form: RangeForm,
        place: &SVector<f64, D>,
    ) -> SensorEquations<D> {
        let pairs = || {
            let anchors = self.anchors().positions().iter().zip(squared_ranges).enumerate();
            anchors.filter(|(_, (_, d))| !d.is_nan()).filter_map(|(m, (a, &d))| {
                let lever = a - place;
                Some((lever, d - lever.norm_squared(), weight(m)?))
            })
        };
        let (mut total, mut centre, mut offset, mut ranges) = (0.0, SVector::zeros(), 0.0, 0);
        for (lever, residual, w) in pairs() {
            total += w;
            centre += lever * w;
            offset += w * residual;
            ranges += 1;
        }
        if form == RangeForm::Raw || ranges == 0 {
            (centre, offset) = (SVector::zeros(), 0.0);
        } else {
            (centre, offset) = (centre / total, offset / total);
        }
        let (mut gram, mut vector, mut energy) = (SMatrix::zeros(), SVector::zeros(), 0.0);
        for (lever, residual, w) in pairs() {
            let (lever, residual) = (lever - centre, residual - offset);
            add_outer(&mut gram, 4.0 * w, &lever, &lever);
            vector -= lever * (2.0 * w * residual);
            energy += w * residual * residual;
        }
        SensorEquations { gram, vector, energy, offset, centre, ranges }
    }
}

/// The squared range from an anchor to the first sensor that has one.
fn first_range(ranges: &Ranges, m: usize) -> Option<f64> {
    (0..ranges.sensors()).find_map(|n| ranges.get(m, n))
}
