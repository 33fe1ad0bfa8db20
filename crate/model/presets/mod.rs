//! Scenarios by name: where to start.

mod indoor;
mod paper;

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::Serialize;

use super::document::VERSION;
use super::document::entries::PoseEntries;
use super::estimator_settings::EstimatorSettings;
use super::motion::ProcessNoise;
use super::noise::RangeNoise;
use super::ranging::Weighting;
use super::scenario::{InitialSettings, MotionSettings, Scenario, WeightSource};
use crate::error::{Error, Result};

/// A scenario that comes with the crate.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Preset {
    /// Its name in links and on the command line.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// What it shows, in one sentence.
    pub summary: &'static str,
    #[serde(skip)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    build: fn() -> Scenario,
}

/// The preset that the page opens with.
pub const DEFAULT_PRESET: &str = "room";

/// All presets, in the order in which they are shown.
pub const PRESETS: [Preset; 6] = [
    Preset {
        name: "room",
        title: "A room",
        summary: "Six anchors in a room of 6 x 5 x 2.8 m follow a hand-sized body with ranges good to a centimetre.",
        build: indoor::room,
    },
    Preset {
        name: "tracking-paper",
        title: "The tracking paper",
        summary: "The set-up of \"Tracking Position and Orientation of a Mobile Rigid Body\": four anchors in a \
                  cube of 2 km, a one-metre pyramid, anchors fixed at a well-conditioned draw.",
        build: paper::fixed,
    },
    Preset {
        name: "tracking-paper-redrawn",
        title: "The tracking paper, anchors redrawn",
        summary: "The same with new anchors in every trial: some draws see an axis badly, and feeding a projected \
                  orientation back can do harm.",
        build: paper::redrawn,
    },
    Preset {
        name: "planar",
        title: "In the plane",
        summary: "A robot in a hall of 10 x 8 m: two coordinates, one angle, four anchors.",
        build: indoor::planar,
    },
    Preset {
        name: "coplanar-ceiling",
        title: "All anchors on the ceiling",
        summary: "Anchors within 8 cm of one plane hardly see height and tilt once the unknown squared norm is \
                  projected out; the unprojected squared ranges still do.",
        build: indoor::ceiling,
    },
    Preset {
        name: "three-anchors",
        title: "Three anchors",
        summary: "Fewer anchors than the linear model needs in space: one direction rests on the prior alone unless \
                  the squared ranges stay unprojected.",
        build: indoor::three_anchors,
    },
];

impl Preset {
    /// Its scenario.
    pub fn scenario(&self) -> Scenario {
        (self.build)()
    }
}

/// The scenario of a preset.
///
/// # Errors
/// [`Error::UnknownName`] with the names that exist.
///
/// ```
/// use rangelab::model::presets::preset;
/// assert_eq!(preset("room")?.anchors.len(), 6);
/// assert!(preset("moon").unwrap_err().to_string().contains("room, tracking-paper"));
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn preset(name: &str) -> Result<Scenario> {
    let found = PRESETS.iter().find(|each| each.name == name);
    found.map(Preset::scenario).ok_or_else(|| Error::UnknownName {
        what: "preset",
        name: name.to_string(),
        known: PRESETS.map(|each| each.name).join(", "),
    })
}

/// What presets have in common.
fn base<const D: usize>(
    name: &str,
    anchors: &[[f64; D]],
    sensors: &[[f64; D]],
    noise: RangeNoise,
) -> Scenario {
    let lists = |points: &[[f64; D]]| points.iter().map(|point| point.to_vec()).collect::<Vec<_>>();
    let PoseEntries { orientation, position } = PoseEntries::identity(D);
    Scenario {
        version: VERSION,
        name: String::from(name),
        dimension: D,
        anchors: lists(anchors),
        redraw_anchors: None,
        sensors: lists(sensors),
        noise,
        weights: WeightSource::Measured,
        weighting: Weighting::Common,
        missing_probability: 0.0,
        interval: 1.0,
        steps: 20,
        seed: 1,
        motion: MotionSettings::default(),
        start: PoseEntries::identity(D),
        initial: InitialSettings { orientation, position, covariance: 100.0 },
        process: ProcessNoise::default(),
        estimators: EstimatorSettings::default(),
        view: None,
    }
}

/// The motion of a preset, and the process noise that says the same to the estimators.
fn moving(scenario: Scenario, motion: MotionSettings) -> Scenario {
    let process = ProcessNoise { sigma_q: motion.sigma_omega * scenario.interval, sigma_t: motion.sigma_t };
    Scenario { motion, process, ..scenario }
}
