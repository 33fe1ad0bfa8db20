//! The squared ranges of one epoch, some of which may be missing.

use alloc::vec::Vec;

use crate::error::{Error, Result};

/// Squared ranges `d_mn` (m^2) between M anchors and N sensors.
///
/// They are kept sensor by sensor. A missing range is kept as NaN inside and never leaves this type as a number.
#[derive(Clone, Debug)]
pub struct Ranges {
    anchors: usize,
    sensors: usize,
    squared: Vec<f64>,
    missing: usize,
}

impl Ranges {
    /// Takes the squared ranges from a function of (anchor, sensor); `None` is missing.
    ///
    /// # Errors
    /// [`Error::Number`] for a squared range that is not finite.
    ///
    /// ```
    /// use rangelab::model::ranges::Ranges;
    /// let ranges = Ranges::from_fn(2, 3, |m, n| (m != n).then_some(4.0))?;
    /// assert_eq!((ranges.get(0, 0), ranges.get(0, 1), ranges.missing()), (None, Some(4.0), 2));
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn from_fn(
        anchors: usize,
        sensors: usize,
        mut squared_range: impl FnMut(usize, usize) -> Option<f64>,
    ) -> Result<Self> {
        let mut squared = Vec::with_capacity(anchors * sensors);
        let mut missing = 0;
        for n in 0..sensors {
            for m in 0..anchors {
                let value = squared_range(m, n);
                match value {
                    Some(d) if !d.is_finite() => {
                        return Err(Error::Number {
                            what: "a squared range",
                            value: d,
                            limit: "finite, or null if missing",
                        });
                    }
                    Some(d) => squared.push(d),
                    None => {
                        missing += 1;
                        squared.push(f64::NAN);
                    }
                }
            }
        }
        Ok(Self { anchors, sensors, squared, missing })
    }

    /// Squared range between anchor `m` and sensor `n`, m^2.
    pub fn get(&self, m: usize, n: usize) -> Option<f64> {
        let d = self.squared[n * self.anchors + m];
        (!d.is_nan()).then_some(d)
    }

    /// Number of anchors.
    pub fn anchors(&self) -> usize {
        self.anchors
    }

    /// Number of sensors.
    pub fn sensors(&self) -> usize {
        self.sensors
    }

    /// The pairs (anchor, sensor) whose range is missing, sensor by sensor.
    pub fn missing_pairs(&self) -> impl Iterator<Item = (usize, usize)> {
        let missing = self.squared.iter().enumerate().filter(|(_, d)| d.is_nan());
        missing.map(|(index, _)| (index % self.anchors, index / self.anchors))
    }

    /// Number of missing ranges.
    pub fn missing(&self) -> usize {
        self.missing
    }

    /// The squared ranges of one sensor, anchor by anchor; NaN is missing.
    #[inline]
    pub(crate) fn of_sensor(&self, n: usize) -> &[f64] {
        &self.squared[n * self.anchors..(n + 1) * self.anchors]
    }
}

impl PartialEq for Ranges {
    /// Equal sizes and equal ranges; missing equals missing.
    fn eq(&self, other: &Self) -> bool {
        self.anchors == other.anchors
            && self.sensors == other.sensors
            && self.squared.iter().zip(&other.squared).all(|(a, b)| a.to_bits() == b.to_bits())
    }
}
