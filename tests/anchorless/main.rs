//! Relative kinematics of mobile nodes from the distances between them.

mod documents;
mod edges;
mod exact;
mod figures;
mod gauge;
mod scenes;
mod simulation;
mod study;
