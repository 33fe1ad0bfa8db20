//! Kinematics scenarios by name: the paper's set-up, and what makes its lessons.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::Serialize;

use super::settings::{KinematicsName, KinematicsSettings};
use super::stamps::Stamps;
use super::{KinematicsNoise, KinematicsScenario, default_steps};
use crate::error::{Error, Result};
use crate::model::document::VERSION;

/// A kinematics scenario that comes with the crate.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct KinematicsPreset {
    /// Its name in links and on the command line.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// The one thing it teaches, in a sentence or two; a test makes sure that it does.
    pub summary: &'static str,
    #[serde(skip)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    build: fn() -> KinematicsScenario,
}

/// The preset that the lab opens with.
pub const DEFAULT_KINEMATICS_PRESET: &str = "kinematics-paper";

/// All of them, in the order in which they are shown.
pub const KINEMATICS_PRESETS: [KinematicsPreset; 6] = [
    KinematicsPreset {
        name: "kinematics-paper",
        title: "Ten nodes that accelerate",
        summary: "The paper's network. Distances alone, used well, show velocities better than the paper's closed form \
                  does with accelerometers.",
        build: || paper("kinematics-paper"),
    },
    KinematicsPreset {
        name: "kinematics-sparse",
        title: "Ten stamps only",
        summary: "The same network, measured ten times: the closed form loses what maximum likelihood keeps.",
        build: || with("kinematics-sparse", |scenario| scenario.stamps = regular(-5.0, 5.0, 10)),
    },
    KinematicsPreset {
        name: "kinematics-missing",
        title: "A fifth of the distances missing",
        summary: "Each pair is fitted at the stamps it has, so every estimator of the motion goes on; only scaling of single \
                  epochs ends, for no epoch is complete.",
        build: missing,
    },
    KinematicsPreset {
        name: "kinematics-four",
        title: "Four nodes",
        summary: "Too few for the paper's linear system, whose matrix loses its rank below five; enough for the motion.",
        build: four,
    },
    KinematicsPreset {
        name: "kinematics-constant",
        title: "Constant velocities",
        summary: "Without accelerations Algorithm 1 turns by noise alone: its margin falls below one, and its velocities \
                  are lost.",
        build: constant,
    },
    KinematicsPreset {
        name: "kinematics-space",
        title: "Twelve nodes in space",
        summary: "Three dimensions, where the paper's products are no longer told apart and its solver ends.",
        build: space,
    },
];

impl KinematicsPreset {
    /// Its scenario.
    pub fn scenario(&self) -> KinematicsScenario {
        (self.build)()
    }
}

/// The scenario of a preset.
///
/// # Errors
/// [`Error::UnknownName`] with the names that exist.
///
/// ```
/// use rangelab::model::kinematics::presets::kinematics_preset;
/// assert_eq!(kinematics_preset("kinematics-paper")?.nodes(), 10);
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn kinematics_preset(name: &str) -> Result<KinematicsScenario> {
    let found = KINEMATICS_PRESETS.iter().find(|each| each.name == name);
    found.map(KinematicsPreset::scenario).ok_or_else(|| Error::UnknownName {
        what: "kinematics preset",
        name: name.to_string(),
        known: KINEMATICS_PRESETS.map(|each| each.name).join(", "),
    })
}

/// \[A\] eq. 21, each row one coordinate; `-503]` is read as -503.
const POSITIONS: [[f64; 10]; 2] = [
    [-244.0, 385.0, 81.0, -19.0, -792.0, -554.0, -965.0, -985.0, -49.0, -503.0],
    [-588.0, -456.0, -992.0, -730.0, 879.0, 970.0, 155.0, 318.0, -858.0, 419.0],
];
const VELOCITIES: [[f64; 10]; 2] = [
    [-5.0, -8.0, -6.0, 6.0, -1.0, 2.0, 1.0, -5.0, 9.0, -5.0],
    [-8.0, -5.0, -7.0, -9.0, -3.0, -2.0, -2.0, -10.0, 2.0, -1.0],
];
const ACCELERATIONS: [[f64; 10]; 2] = [
    [-0.17, -0.42, 0.22, -0.07, 0.21, -0.15, 0.55, -0.72, -0.49, -0.34],
    [0.42, 0.17, 0.98, 0.73, 0.48, 0.08, -0.43, -0.14, 0.56, 0.91],
];

/// Third coordinates of a network in space; the first two are the paper's, with two nodes more.
const HEIGHTS: [[f64; 12]; 3] = [
    [310.0, -640.0, 75.0, 820.0, -410.0, 555.0, -95.0, 260.0, -730.0, 640.0, -280.0, 930.0],
    [3.0, -7.0, 8.0, 1.0, -4.0, 9.0, -6.0, 5.0, -2.0, 7.0, -9.0, 2.0],
    [0.36, -0.58, 0.81, -0.22, 0.67, -0.93, 0.14, 0.49, -0.77, 0.05, -0.31, 0.62],
];
const TWO_MORE: [[[f64; 2]; 2]; 3] =
    [[[640.0, -120.0], [-330.0, 705.0]], [[4.0, -3.0], [6.0, 8.0]], [[0.64, -0.27], [-0.52, 0.33]]];

fn regular(first: f64, last: f64, count: usize) -> Stamps {
    Stamps::Regular { first, last, count }
}

fn points(rows: &[[f64; 10]; 2], nodes: usize) -> Vec<Vec<f64>> {
    (0..nodes).map(|node| rows.iter().map(|row| row[node]).collect()).collect()
}

/// \[A\] Sec. 5 with K = 100.
fn paper(name: &str) -> KinematicsScenario {
    KinematicsScenario {
        version: VERSION,
        name: String::from(name),
        coefficients: [POSITIONS, VELOCITIES, ACCELERATIONS].iter().map(|rows| points(rows, 10)).collect(),
        stamps: Stamps::default(),
        noise: KinematicsNoise::default(),
        estimators: KinematicsSettings::default(),
        steps: default_steps(),
        seed: 1,
        view: None,
    }
}

fn with(name: &str, change: fn(&mut KinematicsScenario)) -> KinematicsScenario {
    let mut scenario = paper(name);
    change(&mut scenario);
    scenario
}

fn missing() -> KinematicsScenario {
    with("kinematics-missing", |scenario| {
        scenario.noise.missing_probability = 0.2;
        scenario.estimators.enabled.push(KinematicsName::MultidimensionalScaling);
    })
}

fn four() -> KinematicsScenario {
    with("kinematics-four", |scenario| {
        scenario.coefficients.iter_mut().for_each(|points| points.truncate(4));
    })
}

fn constant() -> KinematicsScenario {
    with("kinematics-constant", |scenario| {
        scenario.coefficients[2].iter_mut().flatten().for_each(|value| *value = 0.0);
    })
}

fn space() -> KinematicsScenario {
    with("kinematics-space", |scenario| {
        for (l, points) in scenario.coefficients.iter_mut().enumerate() {
            points.extend((0..2).map(|node| Vec::from(TWO_MORE[l].map(|row| row[node]))));
            points.iter_mut().zip(HEIGHTS[l]).for_each(|(point, height)| point.push(height));
        }
        scenario.estimators.enabled = Vec::from([
            KinematicsName::Algorithm1Rank1,
            KinematicsName::Algorithm1So,
            KinematicsName::Algorithm2So,
            KinematicsName::SnapshotSync,
            KinematicsName::MaximumLikelihood,
            KinematicsName::MaximumLikelihoodAccelerometers,
        ]);
    })
}
