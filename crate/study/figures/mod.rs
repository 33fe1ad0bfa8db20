//! Figures of the papers as data: what is simulated, what is drawn, what is claimed; and what becomes of it.
//!
//! A [`Figure`] is computed in the numbered jobs of a [`plan::FigurePlan`] and comes out as a [`report::FigureReport`], in
//! which every verdict is computed from the numbers beside it.

mod caption;
pub mod claim;
mod csv;
pub mod experiment;
mod extreme;
mod indoor;
mod jackknife;
mod kinds;
mod kinematics;
mod localization;
pub mod plan;
pub mod report;
mod tracking;
mod wording;

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use serde::Serialize;

use self::claim::Claim;
use self::experiment::{Experiment, Study};
use self::report::Panel;
use crate::error::{Error, Result};

/// A figure of a paper.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
pub struct Figure {
    /// Its name on the command line.
    pub name: &'static str,
    /// The paper.
    pub paper: Paper,
    /// Its number there, with the letter of its part.
    pub number: &'static str,
    /// What it shows.
    pub title: &'static str,
    /// What the paper says about it, in a sentence.
    pub statement: &'static str,
    /// Trials where no number is asked for: those of the paper, or as many as take half a minute.
    pub trials: usize,
    /// What is simulated, each with a name.
    #[serde(skip)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    experiments: fn() -> Vec<(&'static str, Experiment)>,
    /// What is drawn of it.
    #[serde(skip)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    panels: fn(&[Study]) -> Vec<Panel>,
    /// What is claimed about it.
    #[serde(skip)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    claims: fn(&[Study]) -> Vec<Claim>,
}

/// One of the papers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(export))]
#[serde(rename_all = "kebab-case")]
pub enum Paper {
    /// \[T\], *Tracking Position and Orientation of a Mobile Rigid Body*.
    Tracking,
    /// \[L\], *Rigid Body Localization Using Sensor Networks*.
    Localization,
    /// \[I\], *Indoor Position and Attitude Tracking with SO(3) Manifold*.
    Indoor,
    /// \[A\], *Relative Kinematics Estimation Using Accelerometer Measurements*.
    Kinematics,
}

/// All figures, in the order in which they are listed.
pub static FIGURES: [Figure; 19] = [
    tracking::FIGURE_2,
    tracking::FIGURE_3,
    localization::FIGURE_2,
    localization::FIGURE_3,
    localization::FIGURE_4,
    localization::FIGURE_5,
    localization::FIGURE_6,
    localization::FIGURE_7,
    localization::FIGURE_8,
    localization::FIGURE_9,
    indoor::FIGURE_4,
    indoor::FIGURE_5,
    indoor::FIGURE_6,
    indoor::FIGURE_7,
    indoor::FIGURE_8,
    indoor::FIGURE_9,
    kinematics::FIGURE_1,
    kinematics::FIGURE_2A,
    kinematics::FIGURE_2B,
];

/// The seed that a figure has where none is asked for.
pub const SEED: u64 = 1;

impl Figure {
    /// Title of the paper and number of the figure.
    pub fn paper(&self) -> String {
        let paper = match self.paper {
            Paper::Tracking => "Tracking Position and Orientation of a Mobile Rigid Body",
            Paper::Localization => "Rigid Body Localization Using Sensor Networks",
            Paper::Indoor => "Indoor Position and Attitude Tracking with SO(3) Manifold",
            Paper::Kinematics => "Relative Kinematics Estimation Using Accelerometer Measurements",
        };
        format!("{paper}, Fig. {}", self.number)
    }

    fn index(&self) -> usize {
        FIGURES.iter().position(|each| each.name == self.name).unwrap_or(FIGURES.len())
    }
}

/// The figure of a name.
///
/// # Errors
/// [`Error::UnknownName`] with the names that exist.
///
/// ```
/// use rangelab::study::figures::figure;
/// assert_eq!(figure("kinematics-2a")?.number, "2a");
/// assert!(figure("tracking-4").unwrap_err().to_string().contains("tracking-2, tracking-3"));
/// # Ok::<(), rangelab::Error>(())
/// ```
pub fn figure(name: &str) -> Result<&'static Figure> {
    FIGURES.iter().find(|each| each.name == name).ok_or_else(|| Error::UnknownName {
        what: "figure",
        name: name.to_string(),
        known: FIGURES.each_ref().map(|each| each.name).join(", "),
    })
}
