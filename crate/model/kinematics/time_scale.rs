//! Time scaled to [-1, 1], where powers of it stay apart.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::coefficients::RelativeKinematics;
use super::stamps::earliest_and_latest;
use crate::error::{Error, Result};

/// Coefficients by time stay below it: of a range's the eighth power is taken, for the spread of squared errors of its square.
const MAX_COEFFICIENT: f64 = 1e37;

/// `s = (t - middle)/half`, which takes the first stamp to -1 and the last to 1.
///
/// ```
/// use rangelab::model::kinematics::time_scale::TimeScale;
/// let scale = TimeScale::of(&[4.0, 0.0, 1.0]);
/// assert_eq!((scale.scaled(0.0), scale.scaled(4.0), scale.time(0.5)), (-1.0, 1.0, 3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeScale {
    /// The instant that becomes 0, s.
    pub middle: f64,
    /// Half the time between first and last stamp, s; 1 where all stamps are one.
    pub half: f64,
}

impl TimeScale {
    /// The scale of some stamps, in any order.
    pub fn of(stamps: &[f64]) -> Self {
        let [first, last] = earliest_and_latest(stamps);
        let half = 0.5 * (last - first);
        Self { middle: 0.5 * (first + last), half: if half > 0.0 { half } else { 1.0 } }
    }

    /// Scaled time of an instant.
    pub fn scaled(&self, time: f64) -> f64 {
        (time - self.middle) / self.half
    }

    /// The instant (s) of a scaled time.
    pub fn time(&self, scaled: f64) -> f64 {
        self.middle + self.half * scaled
    }

    /// `Z_l = half^l sum_{m >= l} Y_m middle^(m-l)/(m-l)!`, the derivatives by scaled time in the middle.
    pub fn scale(&self, kinematics: &RelativeKinematics) -> RelativeKinematics {
        let shifted = shifted(kinematics.coefficients(), self.middle);
        RelativeKinematics::from_coefficients(powers(shifted, self.half))
    }

    /// The derivatives by time at time 0 of what [`TimeScale::scale`] gave.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where one is above 1e37 or no number.
    pub fn unscale(&self, scaled: &RelativeKinematics) -> Result<RelativeKinematics> {
        let in_seconds = powers(scaled.coefficients().to_vec(), 1.0 / self.half);
        let coefficients = shifted(&in_seconds, -self.middle);
        if coefficients.iter().flatten().all(|value| value.abs() <= MAX_COEFFICIENT) {
            return Ok(RelativeKinematics::from_coefficients(coefficients));
        }
        let reason = "Half of the time between the first stamp and the last is that many seconds: divided by its powers and \
                      carried to time 0, what was measured grows beyond all numbers.";
        Err(Error::Degenerate { what: "the polynomial of time", value: self.half, reason })
    }
}

/// Derivatives at `by` instead of 0.
fn shifted(coefficients: &[DMatrix<f64>], by: f64) -> Vec<DMatrix<f64>> {
    let at = |l: usize| {
        let mut sum = coefficients[l].clone();
        let mut factor = 1.0;
        for m in l + 1..coefficients.len() {
            factor *= by / (m - l) as f64;
            sum += &coefficients[m] * factor;
        }
        sum
    };
    (0..coefficients.len()).map(at).collect()
}

/// Coefficient l times `factor^l`.
fn powers(mut coefficients: Vec<DMatrix<f64>>, factor: f64) -> Vec<DMatrix<f64>> {
    let mut power = 1.0;
    for coefficient in &mut coefficients {
        *coefficient *= power;
        power *= factor;
    }
    coefficients
}
