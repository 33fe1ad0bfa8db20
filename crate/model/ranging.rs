//! Ranges become normal equations, O(M N) once, constant size ever after.

use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};
use serde::{Deserialize, Serialize};

use super::anchors::Anchors;
use super::noise::{RangeNoise, VarianceLaw};
use super::normal_equations::{Information, NormalEquations};
use super::ranges::Ranges;
use super::topology::Topology;
use crate::error::{Error, Result};
use crate::math::block::BlockMatrix;
use crate::math::linalg::add_outer;
use crate::math::pose::Theta;

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
    /// It is projected out ([T] eq. 5): linear in `theta`, at the cost of one range for each sensor.
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

/// Buffer for one weight an anchor, kept by the caller so that a step allocates nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WeightBuffer(Vec<f64>);

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

    /// A buffer of the right size for [`RangeModel::normal_equations`].
    pub fn weight_buffer(&self) -> WeightBuffer {
        WeightBuffer(Vec::with_capacity(self.anchors.len()))
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
        buffer: &mut WeightBuffer,
    ) -> Result<NormalEquations<D>> {
        self.check_size(ranges)?;
        self.check_size(weight_ranges)?;
        let common = self.weighting == Weighting::Common;
        if common {
            self.common_weights(weight_ranges, buffer);
        }
        let shared = common && form == RangeForm::Projected && ranges.missing() == 0;
        let mut sum = Sum::new();
        for n in 0..self.topology.len() {
            if !common {
                pair_weights(self.noise.law(), weight_ranges.of_sensor(n), buffer);
            }
            let c = &self.topology.sensors()[n];
            let sensor_in_world = reference.orientation * c + reference.position;
            let one = SensorSum::new(
                self.anchors.positions(),
                ranges.of_sensor(n),
                &buffer.0,
                &sensor_in_world,
                form,
            );
            sum.add(c, &one, !shared || n == 0, !shared);
        }
        self.finish(&sum, shared)
    }

    fn finish(&self, sum: &Sum<D>, shared: bool) -> Result<NormalEquations<D>> {
        if !(sum.energy.is_finite() && sum.innovation.is_finite()) {
            return Err(Error::Number {
                what: "the weighted sum of squared residuals",
                value: sum.energy,
                limit: "finite: noise, ranges and prior must not differ by hundreds of orders of magnitude",
            });
        }
        let information = match (shared, self.topology.is_centred()) {
            (true, true) => Information::Decoupled {
                axes: *self.topology.axes(),
                gram: sum.gram,
                moments: *self.topology.moments(),
            },
            (true, false) => Information::Full(kronecker(&self.topology, &sum.gram)),
            (false, _) => Information::Full(sum.information),
        };
        Ok(NormalEquations {
            information,
            innovation: sum.innovation,
            energy: sum.energy,
            ranges: sum.ranges,
            residuals: sum.residuals,
        })
    }

    fn check_size(&self, ranges: &Ranges) -> Result<()> {
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
    fn common_weights(&self, weight_ranges: &Ranges, buffer: &mut WeightBuffer) {
        let law = self.noise.law();
        pair_weights(law, weight_ranges.of_sensor(0), buffer);
        if weight_ranges.missing() > 0 {
            for (m, weight) in buffer.0.iter_mut().enumerate() {
                let first = (0..weight_ranges.sensors()).find_map(|n| weight_ranges.get(m, n));
                *weight = first.map_or(0.0, |d| 1.0 / law.variance(d));
            }
        }
    }
}

fn pair_weights(law: VarianceLaw, squared_ranges: &[f64], buffer: &mut WeightBuffer) {
    buffer.0.clear();
    buffer.0.extend(squared_ranges.iter().map(|&d| if d.is_nan() { 0.0 } else { 1.0 / law.variance(d) }));
}

/// The sums over the anchors for one sensor.
struct SensorSum<const D: usize> {
    gram: SMatrix<f64, D, D>,
    vector: SVector<f64, D>,
    energy: f64,
    ranges: usize,
    residuals: usize,
}

impl<const D: usize> SensorSum<D> {
    #[inline]
    fn new(
        anchors: &[SVector<f64, D>],
        squared_ranges: &[f64],
        weights: &[f64],
        sensor_in_world: &SVector<f64, D>,
        form: RangeForm,
    ) -> Self {
        let present = || anchors.iter().zip(squared_ranges).zip(weights).filter(|((_, d), _)| !d.is_nan());
        let residual = |a: &SVector<f64, D>, d: f64| d - (a - sensor_in_world).norm_squared();
        let (mut centre, mut offset, mut ranges) = (SVector::zeros(), 0.0, 0);
        let mut total = 0.0;
        for ((a, &d), &w) in present() {
            total += w;
            centre += a * w;
            offset += w * residual(a, d);
            ranges += usize::from(w > 0.0);
        }
        let mut residuals = ranges;
        if form == RangeForm::Raw || ranges == 0 {
            (centre, offset) = (*sensor_in_world, 0.0);
        } else {
            let inverse = 1.0 / total;
            (centre, offset) = (centre * inverse, offset * inverse);
            residuals -= 1;
        }
        let mut sum =
            Self { gram: SMatrix::zeros(), vector: SVector::zeros(), energy: 0.0, ranges, residuals };
        for ((a, &d), &w) in present() {
            let e = residual(a, d) - offset;
            let lever = a - centre;
            add_outer(&mut sum.gram, 4.0 * w, &lever, &lever);
            sum.vector -= lever * (2.0 * w * e);
            sum.energy += w * e * e;
        }
        sum
    }
}

/// The sums over the sensors.
struct Sum<const D: usize> {
    gram: SMatrix<f64, D, D>,
    information: BlockMatrix<D>,
    innovation: Theta<D>,
    energy: f64,
    ranges: usize,
    residuals: usize,
}

impl<const D: usize> Sum<D> {
    fn new() -> Self {
        Self {
            gram: SMatrix::zeros(),
            information: BlockMatrix::zeros(),
            innovation: Theta::zeros(),
            energy: 0.0,
            ranges: 0,
            residuals: 0,
        }
    }

    #[inline]
    fn add(&mut self, c: &SVector<f64, D>, one: &SensorSum<D>, with_gram: bool, with_information: bool) {
        let extended = |j: usize| if j < D { c[j] } else { 1.0 };
        if with_gram {
            self.gram = one.gram;
        }
        if with_information {
            for i in 0..=D {
                for j in 0..=i {
                    *self.information.block_mut(i, j) += one.gram * (extended(i) * extended(j));
                }
            }
        }
        for j in 0..=D {
            self.innovation.add_to_column(j, &(one.vector * extended(j)));
        }
        self.energy += one.energy;
        self.ranges += one.ranges;
        self.residuals += one.residuals;
    }
}

/// `(C_e C_e^T) (x) R`.
fn kronecker<const D: usize>(topology: &Topology<D>, gram: &SMatrix<f64, D, D>) -> BlockMatrix<D> {
    let mut result = BlockMatrix::zeros();
    for i in 0..D {
        for j in 0..=i {
            *result.block_mut(i, j) = gram * topology.gram()[(i, j)];
        }
        *result.block_mut(D, i) = gram * topology.sum()[i];
    }
    *result.block_mut(D, D) = gram * topology.len() as f64;
    result
}
