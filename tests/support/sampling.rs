//! Random problems from a seed. Seeds are small counting numbers, never chosen by their results.

use nalgebra::{SMatrix, SVector};
use rand::{RngExt, SeedableRng};
use rand_distr::StandardNormal;
use rand_pcg::Pcg64Mcg;
use rangelab::math::float::sqrt;
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::{Angles, Rotation, rotation_angles};
use rangelab::model::anchors::Anchors;
use rangelab::model::topology::Topology;

pub struct Sampler(Pcg64Mcg);

impl Sampler {
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.random::<f64>()
    }

    pub fn normal(&mut self) -> f64 {
        self.0.sample(StandardNormal)
    }

    pub fn below(&mut self, count: usize) -> usize {
        self.0.random_range(0..count)
    }

    pub fn vector<const D: usize>(&mut self, scale: f64) -> SVector<f64, D> {
        SVector::from_fn(|_, _| scale * self.normal())
    }

    pub fn matrix<const D: usize>(&mut self, scale: f64) -> SMatrix<f64, D, D> {
        SMatrix::from_fn(|_, _| scale * self.normal())
    }

    /// Unit rotation axis; in the plane `+-1`.
    pub fn axis<const D: usize>(&mut self) -> Angles {
        let mut axis = [0.0; 3];
        for entry in axis.iter_mut().take(rotation_angles(D)) {
            *entry = self.normal();
        }
        let length = sqrt(axis.iter().map(|x| x * x).sum());
        axis.map(|x| x / length)
    }

    /// A rotation by any angle up to pi about a random axis.
    pub fn rotation<const D: usize>(&mut self) -> Rotation<D> {
        let angle = self.uniform(0.0, core::f64::consts::PI);
        Rotation::exp(&self.axis::<D>().map(|x| angle * x))
    }

    pub fn pose<const D: usize>(&mut self, scale: f64) -> Pose<D> {
        Pose { rotation: self.rotation(), position: self.vector(scale) }
    }

    /// `[Q | t]` with `Q` any matrix.
    pub fn theta<const D: usize>(&mut self, scale: f64) -> Theta<D> {
        Theta { orientation: self.matrix(1.0), position: self.vector(scale) }
    }

    /// Anchors in the cube `[-half, half]^D`.
    pub fn anchors<const D: usize>(&mut self, count: usize, half: f64) -> Anchors<D> {
        let points = (0..count).map(|_| SVector::from_fn(|_, _| self.uniform(-half, half))).collect();
        Anchors::new(points).unwrap()
    }

    /// Sensors about the body's origin; exactly centred if asked.
    pub fn topology<const D: usize>(&mut self, count: usize, centred: bool) -> Topology<D> {
        let mut sensors: Vec<SVector<f64, D>> = (0..count).map(|_| self.vector(0.5)).collect();
        if centred {
            let mean = sensors.iter().sum::<SVector<f64, D>>() / count as f64;
            for c in &mut sensors {
                *c -= mean;
            }
        }
        Topology::new(sensors).unwrap()
    }

    /// A symmetric positive definite matrix with the given eigenvalues.
    pub fn spd<const D: usize>(&mut self, eigenvalues: &[f64]) -> SMatrix<f64, D, D> {
        let axes = *self.rotation::<D>().matrix();
        let diagonal = SVector::<f64, D>::from_fn(|i, _| eigenvalues[i]);
        axes * SMatrix::from_diagonal(&diagonal) * axes.transpose()
    }
}
