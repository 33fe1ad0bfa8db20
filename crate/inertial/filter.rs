//! What all inertial filters share: one trait, one record of a step.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use crate::error::{Error, Result};
use crate::math::cholesky::Cholesky;
use crate::math::rotation::{Manifold, Rotation};
use crate::model::indoor::epoch::{IndoorEpoch, NavigationState};

/// Error coordinates `(phi, p, v)`: `R_true = R Exp(phi)`, position and velocity in the world frame.
pub type ErrorVector = SVector<f64, 9>;

/// A covariance of [`ErrorVector`].
pub type ErrorMatrix = SMatrix<f64, 9, 9>;

/// A recursive filter of orientation, position and velocity.
pub trait InertialFilter {
    /// Integrates the sample over the epoch's interval, then updates with its ranges, if there are any.
    ///
    /// A transmitter with fewer than four ranges gives no position and is left out of the update; where none gives one,
    /// the update is. The filter on ranges uses each single one.
    ///
    /// # Errors
    /// A typed error for an interval, a sample or a range that is not finite or out of its limits, and where the
    /// arithmetic leaves double precision; the filter keeps its state from before the step.
    fn step(&mut self, epoch: &IndoorEpoch) -> Result<InertialStep>;
}

/// What came of one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InertialStep {
    /// `R` as the filter keeps it; no rotation where nothing makes it one.
    pub orientation: Matrix3<f64>,
    /// Position in the world frame, m.
    pub position: Vector3<f64>,
    /// Velocity in the world frame, m/s.
    pub velocity: Vector3<f64>,
    /// What the filter believes about its error, on the tangent space at its rotation.
    pub covariance: ErrorMatrix,
    /// The fix that was used, if there was one.
    pub fix: Option<FixRecord>,
    /// What else happened.
    pub events: Events,
}

/// What an update made of a fix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixRecord {
    /// Normalized innovation squared.
    pub nis: f64,
    /// Its degrees of freedom: coordinates of positions, or ranges.
    pub degrees_of_freedom: usize,
}

/// What does not happen in every step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Events {
    /// The covariance was replaced by the nearest positive definite matrix, so many times.
    pub repairs: usize,
    /// A Q-factor was a reflection and its third column was turned.
    pub reflected: bool,
}

impl InertialStep {
    /// The orientation as a rotation: the polar factor where it is not one already.
    pub fn rotation(&self) -> Rotation<3> {
        Rotation::project(&self.orientation, Manifold::So)
    }

    /// The error against the truth, `(phi, p, v)`.
    pub fn error(&self, truth: &NavigationState) -> ErrorVector {
        let phi = self.rotation().inverse().compose(&truth.rotation).log();
        let (p, v) = (truth.position - self.position, truth.velocity - self.velocity);
        SVector::from([phi[0], phi[1], phi[2], p[0], p[1], p[2], v[0], v[1], v[2]])
    }

    /// Normalized estimation error squared, of 9 degrees of freedom.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] when the covariance cannot be inverted.
    pub fn nees(&self, truth: &NavigationState) -> Result<f64> {
        let factor = Cholesky::new(&self.covariance).map_err(not_positive)?;
        Ok(factor.inverse_quadratic_form(&self.error(truth)))
    }
}

/// Longest interval over which a sample is held, s.
pub const LONGEST_GAP: f64 = 60.0;

/// Refuses an epoch with numbers that mean nothing.
pub(super) fn check_epoch(epoch: &IndoorEpoch) -> Result<()> {
    if !(epoch.interval > 0.0 && epoch.interval <= LONGEST_GAP) {
        let limit = "above 0 and at most 60 s: a sample cannot be held for longer";
        return Err(Error::Number { what: "the interval of an epoch", value: epoch.interval, limit });
    }
    let sample = &epoch.sample;
    let numbers = [&sample.angular_velocity, &sample.acceleration, &epoch.next_angular_velocity];
    for value in numbers.into_iter().flatten() {
        if !(value.abs() <= LARGEST_SAMPLE) {
            let (what, value) = ("a coordinate of an IMU sample", *value);
            return Err(Error::Number { what, value, limit: "finite and at most 1e6 in size" });
        }
    }
    for range in epoch.ranges.iter().flatten().flatten() {
        if !range.is_finite() {
            return Err(Error::Number {
                what: "a range",
                value: *range,
                limit: "finite, or null if missing",
            });
        }
    }
    Ok(())
}

const LARGEST_SAMPLE: f64 = 1e6;

/// Refuses a result that left double precision.
pub(super) fn require_finite<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> Result<()> {
    match numbers.into_iter().find(|x| !x.is_finite()) {
        Some(&value) => Err(Error::Number {
            what: "a coordinate of the state",
            value,
            limit: "finite: the samples or the time between fixes are too large",
        }),
        None => Ok(()),
    }
}

pub(super) fn not_positive(pivot: f64) -> Error {
    Error::NotPositiveDefinite { what: "the covariance of a filter", pivot }
}
