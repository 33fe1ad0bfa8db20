//! The figures of \[T\]: errors of the trackers over 20 steps, anchors fixed and redrawn.

mod claims;
mod panels;
mod reading;
mod scenarios;

use super::{Figure, Paper};

const TRIALS: usize = 1000;

pub(super) const FIGURE_2: Figure = Figure {
    name: "tracking-2",
    paper: Paper::Tracking,
    number: "2",
    title: "RMSE of orientation and position",
    statement: "the RMSE of the unconstrained KF follows its estimated covariance; the constrained estimators have a lower \
                RMSE of Q; the RMSE of t is similar for all; ET-KF is worse than projecting at each step (KF-ortho); and the \
                UC-KF overestimates its covariance.",
    trials: TRIALS,
    experiments: scenarios::figure_2,
    panels: panels::figure_2,
    claims: claims::figure_2,
};

pub(super) const FIGURE_3: Figure = Figure {
    name: "tracking-3",
    paper: Paper::Tracking,
    number: "3",
    title: "Mean angular error of the orientation",
    statement: "the constrained estimators have a lower mean angular error (MAE) than the unconstrained KF.",
    trials: TRIALS,
    experiments: scenarios::figure_3,
    panels: panels::figure_3,
    claims: claims::figure_3,
};
