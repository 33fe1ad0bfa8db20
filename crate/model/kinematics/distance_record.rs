//! What the nodes measured: distances between pairs, and accelerations, at some stamps.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::time_scale::TimeScale;
use crate::error::{Error, Result};

/// The unordered pairs of N nodes in the order of all records: (0, 1), (0, 2), ..., (1, 2), ...
///
/// ```
/// use rangelab::model::kinematics::distance_record::pairs;
/// assert_eq!(pairs(3).collect::<Vec<_>>(), [(0, 1), (0, 2), (1, 2)]);
/// ```
pub fn pairs(nodes: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..nodes).flat_map(move |i| (i + 1..nodes).map(move |j| (i, j)))
}

/// How many unordered pairs N nodes have.
pub fn pair_count(nodes: usize) -> usize {
    nodes * nodes.saturating_sub(1) / 2
}

/// Readings of all accelerometers, in one unknown proper frame that all share.
#[derive(Clone, Debug, PartialEq)]
pub struct Accelerometers {
    /// For each stamp `Q Xdd(t_k) + noise`, D x N, m/s^2, not centred (\[A\] eq. 20).
    pub readings: Vec<DMatrix<f64>>,
    /// Standard deviation of a coordinate, m/s^2; 0 where they are exact.
    pub sigma: f64,
}

/// Distances between N nodes at K stamps, some of which may be missing, and accelerations where there are any.
#[derive(Clone, Debug, PartialEq)]
pub struct DistanceRecord {
    dimension: usize,
    nodes: usize,
    stamps: Vec<f64>,
    /// Stamp by stamp, pair by pair.
    distances: Vec<Option<f64>>,
    sigma: f64,
    accelerometers: Option<Accelerometers>,
}

impl DistanceRecord {
    /// Distances (m) stamp by stamp, each in the order of [`pairs`]; `sigma` (m) is the standard deviation of each.
    ///
    /// A distance near zero may have been measured below zero; it is squared with its sign lost, or compared as it is.
    ///
    /// # Errors
    /// [`Error::Number`] where the dimension is neither 2 nor 3, a stamp or a distance is not finite, or `sigma` is
    /// negative; [`Error::Size`] where the number of distances is not `K N (N - 1)/2`.
    pub fn new(
        dimension: usize,
        nodes: usize,
        stamps: Vec<f64>,
        distances: Vec<Option<f64>>,
        sigma: f64,
    ) -> Result<Self> {
        if !(2..=3).contains(&dimension) {
            return Err(Error::Number { what: "the dimension", value: dimension as f64, limit: "2 or 3" });
        }
        let expected = stamps.len() * pair_count(nodes);
        if distances.len() != expected {
            return Err(Error::Size { what: "distances", found: distances.len(), expected });
        }
        finite("a stamp", stamps.iter().copied())?;
        finite("a distance", distances.iter().copied().flatten())?;
        standard_deviation("the standard deviation of a distance", sigma)?;
        Ok(Self { dimension, nodes, stamps, distances, sigma, accelerometers: None })
    }

    /// The same record with accelerations.
    ///
    /// # Errors
    /// [`Error::Size`] where there is not one D x N matrix for each stamp, [`Error::Number`] where a reading is not
    /// finite or the standard deviation is negative.
    pub fn with_accelerometers(mut self, accelerometers: Accelerometers) -> Result<Self> {
        let (found, expected) = (accelerometers.readings.len(), self.stamps.len());
        if found != expected {
            return Err(Error::Size { what: "stamps with accelerations", found, expected });
        }
        let expected = self.dimension * self.nodes;
        for reading in &accelerometers.readings {
            if reading.shape() != (self.dimension, self.nodes) {
                return Err(Error::Size { what: "accelerations at a stamp", found: reading.len(), expected });
            }
        }
        finite("an acceleration", accelerometers.readings.iter().flatten().copied())?;
        standard_deviation("the standard deviation of an acceleration", accelerometers.sigma)?;
        self.accelerometers = Some(accelerometers);
        Ok(self)
    }

    /// The same record without accelerations.
    #[must_use]
    pub fn without_accelerometers(&self) -> Self {
        Self { accelerometers: None, ..self.clone() }
    }

    /// D.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// N.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// The stamps, s, in the order of the record.
    pub fn stamps(&self) -> &[f64] {
        &self.stamps
    }

    /// How many stamps differ from all others.
    pub fn distinct_stamps(&self) -> usize {
        let mut sorted = self.stamps.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        sorted.len()
    }

    /// The scale that takes the stamps to [-1, 1].
    pub fn time_scale(&self) -> TimeScale {
        TimeScale::of(&self.stamps)
    }

    /// The distances at stamp `k` in the order of [`pairs`], m.
    pub fn distances(&self, k: usize) -> &[Option<f64>] {
        let pairs = pair_count(self.nodes);
        &self.distances[k * pairs..(k + 1) * pairs]
    }

    /// Number of missing distances.
    pub fn missing(&self) -> usize {
        self.distances.iter().filter(|distance| distance.is_none()).count()
    }

    /// Standard deviation of a distance, m; 0 where distances are exact.
    pub fn sigma(&self) -> f64 {
        self.sigma
    }

    /// The accelerations, for an estimator that cannot go without.
    ///
    /// # Errors
    /// [`Error::TooFew`] where there are none.
    pub fn needed_accelerometers(&self, what: &'static str) -> Result<&Accelerometers> {
        let reason = "It takes the accelerations of all nodes at each stamp.";
        let (counted, found, needed) = ("accelerometers", 0, self.nodes);
        self.accelerometers.as_ref().ok_or(Error::TooFew { what, counted, found, needed, reason })
    }

    /// The accelerations, if there are any.
    pub fn accelerometers(&self) -> Option<&Accelerometers> {
        self.accelerometers.as_ref()
    }
}

fn finite(what: &'static str, mut values: impl Iterator<Item = f64>) -> Result<()> {
    values
        .find(|value| !value.is_finite())
        .map_or(Ok(()), |value| Err(Error::Number { what, value, limit: "finite" }))
}

fn standard_deviation(what: &'static str, value: f64) -> Result<()> {
    if value >= 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(Error::Number { what, value, limit: "finite and not negative" })
    }
}
