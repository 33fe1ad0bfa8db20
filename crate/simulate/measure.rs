//! What the sensors measure.

use alloc::vec::Vec;

use super::random::Stream;
use crate::error::Result;
use crate::math::float::{ratio_from_db, sqrt};
use crate::model::noise::RangeNoise;
use crate::model::ranges::Ranges;
use crate::model::ranging::{RangeModel, Weighting};

/// Disturbs exact squared ranges and loses some.
///
/// ```text
/// squared_range   d = r^2 + sigma r_1 n     [T] below eq. 1: the variance sigma^2 ||a_m - s_1||^2 is that of sensor 1
///                 d = r^2 + sigma r n       the same pair by pair, where the weighting is
/// toa             d = (r + r n/sqrt(zeta))^2
/// range           d = (r + sigma n)^2
/// ```
///
/// with `n ~ N(0, 1)` for each pair. Each pair draws a uniform number, which loses the range if it is below
/// `missing_probability`, then `n`, needed or not; pairs go anchor by anchor, sensor by sensor.
///
/// # Errors
/// [`crate::Error::Number`] where a squared range overflows.
pub fn measure<const D: usize>(
    model: &RangeModel<D>,
    exact: &Ranges,
    missing_probability: f64,
    stream: &mut Stream,
) -> Result<Ranges> {
    let (anchors, sensors) = (exact.anchors(), exact.sensors());
    let draws: Vec<Draw> = (0..anchors * sensors).map(|_| Draw::new(missing_probability, stream)).collect();
    let squared = |m: usize, n: usize| exact.get(m, n).unwrap_or_default();
    Ranges::from_fn(anchors, sensors, |m, n| {
        let spread_at = if model.weighting() == Weighting::Common { 0 } else { n };
        let Draw { lost, normal } = draws[m * sensors + n];
        (!lost).then(|| disturbed(model.noise(), squared(m, n), squared(m, spread_at), normal))
    })
}

#[derive(Clone, Copy)]
struct Draw {
    lost: bool,
    normal: f64,
}

impl Draw {
    fn new(missing_probability: f64, stream: &mut Stream) -> Self {
        let lost = stream.uniform() < missing_probability;
        Self { lost, normal: stream.normal() }
    }
}

/// The squared range measured; `spread_at` is the squared range whose root scales the noise of [T].
fn disturbed(noise: &RangeNoise, squared: f64, spread_at: f64, normal: f64) -> f64 {
    let square = |x: f64| x * x;
    match *noise {
        RangeNoise::SquaredRange { sigma } => squared + sigma * sqrt(spread_at) * normal,
        RangeNoise::Toa { zeta_db } => squared * square(1.0 + normal / sqrt(ratio_from_db(zeta_db))),
        RangeNoise::Range { sigma } => square(sqrt(squared) + sigma * normal),
    }
}
