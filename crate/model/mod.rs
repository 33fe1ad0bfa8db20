//! Floor 1: the world as the estimators see it. Anchors, topology, ranges and their normal equations, motion.

pub mod accumulate;
pub mod anchors;
pub mod availability;
pub mod covariance;
pub mod document;
pub mod epoch;
pub mod estimator_settings;
pub mod field_settings;
pub mod lack;
pub mod localize_settings;
pub mod motion;
pub mod noise;
pub mod normal_equations;
pub mod path;
pub mod placement_settings;
pub mod presets;
pub mod ranges;
pub mod ranging;
pub mod recording;
pub mod run;
pub mod scenario;
pub mod sensor_equations;
pub mod spread;
pub mod topologies;
pub mod topology;
