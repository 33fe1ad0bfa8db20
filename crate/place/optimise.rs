//! The search for better places: projected gradients with spectral steps.
//!
//! Written here because the libraries that search within bounds (SLSQP and COBYLA after Kraft and Powell, PANOC) need `std`,
//! read clocks or bring the platform's own powers, and none of them knows zones that may not be entered.

use alloc::vec::Vec;

use nalgebra::SVector;

use super::figure::Sharpness;
use super::objective::Placement;
use super::zone::Zone;
use crate::error::Result;

const MAX_ITERATIONS: usize = 300;
/// Halvings of a step before it is given up.
const MAX_HALVINGS: usize = 40;
/// A first step moves some anchor by this part of the extent of the limits, and no later step moves one by more than
/// [`LONGEST_STEP`].
const FIRST_STEP: f64 = 0.1;
const LONGEST_STEP: f64 = 0.5;
/// Part of what the slope promises that a step must keep.
const SUFFICIENT: f64 = 1e-4;
/// The search ends where so many steps in a row gained less than this part of the value.
const LEAST_GAIN: f64 = 1e-9;
const PATIENCE: usize = 5;
/// Where the value has kinks: means of ever higher order, 2^2 to 2^7, in place of the maximum.
const SHARPENING: [u32; 4] = [2, 4, 6, 7];

/// The best anchors met on the way down from `start`, where each anchor may stand; never worse than `start`.
///
/// Barzilai-Borwein steps with backtracking, each anchor projected back into its [`Zone`]. Kinks (E, worst) are
/// approached through smooth means of rising order; what counts in the end is the value itself. A weak prior carries the
/// search over places where not everything is seen.
///
/// # Errors
/// [`crate::Error::Number`] where sums overflow.
pub fn optimise<const D: usize>(
    placement: &Placement<D>,
    zone: &Zone<D>,
    start: &[SVector<f64, D>],
) -> Result<Vec<SVector<f64, D>>> {
    let smooth: &[Sharpness] = &SHARPENING.map(|doublings| Sharpness::Smooth { doublings });
    let stages = if placement.has_kinks() { smooth } else { &[Sharpness::Exact] };
    let (mut best, mut at) = (start.to_vec(), start.to_vec());
    let mut best_value = placement.value(start).ok();
    for &sharpness in stages {
        let prior = placement.weak_prior(&at, zone.extent())?;
        at = descend(zone, &at, |anchors| placement.differentiate(anchors, Some(prior), sharpness))?;
        let value = placement.value(&at).ok();
        if value.is_some_and(|value| best_value.is_none_or(|best| value < best)) {
            (best, best_value) = (at.clone(), value);
        }
    }
    Ok(best)
}

/// Follows the slope of a function of the anchors until it gains no more.
fn descend<const D: usize>(
    zone: &Zone<D>,
    start: &[SVector<f64, D>],
    function: impl Fn(&[SVector<f64, D>]) -> Result<(f64, Vec<SVector<f64, D>>)>,
) -> Result<Vec<SVector<f64, D>>> {
    let longest = LONGEST_STEP * zone.extent();
    let mut at = start.to_vec();
    let (mut value, mut gradient) = function(&at)?;
    let mut step = FIRST_STEP * zone.extent() / steepest(zone, &gradient);
    let mut idle = 0;
    for _ in 0..MAX_ITERATIONS {
        step = step.min(longest / steepest(zone, &gradient));
        let Some(next) = backtrack(zone, &at, value, &gradient, &mut step, &function) else { break };
        let (moved, turned) = (difference(&next.at, &at), difference(&next.gradient, &gradient));
        let curvature = dot(&moved, &turned);
        // Downhill that gets steeper asks for longer steps.
        step = if curvature > 0.0 { dot(&moved, &moved) / curvature } else { 4.0 * step };
        idle = if value - next.value > LEAST_GAIN * value { 0 } else { idle + 1 };
        (at, value, gradient) = (next.at, next.value, next.gradient);
        if idle == PATIENCE {
            break;
        }
    }
    Ok(at)
}

/// Where a step led.
struct Next<const D: usize> {
    at: Vec<SVector<f64, D>>,
    value: f64,
    gradient: Vec<SVector<f64, D>>,
}

/// Halves the step until it keeps what the slope promises; none where no step does.
fn backtrack<const D: usize>(
    zone: &Zone<D>,
    at: &[SVector<f64, D>],
    value: f64,
    gradient: &[SVector<f64, D>],
    step: &mut f64,
    function: impl Fn(&[SVector<f64, D>]) -> Result<(f64, Vec<SVector<f64, D>>)>,
) -> Option<Next<D>> {
    for _ in 0..MAX_HALVINGS {
        let wanted: Vec<_> = at.iter().zip(gradient).map(|(a, g)| a - g * *step).collect();
        let next = zone.project_all(at, &wanted);
        let moved = difference(&next, at);
        let promised = SUFFICIENT * dot(&moved, &moved) / *step;
        // Written so that a step of nothing, or one that is not a number, fails.
        if !(promised > 0.0) {
            return None;
        }
        // A place with no value at all, such as one where sums overflow, is as bad as one that is worse.
        if let Ok((found, slope)) = function(&next)
            && found <= value - promised
        {
            return Some(Next { at: next, value: found, gradient: slope });
        }
        *step *= 0.5;
    }
    None
}

/// Length of the steepest gradient of an anchor that may move.
fn steepest<const D: usize>(zone: &Zone<D>, gradient: &[SVector<f64, D>]) -> f64 {
    let free = gradient.iter().enumerate().filter(|(m, _)| !zone.is_fixed(*m));
    free.map(|(_, g)| g.norm()).fold(f64::MIN_POSITIVE, f64::max)
}

fn difference<const D: usize>(a: &[SVector<f64, D>], b: &[SVector<f64, D>]) -> Vec<SVector<f64, D>> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn dot<const D: usize>(a: &[SVector<f64, D>], b: &[SVector<f64, D>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}
