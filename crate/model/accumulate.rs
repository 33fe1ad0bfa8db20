//! The O(M N) sums over ranges; everything after them has a constant size.

use alloc::{vec, vec::Vec};

use nalgebra::{SMatrix, SVector};

use super::normal_equations::{Information, NormalEquations};
use super::ranging::RangeForm;
use crate::math::block::BlockMatrix;
use crate::math::pose::Theta;

/// One number or vector an anchor, kept by the caller so that a step allocates nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeBuffer<const D: usize> {
    pub(super) weights: Vec<f64>,
    residuals: Vec<f64>,
    /// Anchors less their weighted mean, where all sensors share it.
    levers: Vec<SVector<f64, D>>,
    /// That mean, and the inverse of the sum of the weights.
    centre: SVector<f64, D>,
    inverse_total: f64,
}

impl<const D: usize> RangeBuffer<D> {
    pub(super) fn new(anchors: usize) -> Self {
        Self {
            weights: vec![0.0; anchors],
            residuals: vec![0.0; anchors],
            levers: vec![SVector::zeros(); anchors],
            centre: SVector::zeros(),
            inverse_total: 0.0,
        }
    }
}

/// The sums over sensors, taken in the normal equations themselves.
pub(super) struct Sum<'a, const D: usize> {
    /// `R`, where all sensors share it; else `Lambda` is in `normal`.
    pub(super) gram: SMatrix<f64, D, D>,
    normal: &'a mut NormalEquations<D>,
}

impl<'a, const D: usize> Sum<'a, D> {
    /// Starts from zero; sums that are not shared go to a full information matrix.
    pub(super) fn new(normal: &'a mut NormalEquations<D>, shared: bool) -> Self {
        if !shared {
            normal.information = Information::Full(BlockMatrix::zeros());
        }
        normal.innovation = Theta::zeros();
        (normal.energy, normal.ranges, normal.residuals) = (0.0, 0, 0);
        Self { gram: SMatrix::zeros(), normal }
    }

    /// Works out what all sensors share when no range is missing and weights are common.
    pub(super) fn set_shared(&mut self, anchors: &[SVector<f64, D>], buffer: &mut RangeBuffer<D>) {
        let (centre, total) = weighted_mean(anchors, &buffer.weights);
        (buffer.centre, buffer.inverse_total) = (centre, 1.0 / total);
        for ((lever, a), &w) in buffer.levers.iter_mut().zip(anchors).zip(&buffer.weights) {
            *lever = a - centre;
            add_to_gram(&mut self.gram, w, lever);
        }
        mirror(&mut self.gram);
    }

    /// Adds a sensor after [`Sum::set_shared`].
    #[inline]
    pub(super) fn add_shared(
        &mut self,
        c: &SVector<f64, D>,
        sensor_in_world: &SVector<f64, D>,
        squared_ranges: &[f64],
        buffer: &mut RangeBuffer<D>,
    ) {
        let sensor = sensor_in_world - buffer.centre;
        let mut offset = 0.0;
        for (((e, lever), &d), &w) in
            buffer.residuals.iter_mut().zip(&buffer.levers).zip(squared_ranges).zip(&buffer.weights)
        {
            *e = d - squared_distance(lever, &sensor);
            offset += w * *e;
        }
        offset *= buffer.inverse_total;
        let mut vector = SVector::zeros();
        for ((&e, lever), &w) in buffer.residuals.iter().zip(&buffer.levers).zip(&buffer.weights) {
            self.normal.energy += add_residual(&mut vector, w, e - offset, lever);
        }
        self.normal.ranges += squared_ranges.len();
        self.normal.residuals += squared_ranges.len() - 1;
        self.add_vector(c, &vector);
    }

    /// Adds a sensor with information of its own; ranges that are missing or without a weight are left out.
    pub(super) fn add(
        &mut self,
        c: &SVector<f64, D>,
        sensor_in_world: &SVector<f64, D>,
        anchors: &[SVector<f64, D>],
        squared_ranges: &[f64],
        form: RangeForm,
        buffer: &mut RangeBuffer<D>,
    ) {
        let present = |d: f64, w: f64| !d.is_nan() && w > 0.0;
        let (mut total, mut centre, mut offset, mut ranges) = (0.0, SVector::zeros(), 0.0, 0);
        for (((e, a), &d), &w) in
            buffer.residuals.iter_mut().zip(anchors).zip(squared_ranges).zip(&buffer.weights)
        {
            if present(d, w) {
                *e = d - squared_distance(a, sensor_in_world);
                total += w;
                centre += a * w;
                offset += w * *e;
                ranges += 1;
            }
        }
        if ranges == 0 {
            return;
        }
        let raw = form == RangeForm::Raw;
        let inverse = 1.0 / total;
        (centre, offset) = if raw { (*sensor_in_world, 0.0) } else { (centre * inverse, offset * inverse) };
        let (mut gram, mut vector) = (SMatrix::zeros(), SVector::zeros());
        for (((&e, a), &d), &w) in
            buffer.residuals.iter().zip(anchors).zip(squared_ranges).zip(&buffer.weights)
        {
            if present(d, w) {
                let lever = a - centre;
                add_to_gram(&mut gram, w, &lever);
                self.normal.energy += add_residual(&mut vector, w, e - offset, &lever);
            }
        }
        mirror(&mut gram);
        if let Information::Full(matrix) = &mut self.normal.information {
            let extended = |i: usize| if i < D { c[i] } else { 1.0 };
            matrix.add_kronecker(|i, j| extended(i) * extended(j), &gram);
        }
        self.normal.ranges += ranges;
        self.normal.residuals += if raw { ranges } else { ranges - 1 };
        self.add_vector(c, &vector);
    }

    /// Adds `vector [c; 1]^T`.
    #[inline]
    fn add_vector(&mut self, c: &SVector<f64, D>, vector: &SVector<f64, D>) {
        for j in 0..D {
            for i in 0..D {
                self.normal.innovation.orientation[(i, j)] += vector[i] * c[j];
            }
        }
        self.normal.innovation.position += vector;
    }
}

fn weighted_mean<const D: usize>(points: &[SVector<f64, D>], weights: &[f64]) -> (SVector<f64, D>, f64) {
    let (mut sum, mut total) = (SVector::zeros(), 0.0);
    for (p, &w) in points.iter().zip(weights) {
        sum += p * w;
        total += w;
    }
    (sum / total, total)
}

#[inline]
fn squared_distance<const D: usize>(a: &SVector<f64, D>, b: &SVector<f64, D>) -> f64 {
    let mut sum = 0.0;
    for i in 0..D {
        let difference = a[i] - b[i];
        sum += difference * difference;
    }
    sum
}

/// Adds `4 w lever lever^T` to the lower triangle.
#[inline]
fn add_to_gram<const D: usize>(gram: &mut SMatrix<f64, D, D>, w: f64, lever: &SVector<f64, D>) {
    for j in 0..D {
        let scaled = 4.0 * w * lever[j];
        for i in j..D {
            gram[(i, j)] += lever[i] * scaled;
        }
    }
}

fn mirror<const D: usize>(gram: &mut SMatrix<f64, D, D>) {
    for j in 0..D {
        for i in 0..j {
            gram[(i, j)] = gram[(j, i)];
        }
    }
}

/// Adds `-2 w e lever` and returns `w e^2`.
#[inline]
fn add_residual<const D: usize>(
    vector: &mut SVector<f64, D>,
    w: f64,
    e: f64,
    lever: &SVector<f64, D>,
) -> f64 {
    let weighted = w * e;
    for i in 0..D {
        vector[i] -= lever[i] * (2.0 * weighted);
    }
    weighted * e
}
