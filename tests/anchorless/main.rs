//! Relative kinematics of mobile nodes from the distances between them.

mod degenerate_networks;
mod figures;
mod kinematics_bound;
mod likelihood;
mod likelihood_tables;
mod minimum_nodes;
mod mirrored_minimum;
mod networks;
mod recovery;

#[path = "../support/mod.rs"]
mod support;
