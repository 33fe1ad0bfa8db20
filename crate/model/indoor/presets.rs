//! Indoor scenarios by name: the paper's set-ups, and what makes their lessons.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::Serialize;

use super::filter_settings::{FilterSettings, FixCovariance};
use super::trajectory::IndoorPath;
use super::{IndoorScenario, RangingSettings, StartPrior, StartSettings};
use crate::error::{Error, Result};
use crate::math::float::radians;
use crate::model::document::{VERSION, Written};
use crate::model::imu::{Convention, ImuSettings, STANDARD_GRAVITY};

/// An indoor scenario that comes with the crate.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct IndoorPreset {
    /// Its name in links and on the command line.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// The one thing it teaches, in a sentence or two; a test makes sure that it does.
    pub summary: &'static str,
    #[serde(skip)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    build: fn() -> IndoorScenario,
}

/// The preset that the lab opens with.
pub const DEFAULT_INDOOR_PRESET: &str = "indoor-u";

/// All of them, in the order in which they are shown.
pub const INDOOR_PRESETS: [IndoorPreset; 9] = [
    IndoorPreset {
        name: "indoor-u",
        title: "A turn back",
        summary: "The paper's path U. Making R a rotation again after each prediction is all that EKFRie gains \
                  over the EKF, a tenth of its error; integrating exactly leaves a sixth of EKFRie's.",
        build: || paper("indoor-u", IndoorPath::U),
    },
    IndoorPreset {
        name: "indoor-zigzag",
        title: "A zigzag",
        summary: "The fastest turns of the paper. With the IMU sampled at the beginning of each interval no filter \
                  that integrates by Euler's rule comes near the error-state filter.",
        build: || paper("indoor-zigzag", IndoorPath::Zigzag),
    },
    IndoorPreset {
        name: "indoor-bridge",
        title: "A bridge",
        summary: "Up and down over a bridge, where EKFRie is not better but two to three per cent worse than the EKF.",
        build: || paper("indoor-bridge", IndoorPath::Bridge),
    },
    IndoorPreset {
        name: "indoor-stair",
        title: "A staircase",
        summary: "A minute and a half of turns: the EKF's R doubles in size, and with it the accelerations that it \
                  integrates. Here EKFRie is five times as good.",
        build: || paper("indoor-stair", IndoorPath::Stair),
    },
    IndoorPreset {
        name: "indoor-static",
        title: "At rest",
        summary: "Where nothing turns, R stays a rotation by itself and all filters are the same.",
        build: || paper("indoor-static", IndoorPath::Static),
    },
    IndoorPreset {
        name: "indoor-matched",
        title: "Inputs that match the filter",
        summary: "The turn back with inputs that make Euler's rule for velocity and position exact: now EKFRie is \
                  eight times as good as the EKF, and the error-state filter, whose integration does not match, fails.",
        build: || convention("indoor-matched", Convention::Disc),
    },
    IndoorPreset {
        name: "indoor-delta",
        title: "An IMU that integrates inside",
        summary: "Delta-angles and delta-velocities, an honest first guess, covariances from the geometry: the \
                  error-state filters are off by what they claim.",
        build: honest,
    },
    IndoorPreset {
        name: "indoor-gravity",
        title: "Gravity on the stairs",
        summary: "An accelerometer feels gravity too. Started five degrees off, filters that forget what R does to \
                  the acceleration are lost by metres.",
        build: gravity,
    },
    IndoorPreset {
        name: "indoor-tumble",
        title: "Tumbling",
        summary: "Turns about all three axes: the Q-factor is then only a first-order integrator, and the orientation \
                  of EKFRie is worse than that of the EKF.",
        build: || paper("indoor-tumble", IndoorPath::Tumble),
    },
];

impl IndoorPreset {
    /// Its scenario.
    pub fn scenario(&self) -> IndoorScenario {
        (self.build)()
    }
}

/// The scenario of a preset.
///
/// # Errors
/// [`Error::UnknownName`] with the names that exist.
///
/// ```
/// use rangelab::model::indoor::presets::indoor_preset;
/// assert_eq!(indoor_preset("indoor-u")?.transmitters.len(), 3);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn indoor_preset(name: &str) -> Result<IndoorScenario> {
    let found = INDOOR_PRESETS.iter().find(|each| each.name == name);
    found.map(IndoorPreset::scenario).ok_or_else(|| Error::UnknownName {
        what: "indoor preset",
        name: name.to_string(),
        known: INDOOR_PRESETS.map(|each| each.name).join(", "),
    })
}

/// \[I\] Sec. V-A at 20 dB.
fn paper(name: &str, path: IndoorPath) -> IndoorScenario {
    let mut scenario = IndoorScenario {
        version: VERSION,
        name: String::from(name),
        path,
        beacons: Vec::new(),
        transmitters: Vec::new(),
        imu: ImuSettings::default(),
        ranging: RangingSettings::default(),
        start: StartSettings::default(),
        filters: FilterSettings::default(),
        seed: 1,
        view: None,
    };
    scenario.fill(3);
    scenario
}

fn convention(name: &str, convention: Convention) -> IndoorScenario {
    let mut scenario = paper(name, IndoorPath::U);
    scenario.imu.convention = convention;
    scenario
}

/// Off by so many degrees about each axis, 0.1 m and 0.1 m/s, and known to be.
fn off(scenario: &mut IndoorScenario, degrees: f64) {
    let prior = StartPrior::Tangent { angle: radians(degrees), position: 0.1, velocity: 0.1 };
    scenario.start = StartSettings { prior, drawn: true };
    scenario.filters.fix_covariance = FixCovariance::Geometry;
}

fn honest() -> IndoorScenario {
    let mut scenario = convention("indoor-delta", Convention::Mean);
    off(&mut scenario, 2.0);
    scenario
}

fn gravity() -> IndoorScenario {
    let mut scenario = paper("indoor-gravity", IndoorPath::Stair);
    scenario.imu.convention = Convention::Mean;
    scenario.imu.gravity = STANDARD_GRAVITY;
    off(&mut scenario, 5.0);
    scenario
}
