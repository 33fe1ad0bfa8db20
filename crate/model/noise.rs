//! Noise of ranges, and the variance it gives to squared ranges.

use serde::{Deserialize, Serialize};

use super::ranges::Ranges;
use crate::error::{Error, Result};
use crate::math::float::{ratio_from_db, sqrt};

/// Squared ranges below this (m^2) are weighted as if they were this long, so that a weight stays finite.
pub const SQUARED_RANGE_FLOOR: f64 = 1e-6;

/// How ranges are disturbed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum RangeNoise {
    /// Squared range `d = r^2 + n` with `var n = sigma^2 r^2` (\[T\] below eq. 1).
    SquaredRange {
        /// `sigma`, m.
        sigma: f64,
    },
    /// Time of arrival: range `y = r + v` with `var v = r^2/zeta` (\[L\] eq. 2, corrected), hence `var d = 4 r^4/zeta`.
    Toa {
        /// `zeta = r^2/var(v)` in decibels.
        zeta_db: f64,
    },
    /// Range `y = r + v` with constant `var v = sigma^2`, hence `var d = 4 r^2 sigma^2`.
    Range {
        /// `sigma`, m.
        sigma: f64,
    },
}

impl RangeNoise {
    /// Variance of the squared range (m^4) at a squared range (m^2), to first order in the noise; short ranges are
    /// floored at [`SQUARED_RANGE_FLOOR`].
    ///
    /// ```
    /// use rangelab::model::noise::RangeNoise;
    /// assert_eq!(RangeNoise::SquaredRange { sigma: 0.5 }.squared_range_variance(16.0), 4.0);
    /// assert_eq!(RangeNoise::Range { sigma: 0.5 }.squared_range_variance(16.0), 16.0);
    /// assert_eq!(RangeNoise::Toa { zeta_db: 20.0 }.squared_range_variance(16.0), 4.0 * 256.0 / 100.0);
    /// ```
    pub fn squared_range_variance(&self, squared_range: f64) -> f64 {
        self.law().variance(squared_range)
    }

    /// Root mean square over all pairs of the standard deviation of a range, m: `var y = var d/(4 r^2)`.
    pub fn range_error(&self, ranges: &Ranges) -> f64 {
        let pairs = (0..ranges.sensors()).flat_map(|n| (0..ranges.anchors()).map(move |m| (m, n)));
        let squared = pairs.filter_map(|(m, n)| ranges.get(m, n)).map(|d| d.max(SQUARED_RANGE_FLOOR));
        let (mut sum, mut count) = (0.0, 0.0);
        for d in squared {
            sum += self.squared_range_variance(d) / (4.0 * d);
            count += 1.0;
        }
        if count > 0.0 { sqrt(sum / count) } else { 0.0 }
    }

    /// The variance law with its constants worked out once.
    pub(crate) fn law(&self) -> VarianceLaw {
        match *self {
            Self::SquaredRange { sigma } => VarianceLaw { linear: sigma * sigma, quadratic: 0.0 },
            Self::Toa { zeta_db } => VarianceLaw { linear: 0.0, quadratic: 4.0 / ratio_from_db(zeta_db) },
            Self::Range { sigma } => VarianceLaw { linear: 4.0 * sigma * sigma, quadratic: 0.0 },
        }
    }

    /// Refuses noise that would give infinite or meaningless weights.
    ///
    /// # Errors
    /// [`Error::Number`].
    pub fn check(&self) -> Result<()> {
        match *self {
            Self::SquaredRange { sigma } | Self::Range { sigma } if !(sigma > 0.0 && sigma <= 1e9) => {
                Err(Error::Number {
                    what: "sigma of the range noise",
                    value: sigma,
                    limit: "above 0 and at most 1e9 m",
                })
            }
            Self::Toa { zeta_db } if !(-100.0..=300.0).contains(&zeta_db) => Err(Error::Number {
                what: "zeta of the range noise",
                value: zeta_db,
                limit: "from -100 to 300 dB",
            }),
            _ => Ok(()),
        }
    }
}

/// `var d = linear r^2 + quadratic r^4`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VarianceLaw {
    linear: f64,
    quadratic: f64,
}

impl VarianceLaw {
    /// `linear` and `quadratic`.
    pub(crate) fn coefficients(self) -> [f64; 2] {
        [self.linear, self.quadratic]
    }

    #[inline]
    pub(crate) fn variance(self, squared_range: f64) -> f64 {
        let s = if squared_range > SQUARED_RANGE_FLOOR { squared_range } else { SQUARED_RANGE_FLOOR };
        (self.linear + self.quadratic * s) * s
    }

    /// Derivative of the variance; 0 where it is floored.
    pub(crate) fn slope(self, squared_range: f64) -> f64 {
        let above = squared_range > SQUARED_RANGE_FLOOR;
        if above { self.linear + 2.0 * self.quadratic * squared_range } else { 0.0 }
    }
}
