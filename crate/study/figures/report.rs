//! A figure with its numbers, as a document.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::claim::Claim;
use crate::model::indoor::IndoorScenario;
use crate::model::kinematics::KinematicsScenario;
use crate::model::scenario::Scenario;
use crate::study::moments::Estimate;

/// A figure of a paper, computed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct FigureReport {
    /// Version of the format, 1.
    pub version: u32,
    /// Its name on the command line.
    pub name: String,
    /// Paper and number of the figure there.
    pub paper: String,
    /// What it shows.
    pub title: String,
    /// What the paper says about it, in a sentence.
    pub statement: String,
    /// Trials of every curve so far.
    pub trials: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// The command line that gives it again.
    pub command: String,
    /// What was found of the claims, in sentences.
    pub caption: String,
    /// What is claimed, each with a number and a verdict.
    pub claims: Vec<Claim>,
    /// The pictures it consists of.
    pub panels: Vec<Panel>,
    /// What was simulated.
    pub scenarios: Vec<NamedScenario>,
}

/// One pair of axes with its curves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Panel {
    /// Its name in tables.
    pub name: String,
    /// What it shows.
    pub title: String,
    /// Across.
    pub x: Axis,
    /// Up.
    pub y: Axis,
    /// What is drawn.
    pub curves: Vec<Curve>,
}

/// One axis.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Axis {
    /// What it measures.
    pub label: String,
    /// In which unit; empty for a pure number.
    pub unit: String,
    /// How it is divided.
    pub scale: AxisScale,
}

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum AxisScale {
    /// Equal lengths are equal differences.
    Linear,
    /// Equal lengths are equal ratios.
    Log,
}

/// What a curve is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum CurveKind {
    /// What an estimator does.
    Estimator,
    /// What its own covariance claims.
    Covariance,
    /// What none can do better.
    Bound,
}

/// One curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Curve {
    /// Of what: the name of an estimator or of a bound.
    pub name: String,
    /// The same for people.
    pub label: String,
    /// What it is of.
    pub kind: CurveKind,
    /// From left to right.
    pub points: Vec<Point>,
}

/// One point of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Point {
    /// Place on the axis across.
    pub x: f64,
    /// Height with its standard error.
    pub y: Estimate,
    /// Trials that gave it.
    pub trials: usize,
    /// Trials in which the estimator had given a typed error.
    pub failures: usize,
    /// Share of the trials in which the estimate mirrors the body; null for what estimates nothing.
    pub reflections: Option<Estimate>,
}

/// A scenario of a figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct NamedScenario {
    /// What the figure calls it.
    pub name: String,
    /// All that its trials are told.
    pub scenario: FigureScenario,
}

/// A scenario of any lab, as its document.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(untagged)]
pub enum FigureScenario {
    /// Of a rigid body and ranges.
    Body(Scenario),
    /// Of an IMU and ranges indoors.
    Indoor(IndoorScenario),
    /// Of mobile nodes and the distances between them.
    Kinematics(KinematicsScenario),
}

impl From<Scenario> for FigureScenario {
    fn from(scenario: Scenario) -> Self {
        Self::Body(scenario)
    }
}

impl From<IndoorScenario> for FigureScenario {
    fn from(scenario: IndoorScenario) -> Self {
        Self::Indoor(scenario)
    }
}

impl From<KinematicsScenario> for FigureScenario {
    fn from(scenario: KinematicsScenario) -> Self {
        Self::Kinematics(scenario)
    }
}

impl FigureScenario {
    /// The document as JSON; every number comes back as the same bits.
    pub fn to_json(&self) -> String {
        match self {
            Self::Body(scenario) => scenario.to_json(),
            Self::Indoor(scenario) => scenario.to_json(),
            Self::Kinematics(scenario) => scenario.to_json(),
        }
    }
}

impl FigureReport {
    /// The JSON text, in one line.
    ///
    /// # Panics
    /// Never: numbers and texts always have a JSON form.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("numbers and texts always have a JSON form")
    }

    /// Paper, number and title in one line.
    pub fn heading(&self) -> String {
        alloc::format!("{}: {}", self.paper, self.title)
    }
}

impl Axis {
    /// An axis of equal differences.
    pub fn linear(label: &str, unit: &str) -> Self {
        Self { label: label.into(), unit: unit.into(), scale: AxisScale::Linear }
    }

    /// An axis of equal ratios.
    pub fn log(label: &str, unit: &str) -> Self {
        Self { label: label.into(), unit: unit.into(), scale: AxisScale::Log }
    }

    /// Label and unit as they stand beside the axis.
    pub fn name(&self) -> String {
        if self.unit.is_empty() {
            self.label.clone()
        } else {
            alloc::format!("{}, {}", self.label, self.unit)
        }
    }
}
