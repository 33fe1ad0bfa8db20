//! The filters once more, from the equations of the specification, on plain matrices: as slow and literal as they can be.
//!
//! Nothing is shared with the crate but its data types. Sigma points are taken with alpha = 1/2 and sums with all weights;
//! with models at most quadratic in the state alpha drops out.

use rangelab::model::indoor::StartPrior;
use rangelab::model::indoor::epoch::{IndoorEpoch, IndoorRecording};
use rangelab::model::indoor::filter_settings::{FilterName, Retraction, Transport};

use crate::plain::*;

pub struct Choices {
    pub transport: Transport,
    pub retraction: Retraction,
    pub tangent_correction: bool,
    /// Weights of the sigma points squared in the noise of the input, with alpha = 1e-3.
    pub squared_weights: bool,
}

/// `[vec(R); p; v]` with its covariance.
pub struct Fifteen {
    pub x: Vector,
    pub p: Matrix,
}

pub fn rotation(x: &[f64]) -> Matrix {
    (0..3).map(|i| (0..3).map(|j| x[3 * j + i]).collect()).collect()
}

fn set_rotation(x: &mut [f64], r: &Matrix) {
    for i in 0..3 {
        for j in 0..3 {
            x[3 * j + i] = r[i][j];
        }
    }
}

fn rows(recording: &IndoorRecording) -> Matrix {
    let matrix = recording.start.state.rotation.matrix();
    (0..3).map(|i| (0..3).map(|j| matrix[(i, j)]).collect()).collect()
}

/// Of `[vec(R); p; v]`: a tangent prior has `angle^2 J J^T` and next to nothing across the tangent space, `J` having the
/// columns `vec(R hat(e_i))`.
fn prior(recording: &IndoorRecording) -> Matrix {
    let mut p = zeros(15, 15);
    match recording.start.prior {
        StartPrior::Isotropic { variance } => p = plus(&p, variance, &identity(15)),
        StartPrior::Tangent { angle, position, velocity } => {
            for axis in 0..3 {
                let direction = times(&rows(recording), &hat(&identity(3)[axis]));
                let mut column = vec![0.0; 15];
                set_rotation(&mut column, &direction);
                for i in 0..9 {
                    for j in 0..9 {
                        p[i][j] += angle * angle * column[i] * column[j];
                    }
                }
            }
            for i in 0..15 {
                p[i][i] += [1e-10, position * position, velocity * velocity]
                    [usize::from(i >= 9) + usize::from(i >= 12)];
            }
        }
    }
    p
}

/// Positions of the transmitters by Gauss-Newton, each by itself, from where they are expected.
pub fn trilateration(recording: &IndoorRecording, epoch: &IndoorEpoch, expected: &[f64]) -> Vector {
    let mut y = expected.to_vec();
    for i in 0..3 {
        for _ in 0..100 {
            let (mut normal, mut gradient) = (zeros(3, 3), vec![0.0; 3]);
            for (beacon, ranges) in recording.model.beacons.iter().zip(&epoch.ranges) {
                let difference: Vector = (0..3).map(|k| y[3 * i + k] - beacon[k]).collect();
                let distance = difference.iter().map(|x| x * x).sum::<f64>().sqrt();
                for a in 0..3 {
                    gradient[a] += difference[a] / distance * (ranges[i].unwrap() - distance);
                    for b in 0..3 {
                        normal[a][b] += difference[a] * difference[b] / (distance * distance);
                    }
                }
            }
            let step = on(&inverse(&normal), &gradient);
            for k in 0..3 {
                y[3 * i + k] += step[k];
            }
        }
    }
    y
}

impl Fifteen {
    pub fn new(recording: &IndoorRecording) -> Self {
        let mut x = vec![0.0; 15];
        set_rotation(&mut x, &rows(recording));
        for k in 0..3 {
            x[9 + k] = recording.start.state.position[k];
            x[12 + k] = recording.start.state.velocity[k];
        }
        Self { x, p: prior(recording) }
    }

    /// Covariance of angles, position and velocity: the angles of a change of the state are `vee(skew(R^T dR))` at the
    /// rotation next to it.
    pub fn reported(&self) -> Matrix {
        let near = transpose(&polar(&rotation(&self.x)));
        let changes = identity(15).into_iter().map(|change| {
            let turned = times(&near, &rotation(&change));
            let skew = plus(&turned, -1.0, &transpose(&turned));
            [&[0.5 * skew[2][1], 0.5 * skew[0][2], 0.5 * skew[1][0]], &change[9..]].concat()
        });
        congruence(&transpose(&changes.collect()), &self.p)
    }

    /// \[I\] eq. 14 to 16 as functions of the state.
    fn moved(recording: &IndoorRecording, epoch: &IndoorEpoch, x: &[f64]) -> Vector {
        let (t, r) = (epoch.interval, rotation(x));
        let (w, a) = (epoch.sample.angular_velocity, epoch.sample.acceleration);
        let next = times(&r, &plus(&identity(3), t, &hat(w.as_slice())));
        let accelerated = add(&on(&r, a.as_slice()), 1.0, recording.model.gravity.as_slice());
        let mut result = x.to_vec();
        set_rotation(&mut result, &next);
        for k in 0..3 {
            result[9 + k] += t * x[12 + k] + 0.5 * t * t * accelerated[k];
            result[12 + k] += t * accelerated[k];
        }
        result
    }

    /// `g(X)`, 15 x 6: columns are what each input alone does.
    fn input_matrix(recording: &IndoorRecording, epoch: &IndoorEpoch, x: &[f64]) -> Matrix {
        let mut columns = Vec::new();
        for input in 0..6 {
            let mut alone = epoch.clone();
            alone.sample.angular_velocity.fill(0.0);
            alone.sample.acceleration.fill(0.0);
            let mut weightless = recording.clone();
            weightless.model.gravity.fill(0.0);
            let still = Self::moved(&weightless, &alone, x);
            if input < 3 {
                alone.sample.angular_velocity[input] = 1.0;
            } else {
                alone.sample.acceleration[input - 3] = 1.0;
            }
            columns.push(add(&Self::moved(&weightless, &alone, x), -1.0, &still));
        }
        transpose(&columns)
    }

    fn noise(recording: &IndoorRecording, epoch: &IndoorEpoch, x: &[f64]) -> Matrix {
        let mut q = zeros(6, 6);
        for k in 0..6 {
            let model = &recording.model;
            q[k][k] = if k < 3 { model.angular_velocity_variance } else { model.acceleration_variance };
        }
        congruence(&Self::input_matrix(recording, epoch, x), &q)
    }

    /// The derivative of `moved`, which is linear up to gravity: columns are its values on the unit vectors.
    fn jacobian(recording: &IndoorRecording, epoch: &IndoorEpoch, frozen: bool) -> Matrix {
        let mut weightless = recording.clone();
        weightless.model.gravity.fill(0.0);
        let mut driven = epoch.clone();
        if frozen {
            driven.sample.angular_velocity.fill(0.0);
            driven.sample.acceleration.fill(0.0);
        }
        let column = |k: usize| Self::moved(&weightless, &driven, &identity(15)[k]);
        transpose(&(0..15).map(column).collect())
    }

    fn measurement(recording: &IndoorRecording) -> Matrix {
        let mut h = zeros(9, 15);
        for (i, c) in recording.model.transmitters.iter().enumerate() {
            for k in 0..3 {
                for j in 0..3 {
                    h[3 * i + k][3 * j + k] = c[j];
                }
                h[3 * i + k][9 + k] = 1.0;
            }
        }
        h
    }

    fn stay(&mut self, choices: &Choices, before: &Matrix, old: &Matrix, transport: Transport) {
        let mut step = plus(&rotation(&self.x), -1.0, old);
        let in_body = times(&transpose(old), &step);
        let skew = plus(&zeros(3, 3), 0.5, &plus(&in_body, -1.0, &transpose(&in_body)));
        if choices.tangent_correction {
            step = times(old, &skew);
        }
        let moved = plus(old, 1.0, &step);
        let new = match choices.retraction {
            Retraction::Qr => q_factor(&moved),
            Retraction::Polar => polar(&moved),
            Retraction::Exponential => times(old, &series(&[skew[2][1], skew[0][2], skew[1][0]], 0)),
        };
        set_rotation(&mut self.x, &new);
        let turn = times(&new, &transpose(old));
        let mut m = identity(15);
        for j in 0..3 {
            for a in 0..3 {
                for b in 0..3 {
                    m[3 * j + a][3 * j + b] = turn[a][b];
                }
            }
        }
        let carried = match transport {
            Transport::None => return,
            Transport::Literal => congruence(&m, before),
            Transport::Block | Transport::Congruence => congruence(&m, &self.p),
        };
        let kept = if transport == Transport::Congruence { 15 } else { 9 };
        for i in 0..kept {
            for j in 0..kept {
                self.p[i][j] = carried[i][j];
            }
        }
    }

    /// One step of EKF, EKF full, EKF retraction and EKFRie.
    pub fn extended(
        &mut self,
        recording: &IndoorRecording,
        epoch: &IndoorEpoch,
        name: FilterName,
        choices: &Choices,
    ) {
        let (old, before) = (rotation(&self.x), self.p.clone());
        let f = Self::jacobian(recording, epoch, name != FilterName::EkfFull);
        self.p = plus(&congruence(&f, &self.p), 1.0, &Self::noise(recording, epoch, &self.x));
        self.x = Self::moved(recording, epoch, &self.x);
        let transport = if name == FilterName::EkfRie { choices.transport } else { Transport::None };
        let bare = Choices { tangent_correction: false, ..*choices };
        let on_manifold = [FilterName::EkfRie, FilterName::EkfRetraction].contains(&name);
        if on_manifold {
            self.stay(&bare, &before, &old, transport);
        }
        if epoch.ranges.is_empty() {
            return;
        }
        let (old, before, h) = (rotation(&self.x), self.p.clone(), Self::measurement(recording));
        let sigma = recording.model.sigma;
        let spread = plus(&congruence(&h, &self.p), sigma * sigma, &identity(9));
        let gain = times(&times(&self.p, &transpose(&h)), &inverse(&spread));
        let expected = on(&h, &self.x);
        let innovation = add(&trilateration(recording, epoch, &expected), -1.0, &expected);
        self.x = add(&self.x, 1.0, &on(&gain, &innovation));
        self.p = times(&plus(&identity(15), -1.0, &times(&gain, &h)), &self.p);
        if on_manifold {
            let choices = if name == FilterName::EkfRie { choices } else { &bare };
            self.stay(choices, &before, &old, transport);
        }
    }

    /// Sigma points with their weights, alpha = 1/2.
    fn sigma_points(&self) -> Vec<(f64, Vector)> {
        self.sigma_points_at(0.5)
    }

    /// Those of an alpha, kappa = 1.
    fn sigma_points_at(&self, alpha: f64) -> Vec<(f64, Vector)> {
        let squared = alpha * alpha * 16.0;
        let l = cholesky(&self.p);
        let mut points = vec![(1.0 - 15.0 / squared, self.x.clone())];
        for j in 0..15 {
            let column: Vector = (0..15).map(|i| l[i][j] * f64::sqrt(squared)).collect();
            points.push((0.5 / squared, add(&self.x, 1.0, &column)));
            points.push((0.5 / squared, add(&self.x, -1.0, &column)));
        }
        points
    }

    /// The points at which step 5 takes the noise of the input, with its weights.
    fn noise_points(&self, choices: &Choices) -> Vec<(f64, Vector)> {
        if choices.squared_weights {
            return self.sigma_points_at(1e-3).into_iter().map(|(xi, x)| (xi * xi, x)).collect();
        }
        self.sigma_points()
    }

    /// One step of UKF and UKFRie.
    pub fn unscented(
        &mut self,
        recording: &IndoorRecording,
        epoch: &IndoorEpoch,
        name: FilterName,
        choices: &Choices,
    ) {
        let on_manifold = name == FilterName::UkfRie;
        let (old, before) = (rotation(&self.x), self.p.clone());
        let points = self.sigma_points();
        let noisy = self.noise_points(choices);
        let moved: Vec<_> = points.iter().map(|(xi, x)| (*xi, Self::moved(recording, epoch, x))).collect();
        self.x = mean(&moved);
        self.p = covariance(&moved, &self.x, &moved, &self.x);
        for (xi, x) in &noisy {
            self.p = plus(&self.p, *xi, &Self::noise(recording, epoch, x));
        }
        if on_manifold {
            let in_time =
                if choices.transport == Transport::Congruence { Transport::None } else { choices.transport };
            self.stay(&Choices { tangent_correction: false, ..*choices }, &before, &old, in_time);
        }
        if epoch.ranges.is_empty() {
            return;
        }
        let (old, before, h) = (rotation(&self.x), self.p.clone(), Self::measurement(recording));
        let centre = self.x.clone();
        let points = self.sigma_points();
        let expected: Vec<_> = points.iter().map(|(xi, x)| (*xi, on(&h, x))).collect();
        let y = mean(&expected);
        let sigma = recording.model.sigma;
        let spread = plus(&covariance(&expected, &y, &expected, &y), sigma * sigma, &identity(9));
        let cross = if on_manifold && choices.transport == Transport::Literal {
            covariance(&moved, &mean(&moved), &expected, &y)
        } else {
            covariance(&points, &centre, &expected, &y)
        };
        let gain = times(&cross, &inverse(&spread));
        let innovation = add(&trilateration(recording, epoch, &y), -1.0, &y);
        self.x = add(&self.x, 1.0, &on(&gain, &innovation));
        self.p = plus(&self.p, -1.0, &congruence(&gain, &spread));
        if on_manifold {
            self.stay(choices, &before, &old, choices.transport);
        }
    }
}

fn mean(points: &[(f64, Vector)]) -> Vector {
    points.iter().fold(vec![0.0; points[0].1.len()], |sum, (xi, x)| add(&sum, *xi, x))
}

fn covariance(a: &[(f64, Vector)], a_mean: &[f64], b: &[(f64, Vector)], b_mean: &[f64]) -> Matrix {
    let mut sum = zeros(a_mean.len(), b_mean.len());
    for ((xi, x), (_, y)) in a.iter().zip(b) {
        let (dx, dy) = (add(x, -1.0, a_mean), add(y, -1.0, b_mean));
        for i in 0..dx.len() {
            for j in 0..dy.len() {
                sum[i][j] += xi * dx[i] * dy[j];
            }
        }
    }
    sum
}
