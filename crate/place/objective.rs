//! What a placement of anchors is worth: one number over all places of the body.

use alloc::vec::Vec;

use nalgebra::SVector;

use super::figure::{Figure, Sharpness};
use crate::bounds::{FisherInformation, fisher_information_of, unitary_crb};
use crate::error::{Error, Result};
use crate::math::float::{pow, sqrt};
use crate::math::pose::Pose;
use crate::model::anchors::Anchors;
use crate::model::availability::Availability;
use crate::model::noise::RangeNoise;
use crate::model::placement_settings::{Criterion, Over};
use crate::model::ranges::Ranges;
use crate::model::ranging::{RangeForm, RangeModel, Weighting};
use crate::model::topology::Topology;

/// What is asked of anchors: body, noise, the poses that count, and the number of the bound that is to be small.
///
/// The bound is [`unitary_crb`] of the ranges that are available at each pose, each weighted by its own variance.
///
/// ```
/// use nalgebra::Vector2;
/// use rangelab::model::presets::preset;
/// use rangelab::place::Placement;
/// let placement = Placement::<2>::of(&preset("planar")?)?;
/// let close = [Vector2::new(0.0, 0.0), Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0)];
/// let apart = close.map(|anchor| anchor * 9.0);
/// assert!(placement.value(&apart)? < placement.value(&close)?);
/// # Ok::<(), rangelab::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Placement<const D: usize> {
    /// The sensors.
    pub topology: Topology<D>,
    /// How ranges are disturbed.
    pub noise: RangeNoise,
    /// Which ranges exist.
    pub availability: Availability<D>,
    /// Places and attitudes of the body, at least one.
    pub poses: Vec<Pose<D>>,
    /// Which ranges the bound is of.
    pub form: RangeForm,
    /// The number of one bound.
    pub figure: Figure,
    /// How the poses count together.
    pub over: Over,
}

impl<const D: usize> Placement<D> {
    /// The root mean square or the largest of the figures over the poses, m or rad.
    ///
    /// # Errors
    /// [`Error::Unobservable`] with the cause at the first pose where no bound exists; [`Error::Number`] where the sums
    /// overflow or an anchor is not finite, [`Error::Size`] without anchors.
    pub fn value(&self, anchors: &[SVector<f64, D>]) -> Result<f64> {
        let model = self.model(anchors)?;
        let figures: Result<Vec<f64>> = self
            .poses
            .iter()
            .map(|pose| {
                let ranges = model.measurable_ranges(pose, &self.availability)?;
                let bound = unitary_crb(&self.information(&model, pose, &ranges)?)?;
                finite(self.figure.value(&bound))
            })
            .collect();
        Ok(self.total(&figures?))
    }

    /// The figures of the poses as one number: their root mean square, or the largest.
    pub(super) fn total(&self, figures: &[f64]) -> f64 {
        match self.over {
            Over::Mean => sqrt(figures.iter().map(|f| f * f).sum::<f64>() / figures.len() as f64),
            Over::Worst => figures.iter().copied().fold(0.0, f64::max),
        }
    }

    /// Anchors, topology and noise with a weight for each pair.
    pub(super) fn model(&self, anchors: &[SVector<f64, D>]) -> Result<RangeModel<D>> {
        let anchors = Anchors::new(anchors.to_vec())?;
        RangeModel::new(anchors, self.topology.clone(), self.noise, Weighting::PerPair)
    }

    pub(super) fn information<'a>(
        &self,
        model: &'a RangeModel<D>,
        pose: &Pose<D>,
        ranges: &Ranges,
    ) -> Result<FisherInformation<'a, D>> {
        fisher_information_of(model, pose, ranges, self.form, &mut model.range_buffer())
    }

    /// The figures `f_i` of the poses as one number `V`, and `dV/df_i`: the mean of order 2, or the maximum, or in its
    /// place a mean of high order `p`, `V = (mean f_i^p)^(1/p)`, `dV/df_i = (f_i/V)^(p-1)/I`.
    pub(super) fn together(&self, figures: &[f64], sharpness: Sharpness) -> (f64, Vec<f64>) {
        let largest = figures.iter().copied().fold(0.0, f64::max);
        let count = figures.len() as f64;
        let mean_of_order = |order: f64| {
            // In units of the largest, so that high powers stay in range.
            let mean = figures.iter().map(|f| pow(f / largest, order)).sum::<f64>() / count;
            let value = largest * pow(mean, 1.0 / order);
            (value, figures.iter().map(|f| pow(f / value, order - 1.0) / count).collect())
        };
        match (self.over, sharpness.order()) {
            _ if !(largest > 0.0) => (largest, figures.iter().map(|_| 0.0).collect()),
            (Over::Mean, _) => {
                let value = self.total(figures);
                (value, figures.iter().map(|f| f / (value * count)).collect())
            }
            (Over::Worst, Some((_, order))) => mean_of_order(order),
            (Over::Worst, None) => {
                let first = figures.iter().position(|f| *f >= largest);
                (largest, (0..figures.len()).map(|i| f64::from(u8::from(Some(i) == first))).collect())
            }
        }
    }

    /// Whether the value has kinks where maxima change hands.
    pub(super) fn has_kinks(&self) -> bool {
        self.figure.criterion == Criterion::E || self.over == Over::Worst && self.poses.len() > 1
    }
}

/// Refuses the figure of a bound that is singular or beyond doubles.
pub(super) fn finite(figure: f64) -> Result<f64> {
    if figure.is_finite() {
        return Ok(figure);
    }
    Err(Error::Number { what: "the standard deviation of a bound", value: figure, limit: "finite" })
}
