//! Relative kinematics of mobile nodes from the distances between them.

mod figures;
