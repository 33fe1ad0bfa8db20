//! What a figure simulates, of whatever kind. A kind of experiment is a type that is a `Kind` and a line of `kinds!`.

use alloc::vec::Vec;

use super::kinds::{NoiseSweep, Tracking};
use super::report::FigureScenario;
use crate::error::Result;
use crate::study::block::Block;
use crate::study::indoor::sweep::{IndoorSweep, IndoorSweepReport, SweepBlock};
use crate::study::kinematics::sweep::{KinematicsSweep, KinematicsSweepBlock, KinematicsSweepReport};
use crate::study::localization::LocalizationBlock;
use crate::study::localization::report::LocalizationReport;
use crate::study::report::StudyReport;

/// One kind of experiment: a scenario, and how its trials are counted in blocks.
///
/// Its sums have `merge` for the trials that come next, `append` for other trials of the same experiment, whichever they
/// are, and `to_numbers`.
pub(super) trait Kind {
    /// Sums over consecutive trials.
    type Sums;
    /// What was found.
    type Report;

    fn scenario(&self) -> FigureScenario;

    fn set_seed(&mut self, seed: u64);

    /// How many blocks so many trials have.
    fn blocks(&self, trials: usize) -> Result<usize>;

    /// No trials yet, and what no trial changes.
    fn start(&self) -> Self::Sums;

    /// Block `index` of so many trials.
    fn block(&self, trials: usize, index: usize) -> Result<Self::Sums>;

    /// The block of its `to_numbers`.
    fn read(&self, numbers: &[f64]) -> Result<Self::Sums>;

    fn report(&self, trials: usize, sums: &Self::Sums) -> Result<Self::Report>;
}

/// Makes one enum each of the experiments, their sums and their reports, which hand on to the kind.
macro_rules! kinds {
    ($($(#[$about:meta])* $kind:ident($experiment:ty, $sums:ty, $report:ty) = $as:ident;)*) => {
        /// A scenario and what is done with it.
        #[derive(Clone, Debug)]
        pub(super) enum Experiment {
            $($kind($experiment),)*
        }

        /// Sums over consecutive trials of an experiment.
        #[derive(Clone, Debug, PartialEq)]
        pub(super) enum Sums {
            $($kind($sums),)*
        }

        /// What an experiment found.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Study {
            $($(#[$about])* $kind($report),)*
        }

        impl Experiment {
            pub(super) fn scenario(&self) -> FigureScenario {
                match self { $(Self::$kind(experiment) => Kind::scenario(experiment),)* }
            }

            pub(super) fn with_seed(mut self, seed: u64) -> Self {
                match &mut self { $(Self::$kind(experiment) => Kind::set_seed(experiment, seed),)* }
                self
            }

            pub(super) fn blocks(&self, trials: usize) -> Result<usize> {
                match self { $(Self::$kind(experiment) => Kind::blocks(experiment, trials),)* }
            }

            pub(super) fn start(&self) -> Sums {
                match self { $(Self::$kind(experiment) => Sums::$kind(Kind::start(experiment)),)* }
            }

            pub(super) fn block(&self, trials: usize, index: usize) -> Result<Sums> {
                match self { $(Self::$kind(it) => Kind::block(it, trials, index).map(Sums::$kind),)* }
            }

            pub(super) fn read(&self, numbers: &[f64]) -> Result<Sums> {
                match self { $(Self::$kind(it) => Kind::read(it, numbers).map(Sums::$kind),)* }
            }

            /// What was found; nothing where the sums are of another kind.
            pub(super) fn report(&self, trials: usize, sums: &Sums) -> Result<Option<Study>> {
                match (self, sums) {
                    $((Self::$kind(it), Sums::$kind(sums)) => {
                        Kind::report(it, trials, sums).map(|report| Some(Study::$kind(report)))
                    })*
                    _ => Ok(None),
                }
            }
        }

        impl Sums {
            pub(super) fn merge(&mut self, next: &Self) -> Result<()> {
                match (self, next) {
                    $((Self::$kind(sums), Self::$kind(next)) => sums.merge(next),)*
                    _ => Ok(()),
                }
            }

            pub(super) fn append(&mut self, next: &Self) {
                match (self, next) {
                    $((Self::$kind(sums), Self::$kind(next)) => sums.append(next),)*
                    _ => (),
                }
            }

            pub(super) fn to_numbers(&self) -> Vec<f64> {
                match self { $(Self::$kind(sums) => sums.to_numbers(),)* }
            }
        }

        impl Study {
            /// Trials that were run.
            pub fn trials(&self) -> usize {
                match self { $(Self::$kind(report) => report.trials,)* }
            }

            $(
                /// The report, if it is of this kind.
                pub fn $as(&self) -> Option<&$report> {
                    match self { Self::$kind(report) => Some(report), _ => None }
                }
            )*
        }
    };
}

kinds! {
    /// Trackers, step by step.
    Track(Tracking, Block, StudyReport) = track;
    /// Snapshot estimators, noise by noise.
    Sweep(NoiseSweep, LocalizationBlock, LocalizationReport) = sweep;
    /// Inertial filters, point by point of a sweep.
    Indoor(IndoorSweep, SweepBlock, IndoorSweepReport) = indoor;
    /// Estimators of relative kinematics, number of stamps by number of stamps.
    Kinematics(KinematicsSweep, KinematicsSweepBlock, KinematicsSweepReport) = kinematics;
}
