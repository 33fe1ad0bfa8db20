//! Floor 2: how well any estimator could do. It knows the truth and the noise, and no estimator.
//!
//! | bound | says |
//! |---|---|
//! | [`constrained::crb`] | unbiased estimate of any matrix `[Q \| t]` from one epoch |
//! | [`constrained::unitary_crb`] | the same for an estimate that knows `Q` to be a rotation |
//! | [`perturbed::perturbed_information`] | both where the sensors sit off their places on the body |
//! | [`sensors::sensor_trace`] | what either says of the positions of the sensors |
//! | [`posterior::PosteriorBound`] | the same with all epochs up to now and the prior |
//! | [`kinematics::KinematicsBound`] | relative kinematics of nodes without anchors, in the frame in which errors are measured |
//! | [`along::bounds_along`] | all of these at each step of a recording |

pub mod along;
mod cause;
pub mod constrained;
pub mod field;
pub mod fisher;
pub mod kinds;
pub mod kinematics;
pub mod observability;
pub mod perturbed;
pub mod posterior;
pub mod sensors;
pub mod size;
pub mod twin;

pub use crate::model::lack::Cause;
pub use along::{StepBounds, bounds_along, visit_bounds};
pub use constrained::{covariance_of, crb, unitary_crb};
pub use fisher::{FisherInformation, fisher_information, fisher_information_of};
pub use kinds::{Bound, BoundKind, BoundMatrix};
pub use observability::{Observability, observability};
pub use posterior::PosteriorBound;
