//! Position and orientation of a rigid body from ranges.
