//! The module `rangelab._core`: the crate for Python, documents in as JSON, numbers out as `NumPy` arrays.
//!
//! It is a thin facade and does no arithmetic of its own. What goes wrong is raised as a `rangelab.Error` whose message is a
//! sentence; every computation lets other Python threads run meanwhile. The package's Python part says more of each.

// What Python hands over is taken apart on the way in: there is nothing to borrow.
#![allow(clippy::needless_pass_by_value)]

mod array;
mod compute;
mod consistency;
mod distances;
mod documents;
mod draws;
mod error;
mod figures;
mod geometry;
mod indoor;
mod kinematics;
mod motion;
mod plan;
mod recording;
mod run;
mod snapshot;
mod studies;
mod tracker;

use pyo3::prelude::*;

#[pymodule]
mod _core {
    #[pymodule_export]
    use super::compute::panic_on_purpose;
    #[pymodule_export]
    use super::consistency::chi_squared_interval;
    #[pymodule_export]
    use super::distances::{DistanceRecord, KinematicsEstimate, kinematics_estimators};
    #[pymodule_export]
    use super::documents::{Scenario, presets, topologies};
    #[pymodule_export]
    use super::draws::AnchorDraws;
    #[pymodule_export]
    use super::error::{
        Cancelled, Error, InternalError, InvalidDocument, NoConvergence, UnknownName, Unobservable,
    };
    #[pymodule_export]
    use super::figures::{FigurePlan, figures};
    #[pymodule_export]
    use super::geometry::{advise, best_next, bound_at, explore, field, improve, next_at, size_curve};
    #[pymodule_export]
    use super::indoor::{IndoorRun, IndoorScenario, indoor_presets};
    #[pymodule_export]
    use super::kinematics::{KinematicsBound, KinematicsScenario, kinematics_presets};
    #[pymodule_export]
    use super::motion::RelativeKinematics;
    #[pymodule_export]
    use super::plan::{Plan, Sum};
    #[pymodule_export]
    use super::recording::Recording;
    #[pymodule_export]
    use super::run::Run;
    #[pymodule_export]
    use super::snapshot::{localization_cloud, localize, localize_recording};
    #[pymodule_export]
    use super::tracker::Tracker;
}
