//! Random numbers: one small generator for each part of each trial.

use rand::RngExt;
use rand_distr::StandardNormal;
use rand_pcg::Pcg64Mcg;

/// What random numbers are for. Each part has a generator of its own, so that more draws of one part do not move those
/// of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Anchors that are drawn anew.
    Anchors,
    /// Disturbances of the motion.
    Motion,
    /// Ranges of one epoch.
    Epoch(usize),
    /// Displacements of the sensors on the body.
    Mounting,
}

/// The largest number of a part whose four rounds still have numbers of their own; no epoch comes near it.
const LAST: u64 = u64::MAX / 4;

/// The random numbers of one part of one trial.
///
/// Seed, trial and part pick a starting point of PCG XSL 128/64 (MCG) by four Feistel rounds of `SplitMix64`'s finalizer:
/// for each part a one-to-one map of (seed, trial) to 128 bits, of which the generator uses 126. Neighbouring seeds and
/// trials start at unrelated points of a period of 2^126.
#[derive(Clone, Debug)]
pub struct Stream(Pcg64Mcg);

impl Stream {
    /// The stream of a part.
    pub fn new(seed: u64, trial: u64, part: Part) -> Self {
        let part = match part {
            Part::Anchors => 0,
            Part::Motion => 1,
            Part::Epoch(k) => 2 + k as u64,
            Part::Mounting => LAST,
        };
        let (mut high, mut low) = (seed, trial);
        for round in 0..4 {
            (high, low) = (low, high ^ mix(low ^ mix(4 * part + round)));
        }
        Self(Pcg64Mcg::new((u128::from(high) << 64) | u128::from(low)))
    }

    /// Uniform on `[0, 1)`.
    pub fn uniform(&mut self) -> f64 {
        self.0.random()
    }

    /// Normal with mean 0 and variance 1.
    pub fn normal(&mut self) -> f64 {
        self.0.sample(StandardNormal)
    }
}

/// `SplitMix64`: the golden ratio step, then its finalizer.
fn mix(x: u64) -> u64 {
    let mut z = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
