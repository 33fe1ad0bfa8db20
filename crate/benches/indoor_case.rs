//! The run that is timed: the paper's path U, 100 samples and 10 fixes.

use rangelab::inertial::inertial_filter;
use rangelab::model::indoor::epoch::IndoorRecording;
use rangelab::model::indoor::filter_settings::{FilterName, FilterSettings};
use rangelab::model::indoor::presets::indoor_preset;
use rangelab::simulate::indoor::simulate_indoor;

/// A recording and what runs over it.
pub struct IndoorCase {
    recording: IndoorRecording,
    settings: FilterSettings,
}

impl IndoorCase {
    /// One trial.
    pub fn new() -> Self {
        let scenario = indoor_preset("indoor-u").expect("it comes with the crate");
        Self {
            recording: simulate_indoor(&scenario, 0).expect("a preset is valid"),
            settings: scenario.filters,
        }
    }

    /// Runs some of the filters over all steps; the sum keeps the work from being optimized away.
    pub fn run(&self, filters: &[FilterName]) -> f64 {
        let IndoorRecording { model, start, epochs, .. } = &self.recording;
        let mut sum = 0.0;
        for &name in filters {
            let mut filter = inertial_filter(name, &self.settings, model, start).expect("the prior is sound");
            for epoch in epochs {
                sum += filter.step(epoch).expect("the recording is sound").position[0];
            }
        }
        sum
    }
}
