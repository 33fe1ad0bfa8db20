//! The placement adviser: its slope against finite differences, its search against optima that are known, and the limits
//! it keeps.

#[path = "../support/mod.rs"]
mod support;

mod gradient;
mod limits;
mod next;
mod optima;
mod scenes;
mod search;
mod value;
