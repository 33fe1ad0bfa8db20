//! The bench compiled to WebAssembly: plain exports that `track.mjs` calls from Node.
#![allow(unsafe_code, reason = "an exported name is `unsafe(no_mangle)`; there is one of each here")]

#[allow(dead_code, reason = "the table is printed natively")]
mod cases;
mod field_case;
mod indoor_case;
mod kinematics_case;

use std::cell::RefCell;

use cases::{CASES, Running};
use indoor_case::IndoorCase;
use kinematics_case::KinematicsCase;
use rangelab::model::indoor::filter_settings::FilterName;
use rangelab::model::kinematics::settings::KinematicsName;

thread_local! {
    static RUNNING: RefCell<Option<Running>> = const { RefCell::new(None) };
    static INDOOR: IndoorCase = IndoorCase::new();
    static KINEMATICS: KinematicsCase = KinematicsCase::new();
}

/// Number of cases.
#[unsafe(no_mangle)]
pub extern "C" fn cases() -> usize {
    CASES.len()
}

/// Makes a case the one that runs.
#[unsafe(no_mangle)]
pub extern "C" fn start(case: usize) {
    RUNNING.set(Some(Running::new(&CASES[case])));
}

/// Makes steps of the case that runs.
#[unsafe(no_mangle)]
pub extern "C" fn steps(count: usize) -> f64 {
    RUNNING.with_borrow_mut(|running| running.as_mut().map_or(f64::NAN, |running| running.steps(count)))
}

/// Computes a field: the bound of raw or of projected ranges, or one more anchor.
#[unsafe(no_mangle)]
pub extern "C" fn field(case: usize) -> f64 {
    field_case::pass(case)
}

/// Runs all inertial filters over one recording.
#[unsafe(no_mangle)]
pub extern "C" fn indoor() -> f64 {
    INDOOR.with(|case| case.run(&FilterName::ALL))
}

/// Runs an estimator of relative kinematics.
#[unsafe(no_mangle)]
pub extern "C" fn kinematics(name: usize) -> f64 {
    KINEMATICS.with(|case| case.run(KinematicsName::ALL[name]))
}
