//! Floor 2: mobile nodes without anchors. Relative positions, velocities and accelerations from the distances between them,
//! with or without accelerometers (\[A\]).
