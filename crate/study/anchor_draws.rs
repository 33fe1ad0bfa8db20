//! Anchors fixed against anchors redrawn, and how well their lie is conditioned against the errors.

use alloc::vec::Vec;

use nalgebra::SVector;

use super::error::PoseError;
use super::flat::{Flat, Numbers};
use super::monte_carlo::{MonteCarlo, TRIALS_PER_BLOCK};
use crate::bounds::{BoundKind, bounds_along};
use crate::error::{Error, Result};
use crate::math::float::sqrt;
use crate::model::epoch::Recording;
use crate::model::estimator_settings::{EstimatorName, EstimatorSettings};
use crate::model::scenario::{RedrawAnchors, Scenario};
use crate::model::spread::{RANK_TOLERANCE, singular_values};
use crate::simulate::simulate;
use crate::track::estimator;
use crate::with_dimension;

/// The estimators that every draw is given to: without and with the constraint that `Q` is a rotation.
pub const ESTIMATORS: [EstimatorName; 2] = [EstimatorName::Kf, EstimatorName::UcKf];

/// Draw `i` is trial `i` of the scenario twice: with its own anchors, and with anchors drawn anew; all other random
/// numbers are the same.
///
/// New anchors are uniform in the cube that the scenario redraws in, else in the least one around the origin that
/// holds its own anchors.
#[derive(Clone, Debug)]
pub struct AnchorDraws {
    fixed: Scenario,
    redrawn: Scenario,
    draws: usize,
}

/// Root mean squares over one run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Rotation angle, rad.
    pub angle: f64,
    /// Position, m.
    pub position: f64,
}

/// One run over one set of anchors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Draw {
    /// Largest over least singular value of `Abar`, the anchors around their weighted mean, whitened by what the ranges
    /// to the body at its first pose weigh; `None` where they lie in a plane (in 2-D: on a line).
    pub condition: Option<f64>,
    /// The posterior CRB on the rotations; `None` where it does not exist at every step.
    pub bound: Option<Deviation>,
    /// Errors of [`ESTIMATORS`]; `None` where one ended in a typed error.
    pub errors: [Option<Deviation>; 2],
}

/// A trial with the scenario's own anchors and with new ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// With its own.
    pub fixed: Draw,
    /// With new ones.
    pub redrawn: Draw,
}

impl AnchorDraws {
    /// Prepares a study.
    ///
    /// # Errors
    /// Where the scenario is not valid, or the number of draws is 0 or above [`super::monte_carlo::MAX_TRIALS`].
    pub fn new(scenario: &Scenario, draws: usize) -> Result<Self> {
        let farthest = scenario.anchors.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        let redraw = scenario.redraw_anchors.unwrap_or(RedrawAnchors { half_width: farthest });
        let with = |redraw_anchors| Scenario { redraw_anchors, ..scenario.clone() };
        let (fixed, redrawn) = (with(None), with(Some(redraw)));
        MonteCarlo::new(&fixed, draws)?;
        MonteCarlo::new(&redrawn, draws)?;
        Ok(Self { fixed, redrawn, draws })
    }

    /// Half the width of the cube around the origin that new anchors are drawn in, m.
    pub fn half_width(&self) -> f64 {
        self.redrawn.redraw_anchors.map_or(0.0, |redraw| redraw.half_width)
    }

    /// How many blocks of [`TRIALS_PER_BLOCK`] draws there are.
    pub fn blocks(&self) -> usize {
        self.draws.div_ceil(TRIALS_PER_BLOCK)
    }

    /// The draws of block `index`, from 0. All draws are the blocks one after the other.
    ///
    /// # Errors
    /// When a simulated recording is beyond double precision.
    pub fn block(&self, index: usize) -> Result<Vec<Pair>> {
        let first = index * TRIALS_PER_BLOCK;
        let trials = first..self.draws.min(first + TRIALS_PER_BLOCK);
        with_dimension!(self.fixed.dimension, D => {
            let draw = |scenario: &Scenario, trial| draw(&simulate::<D>(scenario, trial)?, &scenario.estimators);
            let pair = |trial: usize| {
                let [fixed, redrawn] = [&self.fixed, &self.redrawn].map(|scenario| draw(scenario, trial as u64));
                Ok(Pair { fixed: fixed?, redrawn: redrawn? })
            };
            trials.map(pair).collect()
        })
    }
}

fn draw<const D: usize>(recording: &Recording<D>, settings: &EstimatorSettings) -> Result<Draw> {
    Ok(Draw {
        condition: condition(recording),
        bound: bound(recording)?,
        errors: ESTIMATORS.map(|name| error(name, recording, settings)),
    })
}

fn condition<const D: usize>(recording: &Recording<D>) -> Option<f64> {
    let body = recording.truth.first()?.as_ref()?.position;
    let (anchors, noise) = (recording.model.anchors().positions(), recording.model.noise());
    let weight =
        |anchor: &SVector<f64, D>| 1.0 / noise.squared_range_variance((anchor - body).norm_squared());
    let (mut total, mut moment) = (0.0, SVector::zeros());
    for anchor in anchors {
        total += weight(anchor);
        moment += anchor * weight(anchor);
    }
    let whitened = |anchor: &SVector<f64, D>| (anchor - moment / total) * sqrt(weight(anchor) / total);
    let values = singular_values(&anchors.iter().map(whitened).collect::<Vec<_>>(), &SVector::zeros());
    let (largest, least) = (values[0], values[D - 1]);
    // Where the body sits on an anchor all weight is on that one, and nothing is left to compare.
    (least > RANK_TOLERANCE * largest).then(|| largest / least)
}

fn bound<const D: usize>(recording: &Recording<D>) -> Result<Option<Deviation>> {
    let mut squares = (0.0, 0.0);
    for step in bounds_along(recording)? {
        let Some(Ok(bound)) = step.get(BoundKind::PosteriorCrb) else { return Ok(None) };
        let Some(variance) = bound.angle_variance else { return Ok(None) };
        squares = (squares.0 + variance, squares.1 + bound.position_trace);
    }
    Ok(Some(deviation(squares, recording.epochs.len())))
}

fn error<const D: usize>(
    name: EstimatorName,
    recording: &Recording<D>,
    settings: &EstimatorSettings,
) -> Option<Deviation> {
    let mut filter = estimator(name, settings, recording);
    let (mut angle, mut position) = (0.0, 0.0);
    for (epoch, truth) in recording.epochs.iter().zip(&recording.truth) {
        let error = PoseError::of(&filter.step(epoch).ok()?, truth.as_ref()?);
        angle += error.angle * error.angle;
        position += error.position.norm_squared();
    }
    Some(deviation((angle, position), recording.epochs.len()))
}

fn deviation((angle, position): (f64, f64), steps: usize) -> Deviation {
    let root = |sum: f64| sqrt(sum / steps as f64);
    Deviation { angle: root(angle), position: root(position) }
}

impl Pair {
    /// How many numbers a pair has as a row of numbers.
    pub const LENGTH: usize = 2 * Draw::LENGTH;

    /// Pairs as one row of numbers: for the fixed and then the redrawn anchors the condition, then angle and position of
    /// the bound and of each estimator. -1 stands for what is not there.
    pub fn to_numbers(pairs: &[Self]) -> Vec<f64> {
        let mut numbers = Vec::with_capacity(pairs.len() * Self::LENGTH);
        for pair in pairs {
            pair.fixed.write(&mut numbers);
            pair.redrawn.write(&mut numbers);
        }
        numbers
    }

    /// The pairs of [`Pair::to_numbers`].
    ///
    /// # Errors
    /// [`Error::Size`] where the numbers are not those of whole pairs.
    pub fn from_numbers(numbers: &[f64]) -> Result<Vec<Self>> {
        let (found, expected) = (numbers.len(), numbers.len().next_multiple_of(Self::LENGTH));
        if found != expected {
            return Err(Error::Size { what: "numbers of pairs of draws", found, expected });
        }
        let mut from = Numbers::new(numbers);
        let mut pair = || Self { fixed: Draw::read(&mut from), redrawn: Draw::read(&mut from) };
        Ok((0..found / Self::LENGTH).map(|_| pair()).collect())
    }
}

const ABSENT: f64 = -1.0;

impl Flat for Draw {
    const LENGTH: usize = 7;

    fn write(&self, to: &mut Vec<f64>) {
        to.push(self.condition.unwrap_or(ABSENT));
        for deviation in [self.bound].iter().chain(&self.errors) {
            to.extend(deviation.map_or([ABSENT; 2], |Deviation { angle, position }| [angle, position]));
        }
    }

    fn read(from: &mut Numbers<'_>) -> Self {
        let condition = Some(from.number()).filter(|&number| number >= 0.0);
        let mut deviation = || {
            let (angle, position) = (from.number(), from.number());
            (angle >= 0.0).then_some(Deviation { angle, position })
        };
        Self { condition, bound: deviation(), errors: [deviation(), deviation()] }
    }
}
