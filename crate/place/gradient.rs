//! How the value of a placement changes with the place of each anchor.

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};

use super::figure::Sharpness;
use super::objective::{Placement, finite};
use crate::bounds::unitary_crb;
use crate::error::{Error, Result};
use crate::math::pose::Pose;
use crate::math::rotation::{MAX_ANGLES, rotation_angles};
use crate::math::tangent::{MAX_TANGENT, TangentMatrix, TangentTransform, tangent_dimension};
use crate::model::noise::{SQUARED_RANGE_FLOOR, VarianceLaw};
use crate::model::ranges::Ranges;
use crate::model::ranging::{RangeForm, RangeModel};

/// Information that is added to that of the ranges, isotropic in angles and in position, so that a bound exists where
/// the ranges do not see everything. With none the bound is that of the ranges alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Prior {
    /// rad^-2.
    pub angle: f64,
    /// m^-2.
    pub shift: f64,
}

/// This part of the information of the ranges is what a prior adds: too little to be seen where a bound exists.
const WEAK: f64 = 1e-9;
/// And at least this, rad^-2: a standard deviation of 1000 rad, or of 1000 times the extent of the scene.
const WEAKEST: f64 = 1e-6;

impl<const D: usize> Placement<D> {
    /// The value and its derivative with the position of each anchor, m/m or rad/m; which ranges are available counts as
    /// settled. Where the value has a kink (E, worst), the derivative of one side; or both of the smooth mean in its place.
    ///
    /// At each pose `J = sum_mn 4 w_mn H_n^T v_mn v_mn^T H_n`, with `w` the inverse variance of the squared range,
    /// `v_mn = a_m - z_n` (`z_n` the sensor, or the weighted mean of the anchors where `||s||^2` is projected out) and
    /// `H_n = d s_n/d(phi, t)`. With `G = d value/dJ` and `G_n = H_n G H_n^T`
    ///
    /// `d value/d a_m = sum_n 4 (2 w'_mn (v^T G_n v) (a_m - s_n) + 2 w_mn G_n v)`;
    ///
    /// that `z_n` moves too changes nothing, since `sum_m w_mn v_mn = 0`.
    ///
    /// # Errors
    /// As [`Placement::value`].
    pub fn gradient(
        &self,
        anchors: &[SVector<f64, D>],
        sharpness: Sharpness,
    ) -> Result<(f64, Vec<SVector<f64, D>>)> {
        self.differentiate(anchors, None, sharpness)
    }

    /// The same with a prior.
    pub(super) fn differentiate(
        &self,
        anchors: &[SVector<f64, D>],
        prior: Option<Prior>,
        sharpness: Sharpness,
    ) -> Result<(f64, Vec<SVector<f64, D>>)> {
        let model = self.model(anchors)?;
        let (mut figures, mut slopes) = (Vec::new(), Vec::new());
        for pose in &self.poses {
            let ranges = model.measurable_ranges(pose, &self.availability)?;
            let covariance = self.covariance(&model, pose, &ranges, prior)?;
            let (figure, slope) = self.figure.differentiate(&covariance, sharpness);
            figures.push(finite(figure)?);
            slopes.push((ranges, slope));
        }
        let (value, weights) = self.together(&figures, sharpness);
        let mut gradient = vec![SVector::zeros(); anchors.len()];
        for ((pose, (ranges, slope)), weight) in self.poses.iter().zip(slopes).zip(weights) {
            if weight > 0.0 {
                self.add_gradient(&model, pose, &ranges, &(slope * weight), &mut gradient);
            }
        }
        Ok((value, gradient))
    }

    /// A prior that is weak beside what the ranges say at these anchors, in a scene of such an extent, m.
    pub(super) fn weak_prior(&self, anchors: &[SVector<f64, D>], extent: f64) -> Result<Prior> {
        let model = self.model(anchors)?;
        let area = (extent * extent).max(SQUARED_RANGE_FLOOR);
        let mut prior = Prior { angle: WEAKEST, shift: WEAKEST / area };
        for pose in &self.poses {
            let information =
                self.information(&model, pose, &model.measurable_ranges(pose, &self.availability)?)?;
            let j = information.on_tangent_space();
            for i in 0..tangent_dimension(D) {
                let largest = if i < rotation_angles(D) { &mut prior.angle } else { &mut prior.shift };
                *largest = largest.max(WEAK * j.entry(i, i));
            }
        }
        Ok(prior)
    }

    fn covariance(
        &self,
        model: &RangeModel<D>,
        pose: &Pose<D>,
        ranges: &Ranges,
        prior: Option<Prior>,
    ) -> Result<TangentMatrix<D>> {
        let information = self.information(model, pose, ranges)?;
        let Some(prior) = prior else { return unitary_crb(&information) };
        let mut j = information.on_tangent_space();
        j.add_isotropic(prior.angle, prior.shift);
        j.inverse()
            .map_err(|pivot| Error::NotPositiveDefinite { what: "the information of the ranges", pivot })
    }

    /// Adds the share of one pose, given `d value/dJ` there.
    fn add_gradient(
        &self,
        model: &RangeModel<D>,
        pose: &Pose<D>,
        ranges: &Ranges,
        slope: &TangentTransform,
        gradient: &mut [SVector<f64, D>],
    ) {
        let (law, anchors) = (self.noise.law(), model.anchors().positions());
        for (n, sensor) in self.topology.sensors().iter().enumerate() {
            let (place, motion) = (pose.act(sensor), motion_of_sensor(pose, sensor));
            let g = motion * slope * motion.transpose();
            let measured = ranges.of_sensor(n);
            let centre = match self.form {
                RangeForm::Raw => place,
                RangeForm::Projected => weighted_mean(law, anchors, measured).1,
            };
            for (m, &d) in measured.iter().enumerate().filter(|(_, d)| !d.is_nan()) {
                let (u, v, weight) = (anchors[m] - place, anchors[m] - centre, 1.0 / law.variance(d));
                let weight_slope = -law.slope(d) * weight * weight;
                let gv = g * v;
                gradient[m] += u * (8.0 * weight_slope * v.dot(&gv)) + gv * (8.0 * weight);
            }
        }
    }
}

/// The sum of the weights of the ranges that a sensor has, and the weighted mean of their anchors; not a number without
/// any.
pub(super) fn weighted_mean<const D: usize>(
    law: VarianceLaw,
    anchors: &[SVector<f64, D>],
    squared_ranges: &[f64],
) -> (f64, SVector<f64, D>) {
    let measured = anchors.iter().zip(squared_ranges).filter(|(_, d)| !d.is_nan());
    let weighted = measured.map(|(a, &d)| (1.0 / law.variance(d), a));
    let (total, sum) =
        weighted.fold((0.0, SVector::zeros()), |(total, sum), (w, a)| (total + w, sum + a * w));
    (total, sum / total)
}

/// How a sensor moves with the pose, `H_n = d s_n/d(phi, t) = [.. R hat(e_i) c_n .. | I]`.
pub(super) fn motion_of_sensor<const D: usize>(
    pose: &Pose<D>,
    sensor: &SVector<f64, D>,
) -> SMatrix<f64, D, MAX_TANGENT> {
    let angles = rotation_angles(D);
    let turns: [SVector<f64, D>; MAX_ANGLES] =
        core::array::from_fn(
            |i| {
                if i < angles { pose.rotation.tangent(i) * sensor } else { SVector::zeros() }
            },
        );
    let column = |a: usize, row: usize| {
        if a < angles { turns[a][row] } else { f64::from(u8::from(a - angles == row)) }
    };
    SMatrix::from_fn(|row, a| column(a, row))
}
