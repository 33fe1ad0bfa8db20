//! The error-state (multiplicative) Kalman filter with exact integration: the yardstick for the paper's filters.

use nalgebra::{Matrix3, SMatrix};

use super::filter::{
    ErrorMatrix, ErrorVector, Events, FixRecord, InertialFilter, InertialStep, check_epoch, not_positive,
    require_finite,
};
use super::front_end::{Fix, FrontEnd};
use super::integrate::Interval;
use super::lever_arm;
use super::update::Update;
use crate::error::Result;
use crate::math::cholesky::Cholesky;
use crate::math::rotation::{Rotation, hat};
use crate::model::indoor::StartPrior;
use crate::model::indoor::epoch::{IndoorEpoch, IndoorModel, IndoorStart, NavigationState};
use crate::model::indoor::filter_settings::FilterSettings;

/// Loosely coupled: it updates with positions of the transmitters.
#[derive(Clone, Debug)]
pub struct ErrorStateFilter {
    model: IndoorModel,
    front_end: FrontEnd,
    belief: Navigation,
}

/// A state on SO(3) and the covariance of its error `(phi, p, v)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Navigation {
    pub state: NavigationState,
    pub covariance: ErrorMatrix,
}

impl Navigation {
    /// Before the first epoch.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the prior is no covariance.
    pub fn before(start: &IndoorStart) -> Result<Self> {
        let variances = match start.prior {
            StartPrior::Isotropic { variance } => [0.5 * variance, variance, variance],
            StartPrior::Tangent { angle, position, velocity } => {
                [angle * angle, position * position, velocity * velocity]
            }
        };
        let covariance = ErrorMatrix::from_diagonal(&ErrorVector::from_fn(|i, _| variances[i / 3]));
        Cholesky::new(&covariance).map_err(not_positive)?;
        let belief = Self { state: start.state, covariance };
        belief.check()?;
        Ok(belief)
    }

    /// Integrates the input of an epoch.
    ///
    /// # Errors
    /// [`crate::Error::Number`] where the state leaves double precision.
    pub fn predict(&mut self, model: &IndoorModel, epoch: &IndoorEpoch) -> Result<()> {
        let rotation = *self.state.rotation.matrix();
        let input = lever_arm::input(model, epoch, &rotation);
        let interval = Interval::new(epoch.interval, &input, &model.gravity);
        let transition = interval.transition(&rotation);
        self.covariance = transition * self.covariance * transition.transpose() + interval.noise(&rotation);
        self.state = interval.apply(&self.state);
        self.check()
    }

    /// Adds an error to the state.
    pub fn correct(&mut self, error: &ErrorVector) {
        let state = &mut self.state;
        let turn = Rotation::exp(&[error[0], error[1], error[2]]);
        state.rotation = state.rotation.compose(&turn).renormalized();
        for i in 0..3 {
            state.position[i] += error[3 + i];
            state.velocity[i] += error[6 + i];
        }
    }

    /// Takes the mean of the covariance and its transpose, which rounding has parted.
    pub fn symmetrize(&mut self) {
        self.covariance = (self.covariance + self.covariance.transpose()) * 0.5;
    }

    /// Refuses a state that left double precision.
    pub fn check(&self) -> Result<()> {
        let NavigationState { rotation, position, velocity } = &self.state;
        require_finite(rotation.matrix().iter().chain(position.iter()).chain(velocity.iter()))
    }

    /// What is reported of it.
    pub fn step(&self, fix: Option<FixRecord>) -> InertialStep {
        InertialStep {
            orientation: *self.state.rotation.matrix(),
            position: self.state.position,
            velocity: self.state.velocity,
            covariance: self.covariance,
            fix,
            events: Events::default(),
        }
    }
}

/// `d y/d(phi, p, v)` of the positions `p + R c_i`, with rows of zeros where a transmitter was not found.
pub(super) fn fix_jacobian(model: &IndoorModel, rotation: &Matrix3<f64>, fix: &Fix) -> SMatrix<f64, 9, 9> {
    let mut h = SMatrix::zeros();
    for (i, c) in model.transmitters.iter().enumerate() {
        if fix.transmitters[i].is_some() {
            super::integrate::set(&mut h, 3 * i, 0, &(rotation * hat::<3>(&(*c).into()) * -1.0));
            super::integrate::set(&mut h, 3 * i, 3, &Matrix3::identity());
        }
    }
    h
}

impl ErrorStateFilter {
    /// Starts from the prior.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the prior is no covariance.
    pub fn new(model: &IndoorModel, settings: &FilterSettings, start: &IndoorStart) -> Result<Self> {
        Ok(Self {
            model: model.clone(),
            front_end: FrontEnd::new(settings),
            belief: Navigation::before(start)?,
        })
    }
}

/// Updates a belief with a fix.
fn update(belief: &mut Navigation, model: &IndoorModel, fix: &Fix) -> Result<FixRecord> {
    let expected = model.transmitters.map(|c| belief.state.act(&c));
    let jacobian = fix_jacobian(model, belief.state.rotation.matrix(), fix);
    let cross = belief.covariance * jacobian.transpose();
    let spread = jacobian * cross + fix.covariance();
    let update = Update::new(&cross, &spread, &fix.innovation(&expected))?;
    belief.covariance -= update.learned;
    belief.correct(&update.correction);
    belief.check()?;
    Ok(FixRecord { nis: update.nis, degrees_of_freedom: fix.coordinates() })
}

impl InertialFilter for ErrorStateFilter {
    fn step(&mut self, epoch: &IndoorEpoch) -> Result<InertialStep> {
        check_epoch(epoch)?;
        let mut belief = self.belief;
        belief.predict(&self.model, epoch)?;
        let expected = self.model.transmitters.map(|c| belief.state.act(&c));
        let fix = self.front_end.fix(&self.model, &epoch.ranges, &expected);
        let record = fix.map(|fix| update(&mut belief, &self.model, &fix)).transpose()?;
        belief.symmetrize();
        self.belief = belief;
        Ok(belief.step(record))
    }
}
