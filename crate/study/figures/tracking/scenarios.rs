//! What is simulated for the figures of \[T\]. The first two are drawn; the others are for claims alone.

use alloc::vec;
use alloc::vec::Vec;

use crate::math::rotation::Manifold;
use crate::model::estimator_settings::EstimatorName::{self, EtKf, Kf, Ortho, UcKf};
use crate::model::estimator_settings::Metric;
use crate::model::presets;
use crate::model::scenario::Scenario;
use crate::study::figures::experiment::Experiment;
use crate::study::figures::kinds::Tracking;

/// Where the drawn scenarios are in the list.
pub(super) const FIXED: usize = 0;
pub(super) const REDRAWN: usize = 1;
/// Where those of the claims of Fig. 2 are.
pub(super) const OVER_O: usize = 2;
pub(super) const INFORMATION_METRIC: usize = 3;
pub(super) const OFF_CENTRE: usize = 4;

/// The estimators of the paper.
pub(super) const PAPER: [EstimatorName; 4] = [Kf, Ortho, UcKf, EtKf];

/// Fig. 2: beside fixed and redrawn anchors, redrawn ones with the projections of the paper onto O(3) and with projections
/// in the metric of the covariance, and fixed ones with the body's frame at its base.
pub(super) fn figure_2() -> Vec<(&'static str, Experiment)> {
    let mut scenarios = drawn();
    let (fixed, redrawn) = (scenarios[FIXED].1.clone(), scenarios[REDRAWN].1.clone());
    let mut over_o = of_paper(redrawn.clone());
    over_o.estimators.manifold = Manifold::O;
    scenarios.push(("redrawn over O(3)", over_o));
    let mut metric = of_paper(redrawn);
    metric.estimators.metric = Metric::Information;
    scenarios.push(("redrawn, metric of the covariance", metric));
    let mut off_centre = of_paper(fixed);
    let lowest = off_centre.sensors.iter().map(|sensor| sensor[2]).fold(f64::INFINITY, f64::min);
    off_centre.sensors.iter_mut().for_each(|sensor| sensor[2] -= lowest);
    scenarios.push(("fixed, body frame at the base", off_centre));
    tracked(scenarios)
}

/// Fig. 3: anchors fixed at a well-conditioned draw, and new ones in each trial.
pub(super) fn figure_3() -> Vec<(&'static str, Experiment)> {
    tracked(drawn())
}

fn tracked(scenarios: Vec<(&'static str, Scenario)>) -> Vec<(&'static str, Experiment)> {
    scenarios.into_iter().map(|(name, scenario)| (name, Experiment::Track(Tracking(scenario)))).collect()
}

fn drawn() -> Vec<(&'static str, Scenario)> {
    let preset = |name| presets::preset(name).expect("the preset exists");
    vec![("fixed", preset("tracking-paper")), ("redrawn", preset("tracking-paper-redrawn"))]
}

fn of_paper(mut scenario: Scenario) -> Scenario {
    scenario.estimators.enabled = PAPER.to_vec();
    scenario
}
