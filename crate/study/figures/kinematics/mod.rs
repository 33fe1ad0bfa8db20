//! The figures of \[A\]: errors of relative kinematics over the number of stamps, and over time.
//!
//! The paper prints curves without numbers: what is held against it is the order of its curves. Its RMSE divides the root of
//! the summed squares by how many numbers there are; here it is that of one of them, which is larger by the root of that
//! count. The order is the same.

mod coefficients;
mod experiments;
mod gram;
mod panels;
mod positions;
mod reading;

use super::{Figure, Paper};

const TRIALS: usize = 1000;

pub(super) const FIGURE_1: Figure = Figure {
    name: "kinematics-1",
    paper: Paper::Kinematics,
    number: "1",
    title: "RMSE of the coefficients of the Gram matrix over the number of stamps",
    statement: "the polynomial of the Gram matrix has a lower RMSE than that of each range (whose degree q it does not say, so that \
                q = 2 to 6 are guesses made here) in all coefficients, \
                accelerometers improve them, and both fits are optimal for white noise (1000 trials; its RMSE is that of an \
                entry, as drawn here, divided by sqrt(55)).",
    trials: TRIALS,
    experiments: experiments::figure_1,
    panels: panels::figure_1,
    claims: gram::figure_1,
};

pub(super) const FIGURE_2A: Figure = Figure {
    name: "kinematics-2a",
    paper: Paper::Kinematics,
    number: "2a",
    title: "RMSE of relative position, velocity and acceleration over the number of stamps",
    statement: "accelerometers significantly improve position, velocity and acceleration at t = 0 (1000 trials; its RMSE is \
                that of a coordinate, as drawn here, divided by sqrt(20)).",
    trials: TRIALS,
    experiments: experiments::figure_2a,
    panels: panels::figure_2a,
    claims: coefficients::figure_2a,
};

pub(super) const FIGURE_2B: Figure = Figure {
    name: "kinematics-2b",
    paper: Paper::Kinematics,
    number: "2b",
    title: "RMSE of the positions over time, 100 stamps",
    statement: "accelerometers improve the positions over time too; they are most accurate at t = 0 and get worse away from it \
                because the Taylor approximation does (1000 trials; its RMSE is that of a coordinate, as drawn here, divided by \
                sqrt(20)).",
    trials: TRIALS,
    experiments: experiments::figure_2b,
    panels: panels::figure_2b,
    claims: positions::figure_2b,
};
