//! What a filter on `[vec(R); p; v]` believes.

use nalgebra::Matrix3;

use super::bilinear::{
    State, StateMatrix, block, check, orientation, set_orientation, start, tangent_covariance,
};
use super::filter::{Events, FixRecord, InertialStep, not_positive};
use super::riemannian::{Retracted, Riemannian, transport};
use crate::error::Result;
use crate::math::cholesky::Cholesky;
use crate::model::indoor::epoch::IndoorStart;

/// State and covariance, as they go through a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Belief {
    pub x: State,
    pub p: StateMatrix,
    pub events: Events,
}

impl Belief {
    /// Before the first epoch.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the prior is no covariance.
    pub fn before(initial: &IndoorStart) -> Result<Self> {
        let (x, p) = start(initial);
        Cholesky::new(&p).map_err(not_positive)?;
        check(&x)?;
        Ok(Self { x, p, events: Events::default() })
    }

    /// Moves `R` from `old`, which `v` was added to, onto SO(3), and the covariance with it. `before` is the covariance
    /// from before the step.
    pub fn stay(
        &mut self,
        manifold: Riemannian,
        before: &StateMatrix,
        old: &Matrix3<f64>,
        rotation: Retracted,
    ) {
        let block = before.fixed_view::<9, 9>(0, 0).into_owned();
        transport(manifold.transport, &mut self.p, &block, old, &rotation.rotation);
        set_orientation(&mut self.x, &rotation.rotation);
        self.events.reflected |= rotation.reflected;
    }

    /// Takes the mean of the covariance and its transpose, which rounding has parted.
    pub fn symmetrize(&mut self) {
        self.p = (self.p + self.p.transpose()) * 0.5;
    }

    /// What is reported of it.
    pub fn step(&self, fix: Option<FixRecord>) -> InertialStep {
        InertialStep {
            orientation: orientation(&self.x),
            position: block(&self.x, 3),
            velocity: block(&self.x, 4),
            covariance: tangent_covariance(&self.x, &self.p),
            fix,
            events: self.events,
        }
    }
}
