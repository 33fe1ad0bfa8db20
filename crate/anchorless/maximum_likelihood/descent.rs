//! Down to the minimum: Gauss and Newton far away, Newton near it.

use nalgebra::DVector;

use super::WHAT;
use super::objective::{Expansion, Objective};
use super::pair_cost::Curvature;
use crate::error::{Error, Result};
use crate::math::definite::definite_factor;
use crate::math::float::sqrt;

const MAX_ITERATIONS: usize = 200;
const HALVINGS: usize = 40;
/// After steps below this part of the network all of the curvature is used.
const NEAR: f64 = 1e-3;
/// Steps below this part of the network lie where the cost no longer tells better from worse: distances of a kilometre have
/// residuals of a centimetre, and the cost is uncertain by 1e-10 of itself.
const LOCAL: f64 = 1e-6;
/// So do steps that promise to lower the cost by less than this part of it.
const ROUNDING: f64 = 1e-9;
/// Information that is added, in parts of what is there, where distances do not determine a step.
const DAMPING: [f64; 5] = [0.0, 1e-8, 1e-6, 1e-4, 1e-2];

/// Where the descent ended.
pub struct Minimum {
    pub unknowns: DVector<f64>,
    pub cost: f64,
    pub iterations: usize,
}

/// The minimum next to a start.
///
/// # Errors
/// [`Error::Degenerate`] where the curvature lost its rank there, [`Error::NoConvergence`].
pub fn minimum<const D: usize>(objective: &Objective<'_, D>, start: DVector<f64>) -> Result<Minimum> {
    let (mut unknowns, mut last) = (start, f64::INFINITY);
    for iterations in 0..MAX_ITERATIONS {
        let curvature = if last < NEAR { Curvature::Exact } else { Curvature::Gauss };
        let NewtonStep { by, fall, cost, margin } = newton_step(objective, &unknowns, curvature)?;
        let size = sqrt(by.norm_squared() / unknowns.norm_squared());
        let local = size < LOCAL || fall <= ROUNDING * cost;
        if size <= f64::EPSILON || (local && size >= 0.5 * last) {
            return determined(margin).map(|()| Minimum { unknowns, cost, iterations });
        }
        let next = if local {
            Some(objective.moved(&unknowns, &by))
        } else {
            descend(objective, &unknowns, &by, cost)
        };
        let Some(next) = next else {
            return Err(Error::NoConvergence { what: WHAT, iterations, last_step: size });
        };
        (unknowns, last) = (next, size);
    }
    Err(Error::NoConvergence { what: WHAT, iterations: MAX_ITERATIONS, last_step: last })
}

struct NewtonStep {
    by: DVector<f64>,
    /// The fall of the cost that the step promises.
    fall: f64,
    cost: f64,
    /// The least pivot, where the curvature had to be helped.
    margin: Option<f64>,
}

fn newton_step<const D: usize>(
    objective: &Objective<'_, D>,
    unknowns: &DVector<f64>,
    curvature: Curvature,
) -> Result<NewtonStep> {
    let Expansion { cost, gradient, hessian } = objective.expansion(unknowns, curvature);
    let mut margin = None;
    for damping in DAMPING {
        let mut damped = hessian.clone();
        for i in 0..damped.nrows() {
            damped[(i, i)] *= 1.0 + damping;
        }
        match definite_factor(&damped) {
            Ok(factor) => {
                let by = -factor.solve(&gradient);
                let fall = -0.5 * gradient.dot(&by);
                return Ok(NewtonStep { by, fall, cost, margin });
            }
            // Negative curvature far from a minimum: that of Gauss has none.
            Err(_) if curvature == Curvature::Exact => {
                return newton_step(objective, unknowns, Curvature::Gauss);
            }
            Err(pivot) => margin = margin.or(Some(pivot)),
        }
    }
    Err(undetermined(margin.unwrap_or(0.0)))
}

fn determined(margin: Option<f64>) -> Result<()> {
    margin.map_or(Ok(()), |pivot| Err(undetermined(pivot)))
}

fn undetermined(value: f64) -> Error {
    let reason = "Some motion of the nodes changes no distance: there are too few nodes or stamps, all nodes lie on a line, \
                  or they hardly move.";
    Error::Degenerate { what: WHAT, value, reason }
}

/// Halves the step until the cost falls; `None` where it never does.
fn descend<const D: usize>(
    objective: &Objective<'_, D>,
    unknowns: &DVector<f64>,
    step: &DVector<f64>,
    cost: f64,
) -> Option<DVector<f64>> {
    let mut part = step.clone();
    for _ in 0..HALVINGS {
        let moved = objective.moved(unknowns, &part);
        if objective.cost(&moved) < cost {
            return Some(moved);
        }
        part *= 0.5;
    }
    None
}
