//! Ranges become normal equations, O(M N) once, constant size ever after.

use alloc::vec::Vec;

use nalgebra::SMatrix;
use serde::{Deserialize, Serialize};

use super::accumulate::{RangeBuffer, Sum};
use super::anchors::Anchors;
use super::availability::Availability;
use super::noise::{RangeNoise, VarianceLaw};
use super::normal_equations::{Information, NormalEquations};
use super::ranges::Ranges;
use super::topology::Topology;
use crate::error::{Error, Result};
use crate::math::block::BlockMatrix;
use crate::math::pose::{Pose, Theta};

/// Which squared range gives a pair its weight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "snake_case")]
pub enum Weighting {
    /// The papers': all sensors take the variance of the first sensor's range to the anchor.
    #[default]
    Common,
    /// Each pair by its own range.
    PerPair,
}

/// What is done with the unknown `||s_n||^2` in the squared ranges of a sensor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "snake_case")]
pub enum RangeForm {
    /// It is projected out (\[T\] eq. 5): linear in `theta`, at the cost of one range for each sensor.
    #[default]
    Projected,
    /// The squared ranges are used as they are, linearized at the reference: they also see the direction normal to
    /// coplanar anchors.
    Raw,
}

/// Anchors, topology and noise: all that is needed to read ranges.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeModel<const D: usize> {
    anchors: Anchors<D>,
    topology: Topology<D>,
    noise: RangeNoise,
    weighting: Weighting,
}

impl<const D: usize> RangeModel<D> {
    /// Joins the parts.
    ///
    /// # Errors
    /// [`Error::Number`] for noise that is not positive.
    pub fn new(
        anchors: Anchors<D>,
        topology: Topology<D>,
        noise: RangeNoise,
        weighting: Weighting,
    ) -> Result<Self> {
        noise.check()?;
        Ok(Self { anchors, topology, noise, weighting })
    }

    /// The same with the noise of each pair: bounds take over no simplification of the weights.
    #[must_use]
    pub fn per_pair(&self) -> Self {
        Self { weighting: Weighting::PerPair, ..self.clone() }
    }

    /// The anchors.
    pub fn anchors(&self) -> &Anchors<D> {
        &self.anchors
    }

    /// The sensors.
    pub fn topology(&self) -> &Topology<D> {
        &self.topology
    }

    /// The noise.
    pub fn noise(&self) -> &RangeNoise {
        &self.noise
    }

    /// Whether the sensors share the weights of an anchor.
    pub fn weighting(&self) -> Weighting {
        self.weighting
    }

    /// The noise-free squared ranges at `[Q | t]`.
    pub fn exact_ranges(&self, theta: &Theta<D>) -> Result<Ranges> {
        Ranges::from_fn(self.anchors.len(), self.topology.len(), |m, n| {
            let sensor_in_world = theta.orientation * self.topology.sensors()[n] + theta.position;
            Some((self.anchors.positions()[m] - sensor_in_world).norm_squared())
        })
    }

    /// Which pairs can be measured at a pose, anchor by anchor, sensor by sensor.
    pub fn measurable(&self, pose: &Pose<D>, availability: &Availability<D>) -> Vec<bool> {
        let places: Vec<_> = self.topology.sensors().iter().map(|c| pose.act(c)).collect();
        let pairs = self.anchors.positions().iter().enumerate();
        pairs.flat_map(|(m, a)| places.iter().map(move |s| availability.allows(m, a, s))).collect()
    }

    /// The ranges that can be measured at a pose, each at its true value.
    ///
    /// # Errors
    /// [`Error::Number`] where a squared range overflows.
    pub fn measurable_ranges(&self, pose: &Pose<D>, availability: &Availability<D>) -> Result<Ranges> {
        let exact = self.exact_ranges(&Theta::from(*pose))?;
        if availability.is_unlimited() {
            return Ok(exact);
        }
        let (measurable, sensors) = (self.measurable(pose, availability), exact.sensors());
        let available = |m: usize, n: usize| exact.get(m, n).filter(|_| measurable[m * sensors + n]);
        Ranges::from_fn(exact.anchors(), sensors, available)
    }

    /// A buffer of the right size for [`RangeModel::normal_equations`].
    pub fn range_buffer(&self) -> RangeBuffer<D> {
        RangeBuffer::new(self.anchors.len())
    }

    /// Forms the normal equations of `ranges` about `reference`.
    ///
    /// `R_n = 4 sum_m w_mn (a_m - z_n)(a_m - z_n)^T`, `b_n = -2 sum_m w_mn (a_m - z_n)(e_mn - e_n)` with residuals
    /// `e_mn = d_mn - ||a_m - s_n||^2` at the reference. Projected: `z_n` and `e_n` are the weighted means of anchors
    /// and residuals. Raw: `z_n = s_n` and `e_n = 0`. `weight_ranges` give the variances: the measured ranges
    /// themselves, or the true ones. Missing ranges are left out, and ranges without one that gives their weight.
    ///
    /// # Errors
    /// [`Error::Size`] where the ranges do not match anchors and sensors, [`Error::Number`] where the sums overflow.
    pub fn normal_equations(
        &self,
        ranges: &Ranges,
        weight_ranges: &Ranges,
        reference: &Theta<D>,
        form: RangeForm,
        buffer: &mut RangeBuffer<D>,
    ) -> Result<NormalEquations<D>> {
        let mut normal = NormalEquations::empty();
        self.fill_normal_equations(ranges, weight_ranges, reference, form, buffer, &mut normal)?;
        Ok(normal)
    }

    /// [`RangeModel::normal_equations`] into a place that the caller keeps; after an error it is meaningless.
    pub(crate) fn fill_normal_equations(
        &self,
        ranges: &Ranges,
        weight_ranges: &Ranges,
        reference: &Theta<D>,
        form: RangeForm,
        buffer: &mut RangeBuffer<D>,
        normal: &mut NormalEquations<D>,
    ) -> Result<()> {
        self.check_size(ranges)?;
        self.check_size(weight_ranges)?;
        let common = self.weighting == Weighting::Common;
        if common {
            self.common_weights(weight_ranges, &mut buffer.weights);
        }
        let complete = ranges.missing() == 0 && weight_ranges.missing() == 0;
        let shared = common && form == RangeForm::Projected && complete;
        let mut sum = Sum::new(normal, shared);
        if shared {
            sum.set_shared(self.anchors.positions(), buffer);
        }
        for (n, c) in self.topology.sensors().iter().enumerate() {
            let sensor_in_world = reference.orientation * c + reference.position;
            if shared {
                sum.add_shared(c, &sensor_in_world, ranges.of_sensor(n), buffer);
                continue;
            }
            if !common {
                let law = self.noise.law();
                pair_weights(law, weight_ranges.of_sensor(n), &mut buffer.weights);
            }
            sum.add(c, &sensor_in_world, self.anchors.positions(), ranges.of_sensor(n), form, buffer);
        }
        if shared {
            normal.information = self.shared_information(&sum.gram);
        }
        if !(normal.energy.is_finite() && normal.innovation.is_finite()) {
            return Err(Error::Number {
                what: "the weighted sum of squared residuals",
                value: normal.energy,
                limit: "finite: noise, ranges and prior must not differ by hundreds of orders of magnitude",
            });
        }
        Ok(())
    }

    fn shared_information(&self, gram: &SMatrix<f64, D, D>) -> Information<D> {
        if self.topology.is_centred() {
            let (axes, moments) = (*self.topology.axes(), *self.topology.moments());
            Information::Decoupled { axes, gram: *gram, moments }
        } else {
            let mut matrix = BlockMatrix::zeros();
            matrix.add_kronecker(|i, j| self.topology.extended_gram(i, j), gram);
            Information::Full(matrix)
        }
    }

    pub(super) fn check_size(&self, ranges: &Ranges) -> Result<()> {
        for (what, found, expected) in [
            ("rows of ranges (one an anchor)", ranges.anchors(), self.anchors.len()),
            ("columns of ranges (one a sensor)", ranges.sensors(), self.topology.len()),
        ] {
            if found != expected {
                return Err(Error::Size { what, found, expected });
            }
        }
        Ok(())
    }

    /// One weight an anchor, from its range to the first sensor that has one.
    fn common_weights(&self, weight_ranges: &Ranges, weights: &mut [f64]) {
        let law = self.noise.law();
        pair_weights(law, weight_ranges.of_sensor(0), weights);
        if weight_ranges.missing() > 0 {
            for (m, weight) in weights.iter_mut().enumerate() {
                let first = (0..weight_ranges.sensors()).find_map(|n| weight_ranges.get(m, n));
                *weight = first.map_or(0.0, |d| 1.0 / law.variance(d));
            }
        }
    }
}

fn pair_weights(law: VarianceLaw, squared_ranges: &[f64], weights: &mut [f64]) {
    for (weight, &d) in weights.iter_mut().zip(squared_ranges) {
        *weight = if d.is_nan() { 0.0 } else { 1.0 / law.variance(d) };
    }
}
