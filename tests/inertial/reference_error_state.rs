//! The yardsticks once more on plain matrices: integrals by their power series, all ranges at once by a long matrix.

use rangelab::model::indoor::StartPrior;
use rangelab::model::indoor::epoch::{IndoorEpoch, IndoorRecording};
use rangelab::model::indoor::filter_settings::FilterName;

use crate::plain::*;
use crate::reference::trilateration;

/// `(R, p, v)` with the covariance of `(phi, p, v)`, or of `xi` for the left-invariant filter.
pub struct Nine {
    pub r: Matrix,
    pub p: Vector,
    pub v: Vector,
    pub covariance: Matrix,
    invariant: bool,
}

fn put(a: &mut Matrix, i: usize, j: usize, block: &Matrix) {
    for (k, row) in block.iter().enumerate() {
        a[i + k][j..j + row.len()].copy_from_slice(row);
    }
}

fn scaled(a: &Matrix, scale: f64) -> Matrix {
    plus(&zeros(a.len(), a[0].len()), scale, a)
}

impl Nine {
    pub fn new(recording: &IndoorRecording, name: FilterName) -> Self {
        let StartPrior::Isotropic { variance } = recording.start.prior else { panic!("isotropic") };
        let state = &recording.start.state;
        let matrix = state.rotation.matrix();
        let mut covariance = scaled(&identity(9), variance);
        (0..3).for_each(|k| covariance[k][k] *= 0.5);
        // An isotropic covariance is the same in all axes.
        Self {
            r: (0..3).map(|i| (0..3).map(|j| matrix[(i, j)]).collect()).collect(),
            p: state.position.as_slice().to_vec(),
            v: state.velocity.as_slice().to_vec(),
            covariance,
            invariant: name == FilterName::LieKf,
        }
    }

    /// What turns `(phi, p, v)` into the filter's own error.
    fn own_axes(&self) -> Matrix {
        let mut change = identity(9);
        if self.invariant {
            put(&mut change, 3, 3, &transpose(&self.r));
            put(&mut change, 6, 6, &transpose(&self.r));
        }
        change
    }

    /// The covariance of `(phi, p, v)`.
    pub fn reported(&self) -> Matrix {
        congruence(&inverse(&self.own_axes()), &self.covariance)
    }

    fn predict(&mut self, recording: &IndoorRecording, epoch: &IndoorEpoch) {
        let (t, model) = (epoch.interval, &recording.model);
        let (w, a) = (epoch.sample.angular_velocity, epoch.sample.acceleration);
        let phi: Vector = w.iter().map(|x| x * t).collect();
        let (r, before) = (self.r.clone(), self.own_axes());
        let (g1, g2) = (series(&phi, 1), series(&phi, 2));
        let moved = [scaled(&g2, t * t), scaled(&g1, t)].map(|g| on(&g, a.as_slice()));
        let mut f = identity(9);
        put(&mut f, 0, 0, &transpose(&series(&phi, 0)));
        put(&mut f, 3, 0, &scaled(&times(&r, &hat(&moved[0])), -1.0));
        put(&mut f, 6, 0, &scaled(&times(&r, &hat(&moved[1])), -1.0));
        put(&mut f, 3, 6, &scaled(&identity(3), t));
        let mut g = zeros(9, 6);
        put(&mut g, 0, 0, &scaled(&transpose(&g1), t));
        for axis in 0..3 {
            let turned = [(2, t * t * t), (1, t * t)].map(|(n, scale)| {
                let slope = series_slope(&phi, n, a.as_slice(), axis);
                on(&r, &slope).iter().map(|x| x * scale).collect::<Vector>()
            });
            for k in 0..3 {
                g[3 + k][axis] = turned[0][k];
                g[6 + k][axis] = turned[1][k];
            }
        }
        put(&mut g, 3, 3, &scaled(&times(&r, &g2), t * t));
        put(&mut g, 6, 3, &scaled(&times(&r, &g1), t));
        let mut q = zeros(6, 6);
        for k in 0..6 {
            q[k][k] = if k < 3 { model.angular_velocity_variance } else { model.acceleration_variance };
        }
        for k in 0..3 {
            let (dp, dv) = (on(&r, &moved[0])[k], on(&r, &moved[1])[k]);
            self.p[k] += t * self.v[k] + dp + 0.5 * t * t * model.gravity[k];
            self.v[k] += dv + t * model.gravity[k];
        }
        self.r = times(&r, &series(&phi, 0));
        let after = self.own_axes();
        let f = times(&times(&after, &f), &inverse(&before));
        let g = times(&after, &g);
        self.covariance = plus(&congruence(&f, &self.covariance), 1.0, &congruence(&g, &q));
    }

    /// Rows of `d/d(phi, p, v)` and innovations: of the positions found one by one, or of the ranges.
    fn measured(
        &self,
        recording: &IndoorRecording,
        epoch: &IndoorEpoch,
        name: FilterName,
    ) -> (Matrix, Vector) {
        let model = &recording.model;
        let places: Vec<Vector> =
            model.transmitters.iter().map(|c| add(&self.p, 1.0, &on(&self.r, c.as_slice()))).collect();
        let position_rows = |i: usize| {
            let mut h = zeros(3, 9);
            put(&mut h, 0, 0, &scaled(&times(&self.r, &hat(model.transmitters[i].as_slice())), -1.0));
            put(&mut h, 0, 3, &identity(3));
            h
        };
        if name != FilterName::Tight {
            let expected = places.concat();
            let found = trilateration(recording, epoch, &expected);
            return ((0..3).flat_map(position_rows).collect(), add(&found, -1.0, &expected));
        }
        let (mut h, mut innovation) = (Vec::new(), Vec::new());
        for (beacon, ranges) in model.beacons.iter().zip(&epoch.ranges) {
            for i in 0..3 {
                let difference = add(&places[i], -1.0, beacon.as_slice());
                let distance = difference.iter().map(|x| x * x).sum::<f64>().sqrt();
                let direction: Matrix = vec![difference.iter().map(|x| x / distance).collect()];
                h.push(times(&direction, &position_rows(i)).remove(0));
                innovation.push(ranges[i].unwrap() - distance);
            }
        }
        (h, innovation)
    }

    pub fn step(&mut self, recording: &IndoorRecording, epoch: &IndoorEpoch, name: FilterName) {
        self.predict(recording, epoch);
        if epoch.ranges.is_empty() {
            return;
        }
        let (h, innovation) = self.measured(recording, epoch, name);
        let h = times(&h, &inverse(&self.own_axes()));
        let sigma = recording.model.sigma;
        let spread = plus(&congruence(&h, &self.covariance), sigma * sigma, &identity(h.len()));
        let gain = times(&times(&self.covariance, &transpose(&h)), &inverse(&spread));
        let error = on(&gain, &innovation);
        self.covariance = times(&plus(&identity(9), -1.0, &times(&gain, &h)), &self.covariance);
        let (phi, mut p, mut v) = (error[..3].to_vec(), error[3..6].to_vec(), error[6..].to_vec());
        if self.invariant {
            let frame = times(&self.r, &series(&phi, 1));
            (p, v) = (on(&frame, &p), on(&frame, &v));
        }
        self.p = add(&self.p, 1.0, &p);
        self.v = add(&self.v, 1.0, &v);
        self.r = times(&self.r, &series(&phi, 0));
    }
}
