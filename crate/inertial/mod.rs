//! Floor 2: filters that follow a body by an IMU, with ranges now and then.
//!
//! The paper is \[I\], *Indoor Position and Attitude Tracking with SO(3) Manifold* (H. Salem, M. Ahmed, M. AlSharif,
//! A. Muqaibel, T. Al-Naffouri); its equations are corrected where they are misprinted. Its filters keep the nine entries
//! of `R` in a state of 15; the yardsticks beside them keep a rotation and an error of 9.

mod belief;
pub mod bilinear;
pub mod error_state;
pub mod extended;
pub mod filter;
pub mod front_end;
pub mod integrate;
pub mod invariant;
pub mod lever_arm;
pub mod nearest;
pub mod riemannian;
pub mod rigid_fix;
pub mod tight;
pub mod trilateration;
pub mod unscented;
mod update;

use alloc::boxed::Box;

use crate::error::Result;
use crate::model::indoor::epoch::{IndoorModel, IndoorStart};
use crate::model::indoor::filter_settings::{FilterName, FilterSettings};
use error_state::ErrorStateFilter;
use extended::{ExtendedFilter, Jacobian};
use filter::InertialFilter;
use invariant::InvariantFilter;
use riemannian::Riemannian;
use tight::TightFilter;
use unscented::UnscentedFilter;

/// The filter of a name, ready for the first epoch.
///
/// # Errors
/// [`crate::Error::NotPositiveDefinite`] or [`crate::Error::Number`] where the prior is none.
pub fn inertial_filter(
    name: FilterName,
    settings: &FilterSettings,
    model: &IndoorModel,
    start: &IndoorStart,
) -> Result<Box<dyn InertialFilter + Send>> {
    let (manifold, bare) = (Riemannian::of(settings), Riemannian::retraction_only(settings.retraction));
    let extended = |jacobian, manifold| ExtendedFilter::new(model, settings, start, jacobian, manifold);
    let unscented = |manifold| UnscentedFilter::new(model, settings, start, manifold);
    Ok(match name {
        FilterName::Ekf => Box::new(extended(Jacobian::Frozen, None)?),
        FilterName::EkfFull => Box::new(extended(Jacobian::Full, None)?),
        FilterName::EkfRetraction => Box::new(extended(Jacobian::Frozen, Some(bare))?),
        FilterName::EkfRie => Box::new(extended(Jacobian::Frozen, Some(manifold))?),
        FilterName::Ukf => Box::new(unscented(None)?),
        FilterName::UkfRie => Box::new(unscented(Some(manifold))?),
        FilterName::Mekf => Box::new(ErrorStateFilter::new(model, settings, start)?),
        FilterName::LieKf => Box::new(InvariantFilter::new(model, settings, start)?),
        FilterName::Tight => Box::new(TightFilter::new(model, start)?),
    })
}
