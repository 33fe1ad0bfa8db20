//! Collects all that is wrong with a document: path, value, limit.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Display};

use nalgebra::SMatrix;

use super::entries::{PoseEntries, matrix_from_rows};
use super::{VERSION, write};
use crate::error::{Error, Problem, Result};
use crate::math::rotation::Rotation;
use crate::model::noise::RangeNoise;

/// Most anchors, and most sensors.
pub const MAX_POINTS: usize = 1000;
/// Most steps of a scenario, and most epochs of a recording.
pub const MAX_STEPS: usize = 10_000;
/// Most ranges of all epochs together (anchors times sensors times steps).
pub const MAX_RANGES: usize = 20_000_000;
/// Longest name, in bytes.
pub const MAX_NAME: usize = 200;
/// Seeds up to here are exact in JavaScript.
const MAX_SEED: u64 = 1 << 53;
/// Longest `view` as JSON, in bytes.
const MAX_VIEW: usize = 10_000;

/// The numbers that are allowed at one place.
#[derive(Clone, Copy)]
pub struct Limit {
    least: f64,
    most: f64,
    open: bool,
    unit: &'static str,
}

impl Limit {
    pub const COORDINATE: Self = Self::from(-1e9, 1e9, " m");
    pub const LENGTH: Self = Self::above_zero(1e9, " m");
    pub const POSITION_NOISE: Self = Self::from(0.0, 1e9, " m");
    pub const VELOCITY: Self = Self::from(-1e9, 1e9, " m/s");
    pub const ANGULAR_VELOCITY: Self = Self::from(-1e6, 1e6, " rad/s");
    pub const ANGULAR_VELOCITY_NOISE: Self = Self::from(0.0, 1e6, " rad/s");
    pub const ANGLE_NOISE: Self = Self::from(0.0, 1e6, " rad");
    pub const ANGLE: Self = Self::from(-1e3, 1e3, " rad");
    pub const ANGLE_LIMIT: Self = Self::above_zero(1e6, " rad");
    pub const SPEED_LIMIT: Self = Self::above_zero(1e6, " m/s");
    pub const INTERVAL: Self = Self::above_zero(1e6, " s");
    pub const PERIOD: Self = Self::from(1e-6, 1e9, " s");
    pub const PROBABILITY: Self = Self::from(0.0, 1.0, "");
    pub const VARIANCE: Self = Self::above_zero(1e12, "");
    pub const EPSILON: Self = Self::from(0.0, 1e6, "");
    pub const HUBER_SCALE: Self = Self::above_zero(1e6, " standard deviations");
    pub const ENTRY: Self = Self::from(-1e6, 1e6, "");
    /// A sample is held for at most a minute (`inertial::filter::LONGEST_GAP`).
    pub const RATE: Self = Self::from(0.02, 1e5, " Hz");
    pub const DENSITY: Self = Self::from(0.0, 1e6, "");
    pub const ACCELERATION: Self = Self::from(-1e6, 1e6, " m/s^2");
    pub const ACCELERATION_NOISE: Self = Self::from(0.0, 1e6, " m/s^2");
    pub const KINEMATIC: Self = Self::from(-1e9, 1e9, " m/s^l");
    pub const GRAVITY: Self = Self::from(0.0, 1e3, " m/s^2");
    pub const RANGE: Self = Self::from(0.0, 1e10, " m");
    pub const SQUARED_RANGE: Self = Self::from(-1e20, 1e20, " m^2");

    const fn from(least: f64, most: f64, unit: &'static str) -> Self {
        Self { least, most, open: false, unit }
    }

    const fn above_zero(most: f64, unit: &'static str) -> Self {
        Self { least: 0.0, most, open: true, unit }
    }

    /// False for NaN too.
    pub fn allows(&self, value: f64) -> bool {
        value <= self.most && if self.open { value > self.least } else { value >= self.least }
    }
}

impl Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { least, most, open, unit } = self;
        let (least, most) = (Readable(*least), Readable(*most));
        if *open {
            write!(f, "above {least} and at most {most}{unit}")
        } else {
            write!(f, "from {least} to {most}{unit}")
        }
    }
}

/// A number as people write it: with an exponent where it would be long.
pub struct Readable(pub f64);

impl Display for Readable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(x) = self;
        if *x == 0.0 || !x.is_finite() || (1e-4..1e6).contains(&x.abs()) {
            write!(f, "{x}")
        } else {
            write!(f, "{x:e}")
        }
    }
}

/// The problems found so far.
#[derive(Default)]
pub struct Check {
    problems: Vec<Problem>,
}

impl Check {
    pub fn into_problems(self) -> Vec<Problem> {
        self.problems
    }

    pub fn problem(&mut self, path: impl Display, value: impl Display, limit: impl Display) {
        self.problems.push(Problem {
            path: path.to_string(),
            value: value.to_string(),
            limit: limit.to_string(),
        });
    }

    pub fn number(&mut self, path: impl Display, value: f64, limit: Limit) {
        if !limit.allows(value) {
            self.problem(path, Readable(value), limit);
        }
    }

    pub fn count(&mut self, path: impl Display, found: usize, least: usize, most: usize) {
        if !(least..=most).contains(&found) {
            self.problem(path, format_args!("{found} long"), format_args!("{least} to {most} entries"));
        }
    }

    pub fn version(&mut self, version: u32) {
        if version != VERSION {
            self.problem("version", version, VERSION);
        }
    }

    pub fn name(&mut self, name: &str) {
        if name.len() > MAX_NAME {
            self.problem(
                "name",
                format_args!("{} bytes long", name.len()),
                format_args!("at most {MAX_NAME} bytes"),
            );
        }
    }

    pub fn seed(&mut self, seed: u64) {
        if seed > MAX_SEED {
            self.problem("seed", seed, format_args!("0 to {MAX_SEED} (2^53)"));
        }
    }

    pub fn view(&mut self, view: Option<&serde_json::Value>) {
        let Some(view) = view else { return };
        if !view.is_object() {
            self.problem("view", view, "null or an object");
        }
        let length = write(view).len();
        if length > MAX_VIEW {
            self.problem(
                "view",
                format_args!("{length} bytes long"),
                format_args!("at most {MAX_VIEW} bytes"),
            );
        }
    }

    /// The dimension if it is one; lengths of vectors are checked against nothing else.
    pub fn dimension(&mut self, dimension: usize) -> Option<usize> {
        if !(2..=3).contains(&dimension) {
            self.problem("dimension", dimension, "2 or 3");
            return None;
        }
        Some(dimension)
    }

    pub fn vector(&mut self, path: impl Display, vector: &[f64], length: Option<usize>, limit: Limit) {
        if let Some(length) = length
            && vector.len() != length
        {
            self.problem(&path, format_args!("{} long", vector.len()), format_args!("{length} numbers"));
        }
        for (i, &value) in vector.iter().enumerate() {
            self.number(format_args!("{path}[{i}]"), value, limit);
        }
    }

    pub fn points(&mut self, path: &str, points: &[Vec<f64>], dimension: Option<usize>) {
        self.count(path, points.len(), 1, MAX_POINTS);
        for (i, point) in points.iter().enumerate() {
            self.vector(format_args!("{path}[{i}]"), point, dimension, Limit::COORDINATE);
        }
    }

    /// A box along the axes: each of its edges has some length.
    pub fn region(&mut self, path: impl Display, low: &[f64], high: &[f64], dimension: Option<usize>) {
        self.vector(format_args!("{path}.low"), low, dimension, Limit::COORDINATE);
        self.vector(format_args!("{path}.high"), high, dimension, Limit::COORDINATE);
        for (i, (low, high)) in low.iter().zip(high).enumerate() {
            if low >= high {
                let limit = format_args!("above {}, where the box begins", Readable(*low));
                self.problem(format_args!("{path}.high[{i}]"), Readable(*high), limit);
            }
        }
    }

    pub fn matrix(&mut self, path: impl Display, rows: &[Vec<f64>], dimension: Option<usize>) {
        if let Some(dimension) = dimension
            && rows.len() != dimension
        {
            self.problem(&path, format_args!("{} rows", rows.len()), format_args!("{dimension} rows"));
        }
        for (i, row) in rows.iter().enumerate() {
            self.vector(format_args!("{path}[{i}]"), row, dimension, Limit::ENTRY);
        }
    }

    pub fn pose(&mut self, path: impl Display, pose: &PoseEntries, dimension: Option<usize>) {
        let before = self.problems.len();
        self.matrix(format_args!("{path}.orientation"), &pose.orientation, dimension);
        if self.problems.len() == before {
            let refused = match dimension {
                Some(2) => rotation_problem::<2>(&pose.orientation),
                Some(3) => rotation_problem::<3>(&pose.orientation),
                _ => None,
            };
            if let Some((value, limit)) = refused {
                self.problem(format_args!("{path}.orientation"), value, limit);
            }
        }
        self.vector(format_args!("{path}.position"), &pose.position, dimension, Limit::COORDINATE);
    }

    pub fn noise(&mut self, noise: &RangeNoise) {
        let field = if matches!(noise, RangeNoise::Toa { .. }) { "noise.zeta_db" } else { "noise.sigma" };
        if let Err(Error::Number { value, limit, .. }) = noise.check() {
            self.problem(field, Readable(value), limit);
        }
    }

    pub fn total_ranges(&mut self, path: &str, anchors: usize, sensors: usize, steps: usize) {
        let total = anchors.saturating_mul(sensors).saturating_mul(steps);
        if total > MAX_RANGES {
            self.problem(
                path,
                format_args!(
                    "{steps}: {anchors} anchors x {sensors} sensors x {steps} steps = {total} ranges"
                ),
                format_args!("at most {MAX_RANGES} ranges in all"),
            );
        }
    }
}

/// The document if nothing is wrong with it.
pub fn accept(document: &'static str, problems: Vec<Problem>) -> Result<()> {
    if problems.is_empty() { Ok(()) } else { Err(Error::Invalid { document, problems }) }
}

fn rotation_problem<const D: usize>(rows: &[Vec<f64>]) -> Option<(String, &'static str)> {
    let matrix: SMatrix<f64, D, D> = matrix_from_rows(rows);
    match Rotation::from_matrix(&matrix) {
        Err(Error::Number { what, value, limit }) => Some((format!("{} in {what}", Readable(value)), limit)),
        _ => None,
    }
}
