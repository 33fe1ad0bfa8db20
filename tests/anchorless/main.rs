//! Relative kinematics of mobile nodes from the distances between them.

mod bound_over_time;
mod degenerate_networks;
mod documents;
mod edges;
mod exact;
mod figures;
mod gauge;
mod kinematics_bound;
mod likelihood;
mod likelihood_tables;
mod minimum_nodes;
mod mirrored_minimum;
mod networks;
mod presets;
mod recovery;
mod scenes;
mod sensed_accelerations;
mod simulation;
mod starts;
mod study;
mod table;
mod wrong_branch;

#[path = "../support/mod.rs"]
mod support;
