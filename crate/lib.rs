//! Position **and orientation** of a rigid body from ranges between sensors on it and known anchors.
//!
//! Sensors sit at known places `c_n` of the body, anchors at known places `a_m` of the world. The body's pose takes one
//! frame to the other, `s_n = Q c_n + t`, and is found from the squared ranges `d_mn = ||a_m - s_n||^2 + noise`.
//!
//! | module | holds |
//! |---|---|
//! | [`math`] | rotations, poses and small matrices, in the plane and in space by one code path |
//! | [`model`] | anchors, topology, noise, ranges and their normal equations; the documents `Scenario`, `Recording`, `Run` |
//! | [`localize`] | LS, SUC-LS, OUC-LS, their total least squares, maximum likelihood: the pose from one epoch alone |
//! | [`track`] | KF, KF-ortho, UC-KF, ET-KF and the error-state filter, all on one update |
//! | [`inertial`] | an IMU and ranges: EKF, UKF, their Riemannian forms, and the yardsticks on SO(3) |
//! | [`anchorless`] | mobile nodes without anchors: relative positions, velocities, accelerations from distances |
//! | [`bounds`] | CRB, UC-CRB and the posterior bounds: how well any estimator could do |
//! | [`simulate`] | a scenario made into a recording, one random stream a trial |
//! | [`study`] | one run or many, with standard errors |
//! | [`place`] | where anchors should stand: the bound made small |
//!
//! Conventions: metres, seconds and radians unless a name says otherwise; transforms take the body frame to the world
//! frame; rotation errors are perturbed on the right, `R exp(hat(phi))`; `vec` stacks columns.
//!
//! The papers are cited as \[T\], *Tracking Position and Orientation of a Mobile Rigid Body* (S. P. Chepuri,
//! A. Simonetto, G. Leus, A.-J. van der Veen), and \[L\], *Rigid Body Localization Using Sensor Networks* (S. P. Chepuri,
//! G. Leus, A.-J. van der Veen, 2013), \[I\], *Indoor Position and Attitude Tracking with SO(3) Manifold* (H. Salem,
//! M. Ahmed, M. AlSharif, A. Muqaibel, T. Al-Naffouri), and \[A\], *Relative Kinematics Estimation Using Accelerometer
//! Measurements* (A. Mishra, R. T. Rajan, arXiv 2112.07307); equations are corrected where they are misprinted.
//!
//! Every function is pure and gives the same bits natively and in WebAssembly: the crate is `no_std`, has no clock, no
//! files, no threads and no global randomness, and takes its sines from `libm`.
// Without `std` no platform mathematics can slip in. The macros of `typescript`, which only write types, need it.
#![cfg_attr(not(feature = "typescript"), no_std)]

extern crate alloc;

pub mod anchorless;
pub mod bounds;
pub mod error;
pub mod inertial;
pub mod localize;
pub mod math;
pub mod model;
pub mod place;
pub mod simulate;
pub mod study;
pub mod track;

pub use error::{Error, Problem, Result};

/// The program in the README, run by rustdoc.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
