//! Floor 0: numbers, small matrices, rotations and poses.

pub mod block;
pub mod chi_squared;
pub mod cholesky;
pub mod definite;
pub mod exponential_integral;
pub mod factorial;
pub mod float;
pub mod legendre;
pub mod linalg;
pub mod newton;
pub mod number;
pub mod orthogonal;
mod polar;
pub mod pose;
pub mod projection;
pub mod quadratic;
pub mod rotation;
pub mod secular;
pub mod singular;
pub mod tangent;
pub mod trigonometric;
