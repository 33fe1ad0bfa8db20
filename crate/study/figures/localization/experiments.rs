//! What is simulated for the figures of \[L\].

use alloc::vec;
use alloc::vec::Vec;

use crate::math::rotation::Manifold;
use crate::model::localize_settings::LocalizerName::{
    self, ClassicalLs, Ls, OucLs, OucTls, OucTlsPrinted, SucLs, SucTls,
};
use crate::model::presets::preset;
use crate::model::scenario::Scenario;
use crate::study::figures::experiment::Experiment;
use crate::study::figures::kinds::NoiseSweep;

type Experiments = Vec<(&'static str, Experiment)>;

/// Where they are in the lists; the first of every list has fixed anchors, rotations, and all that is drawn.
pub(super) const FIXED: usize = 0;
pub(super) const REDRAWN: usize = 1;
pub(super) const FIXED_OVER_O: usize = 2;
pub(super) const REDRAWN_OVER_O: usize = 3;

/// Standard deviation of the place of a sensor on the body, m.
pub(super) const MOUNTING_SIGMA: f64 = 0.1;

/// The estimators of \[L\] that know the body.
pub(super) const PAPER: [LocalizerName; 3] = [Ls, SucLs, OucLs];
pub(super) const TOTAL: [LocalizerName; 5] = [Ls, SucTls, OucLs, OucTlsPrinted, OucTls];

/// Anchors fixed and redrawn, over rotations and over the paper's orthogonal matrices.
pub(super) fn orientation() -> Experiments {
    let fixed = || scenario("localization-paper", &PAPER);
    let redrawn = || scenario("localization-paper-redrawn", &PAPER);
    vec![
        ("fixed", sweep(fixed())),
        ("redrawn", sweep(redrawn())),
        ("fixed over O(3)", sweep(over_o(fixed()))),
        ("redrawn over O(3)", sweep(over_o(redrawn()))),
    ]
}

pub(super) fn fixed() -> Experiments {
    vec![("fixed", sweep(scenario("localization-paper", &PAPER)))]
}

/// With the sensors each by themselves.
pub(super) fn sensors() -> Experiments {
    let enabled = [&[ClassicalLs], &PAPER[..]].concat();
    vec![("fixed", sweep(scenario("localization-paper", &enabled)))]
}

/// Sensors away from where they should be.
pub(super) fn perturbed() -> Experiments {
    let scenario = Scenario { mounting_sigma: MOUNTING_SIGMA, ..scenario("localization-paper", &TOTAL) };
    vec![("fixed, sensors misplaced", sweep(scenario))]
}

fn sweep(scenario: Scenario) -> Experiment {
    Experiment::Sweep(NoiseSweep(scenario))
}

fn scenario(name: &str, enabled: &[LocalizerName]) -> Scenario {
    let mut scenario = preset(name).expect("the preset exists");
    scenario.localize.enabled = enabled.to_vec();
    scenario
}

fn over_o(mut scenario: Scenario) -> Scenario {
    scenario.localize.manifold = Manifold::O;
    scenario
}
