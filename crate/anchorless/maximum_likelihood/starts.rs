//! Where descents from distances begin: at the synchronized motion, and at simpler ones where that ends at a wrong minimum.

use super::pair_cost::PairCosts;
use super::{Found, descended};
use crate::anchorless::synchronization::synchronized;
use crate::error::{Error, Result};
use crate::math::float::sqrt;
use crate::math::rotation::rotation_angles;
use crate::model::kinematics::distance_record::{DistanceRecord, pair_count};

/// The cost of the right minimum is above [`most`] with no more than the probability `exp(-14)`, a millionth.
const RARITY: f64 = 14.0;

/// The minimum next to the motion that synchronization finds.
///
/// Where nodes hardly accelerate, distances barely tell motions of a higher degree apart, synchronization may end far off, and
/// the descent in a minimum of its own. Such a one is known by its cost, which is no draw of chi-square: then starts of lower
/// degrees are tried as well, and the least minimum is the one that is meant.
///
/// # Errors
/// As [`synchronized`] and [`descended`], of the first start.
pub fn from_synchronized(record: &DistanceRecord, pairs: &PairCosts) -> Result<Found> {
    let degree = pairs.degree();
    let from = |lower: usize| {
        let start = synchronized(record, lower)?.motion.with_degree(degree);
        descended(record, pairs, None, &start)
    };
    let limit = most(record, degree);
    let mut best = from(degree);
    for lower in (0..degree).rev() {
        let settled = match &best {
            Ok(found) => found.cost <= limit,
            Err(error) => !matches!(error, Error::NoConvergence { .. }),
        };
        if settled {
            break;
        }
        best = better(best, from(lower));
    }
    best
}

/// What a sum of squares of `n` normal numbers is almost never above: `n + 2 sqrt(n x) + 2 x` with the probability `exp(-x)`
/// (Laurent and Massart 2000, lemma 1), `n` being the numbers that pairs say less those that a motion has.
fn most(record: &DistanceRecord, degree: usize) -> f64 {
    let (nodes, dimension) = (record.nodes(), record.dimension());
    let said = pair_count(nodes) * (2 * degree + 1);
    let found = nodes.saturating_sub(1) * dimension * (degree + 1);
    let n = (said + rotation_angles(dimension)).saturating_sub(found) as f64;
    n + 2.0 * sqrt(n * RARITY) + 2.0 * RARITY
}

/// The one with the lower cost, and the iterations of both.
fn better(one: Result<Found>, other: Result<Found>) -> Result<Found> {
    match (one, other) {
        (Ok(one), Ok(other)) => {
            let iterations = one.iterations + other.iterations;
            let least = if other.cost < one.cost { other } else { one };
            Ok(Found { iterations, ..least })
        }
        (Ok(found), Err(_)) | (Err(_), Ok(found)) => Ok(found),
        (Err(error), Err(_)) => Err(error),
    }
}
