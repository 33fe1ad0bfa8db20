//! The figures of \[I\]: errors of inertial filters over the accuracy of the ranges, the rate of the IMU, and the trials.
//!
//! How the samples of the IMU belong to the motion decides them, and the paper does not say it: "as sampled" is its eq. 14
//! read literally, "matched" makes its eq. 13 exact. Its paths are known from pictures only.

mod distribution;
mod experiments;
mod orientation;
mod panels;
mod position;
mod rates;
mod reading;
mod rest;

use super::{Figure, Paper};

pub(super) const FIGURE_4: Figure = Figure {
    name: "indoor-4",
    paper: Paper::Indoor,
    number: "4",
    title: "RMSE at rest over the accuracy of the ranges",
    statement: "at rest all EKFs (EKF, EKFRie, with Gauss-Newton or Iso) are closely aligned, and so are all UKFs; the RMSE \
                of the position falls linearly in dB (3000 trials).",
    trials: 400,
    experiments: experiments::figure_4,
    panels: panels::figure_4,
    claims: rest::figure_4,
};

pub(super) const FIGURE_5: Figure = Figure {
    name: "indoor-5",
    paper: Paper::Indoor,
    number: "5",
    title: "RMSE of the position over the accuracy of the ranges",
    statement: "EKFRie and UKFRie are better than EKF and UKF on all paths and at all noises, at 20 dB 0.12 and 0.10 m \
                beside 0.36 and 0.43 m on the path U, 0.05 and 0.05 m beside 0.24 and 0.29 m on the stairs; Iso does not \
                help the filters; averaging three receivers gains less (3000 trials).",
    trials: 100,
    experiments: experiments::figure_5,
    panels: panels::figure_5,
    claims: position::figure_5,
};

pub(super) const FIGURE_6: Figure = Figure {
    name: "indoor-6",
    paper: Paper::Indoor,
    number: "6",
    title: "RMSE of the orientation over the accuracy of the ranges",
    statement: "EKFRie and UKFRie are marginally better in orientation than EKF and UKF, on all paths and at all noises \
                (3000 trials).",
    trials: 100,
    experiments: experiments::figure_6,
    panels: panels::figure_6,
    claims: orientation::figure_6,
};

pub(super) const FIGURE_7: Figure = Figure {
    name: "indoor-7",
    paper: Paper::Indoor,
    number: "7",
    title: "RMSE over the rate of the IMU, sigma^2 = 0.1 m^2",
    statement: "a faster IMU improves the accuracy up to a point beyond which returns diminish (3000 trials).",
    trials: 100,
    experiments: experiments::figure_7,
    panels: panels::rates,
    claims: rates::figures_7_and_8,
};

pub(super) const FIGURE_8: Figure = Figure {
    name: "indoor-8",
    number: "8",
    title: "RMSE over the rate of the IMU, sigma^2 = 0.001 m^2",
    experiments: experiments::figure_8,
    ..FIGURE_7
};

pub(super) const FIGURE_9: Figure = Figure {
    name: "indoor-9",
    paper: Paper::Indoor,
    number: "9",
    title: "Distribution of the RMSE of the position on the bridge",
    statement: "EKFRie and UKFRie are better than EKF and UKF at both noises: at sigma^2 = 1e-3 m^2 nine tenths of the trials are below 0.22 m for EKFRie and 0.27 m for UKFRie, 0.52 m for \
                EKF and 0.59 m for UKF (3000 trials).",
    trials: 1000,
    experiments: experiments::figure_9,
    panels: panels::figure_9,
    claims: distribution::figure_9,
};
