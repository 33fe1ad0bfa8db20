//! Scenarios by name: where to start.

mod indoor;
mod lessons;
mod outings;
mod paper;
mod snapshot;

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::Serialize;

use super::availability::AvailabilitySettings;
use super::document::VERSION;
use super::document::entries::PoseEntries;
use super::estimator_settings::EstimatorSettings;
use super::field_settings::FieldSettings;
use super::localize_settings::LocalizeSettings;
use super::motion::ProcessNoise;
use super::noise::RangeNoise;
use super::placement_settings::PlacementSettings;
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
    /// The one thing it teaches, in a sentence or two; a test makes sure that it does.
    pub summary: &'static str,
    #[serde(skip)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    build: fn() -> Scenario,
}

/// The preset that the page opens with.
pub const DEFAULT_PRESET: &str = "room";

/// All presets, in the order in which they are shown.
pub const PRESETS: [Preset; 17] = [
    Preset {
        name: "room",
        title: "A room",
        summary: "Six anchors all around and ranges good to a centimetre: position to a centimetre, \
                  orientation to two degrees, and the estimators come close to what the bounds allow.",
        build: indoor::room,
    },
    Preset {
        name: "planar",
        title: "In the plane",
        summary: "A slender robot in a hall: two coordinates and one angle. Estimators that know that it \
                  is one angle, not a matrix of four numbers, find it about twice as well.",
        build: indoor::planar,
    },
    Preset {
        name: "figure-eight",
        title: "A figure eight",
        summary: "The anchors stand at one end of the hall and ranges grow worse with distance: the error \
                  follows the body there and back, and so does the bound.",
        build: outings::figure_eight,
    },
    Preset {
        name: "towers",
        title: "A drone among towers",
        summary: "Four towers are almost equally high, so the drone's height is the hardest to tell. Above \
                  them it gets better, but only for the filter that keeps the squares of the ranges.",
        build: outings::towers,
    },
    Preset {
        name: "corridor",
        title: "A corridor",
        summary: "Anchors nearly in a line: the place along the corridor is known to a centimetre or two, \
                  the place across it twenty times worse, unless the squares of the ranges are used too.",
        build: outings::corridor,
    },
    Preset {
        name: "coplanar-ceiling",
        title: "All anchors on the ceiling",
        summary: "Anchors within 8 cm of one plane: filters that project the body's squared distance out \
                  of the ranges hardly see its height; the one that keeps it does.",
        build: indoor::ceiling,
    },
    Preset {
        name: "three-anchors",
        title: "Three anchors",
        summary: "Fewer anchors than the linear model needs in space: in one direction it learns nothing \
                  and keeps its first guess, unless the squares of the ranges are used.",
        build: indoor::three_anchors,
    },
    Preset {
        name: "mirrored",
        title: "A mirror image",
        summary: "Anchors in one plane cannot tell a body from its mirror image. Projected onto all \
                  orthogonal matrices the UC-KF ends up mirrored; choose rotations, SO(D), and it is \
                  right.",
        build: lessons::mirrored,
    },
    Preset {
        name: "missing-ranges",
        title: "Four of ten ranges missing",
        summary: "Nobody stops where ranges are missing. With six tenths of them errors are about 1.3 \
                  times as large, the root of ten sixths, once the start is over.",
        build: lessons::missing_ranges,
    },
    Preset {
        name: "small-body",
        title: "A body like a coin",
        summary: "Sensors ten times closer together see orientation ten times worse at the first step, and \
                  position as well as ever: a long body is a good compass.",
        build: lessons::small_body,
    },
    Preset {
        name: "rod",
        title: "A rod",
        summary: "All sensors on one line: no range changes when the rod rolls about itself. Nobody can \
                  correct its roll, guessed 57 degrees wrong, while its direction is known to a degree.",
        build: lessons::rod,
    },
    Preset {
        name: "overconfident",
        title: "Too sure of itself",
        summary: "The filters take the motion to be ten times steadier than it is. They claim to be 3 mm \
                  off and are 23 mm off: NEES, which should be 1 a degree of freedom, grows far beyond it.",
        build: lessons::overconfident,
    },
    Preset {
        name: "wide-prior",
        title: "Knowing nothing at first",
        summary: "The first guess is 4 m and 160 degrees off, and the prior so wide that it says nothing: \
                  one step of ranges makes up for it. Set its variance to 0.01 and it takes many.",
        build: lessons::wide_prior,
    },
    Preset {
        name: "tracking-paper",
        title: "The tracking paper",
        summary: "The set-up of \"Tracking Position and Orientation of a Mobile Rigid Body\": four anchors \
                  in a cube of 2 km, a one-metre pyramid, anchors fixed at a well-conditioned draw.",
        build: paper::fixed,
    },
    Preset {
        name: "tracking-paper-redrawn",
        title: "The tracking paper, anchors redrawn",
        summary: "The same with new anchors in every trial: some draws see an axis badly, and feeding a \
                  projected orientation back can do harm.",
        build: paper::redrawn,
    },
    Preset {
        name: "localization-paper",
        title: "The localization paper",
        summary: "The set-up of \"Rigid Body Localization Using Sensor Networks\": ten sensors on a pyramid of \
                  5 m, four anchors up to 700 m away, one snapshot; fixed at an ordinary draw of anchors.",
        build: snapshot::fixed,
    },
    Preset {
        name: "localization-paper-redrawn",
        title: "The localization paper, anchors redrawn",
        summary: "The same with new anchors in every trial: over all orthogonal matrices some estimates mirror \
                  the body; over rotations, SO(3), none can, and the bound is met.",
        build: snapshot::redrawn,
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
/// assert!(preset("moon").unwrap_err().to_string().contains("room, planar"));
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
        mounting_sigma: 0.0,
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
        availability: AvailabilitySettings::default(),
        field: FieldSettings::default(),
        placement: PlacementSettings::default(),
        localize: LocalizeSettings::default(),
        view: None,
    }
}

/// The motion of a preset, and the process noise that says the same to the estimators.
fn moving(scenario: Scenario, motion: MotionSettings) -> Scenario {
    let process = ProcessNoise { sigma_q: motion.sigma_omega * scenario.interval, sigma_t: motion.sigma_t };
    Scenario { motion, process, ..scenario }
}
