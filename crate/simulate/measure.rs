//! What the sensors measure.

use alloc::vec::Vec;

use super::random::Stream;
use crate::error::Result;
use crate::math::float::{ratio_from_db, sqrt};
use crate::model::noise::RangeNoise;
use crate::model::ranges::Ranges;
use crate::model::ranging::RangeModel;

/// Disturbs exact squared ranges and loses some.
///
/// ```text
/// squared_range   d = r^2 + sigma r n     \[T\] below eq. 1, each pair by its own range
/// toa             d = (r + r n/sqrt(zeta))^2
/// range           d = (r + sigma n)^2
/// ```
///
/// with `n ~ N(0, 1)` for each pair. Each pair draws a uniform number, which loses the range if it is below
/// `missing_probability`, then `n`, needed or not, also where it is not `measurable` (a flag for each pair); pairs go anchor by anchor, sensor by sensor. That the papers give all
/// sensors the variance of the first is a simplification of the weights, not of nature: see
/// [`Weighting::Common`](crate::model::ranging::Weighting::Common).
///
/// # Errors
/// [`crate::Error::Number`] where a squared range overflows.
pub fn measure<const D: usize>(
    model: &RangeModel<D>,
    exact: &Ranges,
    measurable: &[bool],
    missing_probability: f64,
    stream: &mut Stream,
) -> Result<Ranges> {
    let (anchors, sensors) = (exact.anchors(), exact.sensors());
    let draws: Vec<Draw> = (0..anchors * sensors).map(|_| Draw::new(missing_probability, stream)).collect();
    let squared = |m: usize, n: usize| exact.get(m, n).unwrap_or_default();
    Ranges::from_fn(anchors, sensors, |m, n| {
        let Draw { lost, normal } = draws[m * sensors + n];
        (measurable[m * sensors + n] && !lost).then(|| disturbed(model.noise(), squared(m, n), normal))
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

/// The squared range measured.
fn disturbed(noise: &RangeNoise, squared: f64, normal: f64) -> f64 {
    let square = |x: f64| x * x;
    match *noise {
        RangeNoise::SquaredRange { sigma } => squared + sigma * sqrt(squared) * normal,
        RangeNoise::Toa { zeta_db } => squared * square(1.0 + normal / sqrt(ratio_from_db(zeta_db))),
        RangeNoise::Range { sigma } => square(sqrt(squared) + sigma * normal),
    }
}
