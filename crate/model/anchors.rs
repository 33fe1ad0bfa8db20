//! Anchors: points of known position in the world.

use alloc::vec::Vec;

use nalgebra::SVector;

use super::spread::Spread;
use crate::error::{Error, Result};

/// Positions of the anchors in the world frame, m.
#[derive(Clone, Debug, PartialEq)]
pub struct Anchors<const D: usize> {
    positions: Vec<SVector<f64, D>>,
}

impl<const D: usize> Anchors<D> {
    /// Takes at least one anchor with finite coordinates.
    ///
    /// # Errors
    /// [`Error::Size`] without anchors, [`Error::Number`] for a coordinate that is not finite.
    pub fn new(positions: Vec<SVector<f64, D>>) -> Result<Self> {
        require_points("anchors", &positions)?;
        Ok(Self { positions })
    }

    /// The positions, m.
    pub fn positions(&self) -> &[SVector<f64, D>] {
        &self.positions
    }

    /// Number of anchors `M`.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Never: there is at least one anchor.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// How the anchors fill their space.
    pub fn spread(&self) -> Spread<D> {
        Spread::of(&self.positions)
    }
}

pub(super) fn require_points<const D: usize>(what: &'static str, points: &[SVector<f64, D>]) -> Result<()> {
    if points.is_empty() {
        return Err(Error::Size { what, found: 0, expected: 1 });
    }
    match points.iter().flat_map(|p| p.iter()).find(|x| !x.is_finite()) {
        Some(&value) => Err(Error::Number { what: "a coordinate", value, limit: "finite" }),
        None => Ok(()),
    }
}
