//! The cost of a pose in the ranges themselves, `sum rho((r_mn - y_mn)/sigma_mn)`, with its slope and curvature.

use alloc::vec::Vec;

use nalgebra::SVector;

use super::snapshot::Snapshot;
use crate::math::float::sqrt;
use crate::math::pose::Pose;
use crate::math::rotation::{Angles, MAX_ANGLES, rotation_angles};
use crate::math::tangent::{MAX_TANGENT, TangentTransform, TangentVector, join, tangent_dimension};
use crate::model::localize_settings::Loss;

/// Ranges shorter than this part of the longest weigh no more than it, as in the linear model.
const WEIGHT_FLOOR: f64 = 1e-3;

/// One range.
struct Pair {
    anchor: usize,
    sensor: usize,
    /// `y`, m.
    range: f64,
    /// `1/sigma`, 1/m.
    weight: f64,
}

/// The ranges of an epoch, each with its own variance.
pub(super) struct RangeFit<'a, const D: usize> {
    snapshot: &'a Snapshot<'a, D>,
    pairs: Vec<Pair>,
    loss: Loss,
}

/// The cost about a pose: `cost + 2 slope^T x + x^T curvature x`, after Gauss and Newton.
pub(super) struct Linearized {
    pub(super) cost: f64,
    pub(super) slope: TangentVector,
    /// Unused coordinates (D = 2) carry the identity.
    pub(super) curvature: TangentTransform,
}

impl<'a, const D: usize> RangeFit<'a, D> {
    /// Takes the ranges with the variances of those that give the weights. Where a squared range is negative for noise the
    /// range is 0.
    pub(super) fn new(snapshot: &'a Snapshot<'a, D>, loss: Loss) -> Self {
        let (ranges, weights) = (snapshot.ranges, snapshot.weight_ranges);
        let squared = |m: usize, n: usize| weights.get(m, n);
        let mut fit = Self { snapshot, pairs: Vec::with_capacity(ranges.anchors() * ranges.sensors()), loss };
        for sensor in 0..ranges.sensors() {
            for anchor in 0..ranges.anchors() {
                if let (Some(d), Some(_)) = (ranges.get(anchor, sensor), squared(anchor, sensor)) {
                    fit.pairs.push(Pair { anchor, sensor, range: sqrt(d.max(0.0)), weight: 0.0 });
                }
            }
        }
        fit.weigh(|pair| squared(pair.anchor, pair.sensor).unwrap_or_default());
        fit
    }

    /// The same with the variances of the ranges at a pose.
    pub(super) fn reweigh(&mut self, pose: &Pose<D>) {
        let snapshot = self.snapshot;
        self.weigh(|pair| separation(snapshot, pose, pair).norm_squared());
    }

    fn weigh(&mut self, squared: impl Fn(&Pair) -> f64) {
        let floor = WEIGHT_FLOOR * self.pairs.iter().map(&squared).fold(0.0, f64::max);
        let law = self.snapshot.model.noise().law();
        for pair in &mut self.pairs {
            let d = squared(pair).max(floor).max(f64::MIN_POSITIVE);
            // var y = var d/(4 r^2).
            let variance = law.variance(d) / (4.0 * d);
            pair.weight = 1.0 / sqrt(variance);
        }
    }

    /// The cost of a pose of the sensors' centroid.
    pub(super) fn cost(&self, pose: &Pose<D>) -> f64 {
        let residual =
            |pair: &Pair| pair.weight * (separation(self.snapshot, pose, pair).norm() - pair.range);
        self.pairs.iter().map(|pair| rho(self.loss, residual(pair)).0).sum()
    }

    /// The cost with its derivatives along `(phi, shift)`.
    pub(super) fn linearized(&self, pose: &Pose<D>) -> Linearized {
        let mut result =
            Linearized { cost: 0.0, slope: TangentVector::zeros(), curvature: TangentTransform::zeros() };
        for i in tangent_dimension(D)..MAX_TANGENT {
            result.curvature[(i, i)] = 1.0;
        }
        for pair in &self.pairs {
            let apart = separation(self.snapshot, pose, pair);
            let length = apart.norm();
            let residual = pair.weight * (length - pair.range);
            let (cost, weight) = rho(self.loss, residual);
            result.cost += cost;
            // A sensor on its anchor: no direction is nearer than another.
            let towards = if length > 0.0 { apart / length } else { SVector::zeros() };
            let in_body = pose.rotation.matrix().transpose() * towards;
            let turn = turn_slope::<D>(&self.snapshot.levers[pair.sensor], &in_body);
            let row = join(&turn, &towards) * pair.weight;
            result.slope += row * (weight * residual);
            for j in 0..tangent_dimension(D) {
                for i in 0..tangent_dimension(D) {
                    result.curvature[(i, j)] += weight * row[i] * row[j];
                }
            }
        }
        result
    }
}

/// From anchor to sensor, m.
fn separation<const D: usize>(snapshot: &Snapshot<D>, pose: &Pose<D>, pair: &Pair) -> SVector<f64, D> {
    pose.act(&snapshot.levers[pair.sensor]) - snapshot.model.anchors().positions()[pair.anchor]
}

/// Cost of a residual, and the factor on its square's slope.
fn rho(loss: Loss, residual: f64) -> (f64, f64) {
    match loss {
        Loss::Huber { scale } if residual.abs() > scale => {
            (scale * (2.0 * residual.abs() - scale), scale / residual.abs())
        }
        _ => (residual * residual, 1.0),
    }
}

/// `v^T E_i c` for each angle: `c x v` in space.
fn turn_slope<const D: usize>(c: &SVector<f64, D>, v: &SVector<f64, D>) -> Angles {
    let mut slope = [0.0; MAX_ANGLES];
    if D == 2 {
        slope[0] = c[0] * v[1] - c[1] * v[0];
        return slope;
    }
    for (i, entry) in slope.iter_mut().enumerate().take(rotation_angles(D)) {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        *entry = c[j] * v[k] - c[k] * v[j];
    }
    slope
}
