//! The extended Kalman filter on `[vec(R); p; v]` and EKFRie (\[I\] Algorithm 1).

use nalgebra::Matrix3;

use super::bilinear::{
    InputNoise, Prediction, State, StateMatrix, Transmitters, check, fall, orientation, set_orientation,
    start, tangent_covariance,
};
use super::filter::{Events, FixRecord, InertialFilter, InertialStep, check_epoch, not_positive};
use super::front_end::{Fix, FrontEnd};
use super::lever_arm;
use super::riemannian::{Riemannian, transport};
use super::update::Update;
use crate::error::Result;
use crate::math::cholesky::Cholesky;
use crate::model::indoor::epoch::{IndoorEpoch, IndoorModel, IndoorStart};
use crate::model::indoor::filter_settings::FilterSettings;

/// What the covariance is carried by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Jacobian {
    /// `F` of \[I\] eq. 15: `g(X) u` is taken for a constant, as step 5 is printed.
    Frozen,
    /// `F + d(g(X) u)/dX`.
    Full,
}

/// EKF, EKF with retraction, and EKFRie.
#[derive(Clone, Debug)]
pub struct ExtendedFilter {
    model: IndoorModel,
    front_end: FrontEnd,
    transmitters: Transmitters,
    jacobian: Jacobian,
    manifold: Option<Riemannian>,
    belief: Belief,
}

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
        rotation: super::riemannian::Retracted,
    ) {
        let block = before.fixed_view::<9, 9>(0, 0).into_owned();
        transport(manifold.transport, &mut self.p, &block, old, &rotation.rotation);
        set_orientation(&mut self.x, &rotation.rotation);
        self.events.reflected |= rotation.reflected;
    }

    /// What is reported of it.
    pub fn step(&self, fix: Option<FixRecord>) -> InertialStep {
        InertialStep {
            orientation: orientation(&self.x),
            position: super::bilinear::block(&self.x, 3),
            velocity: super::bilinear::block(&self.x, 4),
            covariance: tangent_covariance(&self.x, &self.p),
            fix,
            events: self.events,
        }
    }
}

impl ExtendedFilter {
    /// Starts from the prior.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the prior is no covariance.
    pub fn new(
        model: &IndoorModel,
        settings: &FilterSettings,
        initial: &IndoorStart,
        jacobian: Jacobian,
        manifold: Option<Riemannian>,
    ) -> Result<Self> {
        Ok(Self {
            model: model.clone(),
            front_end: FrontEnd::new(settings),
            transmitters: Transmitters::new(model),
            jacobian,
            manifold,
            belief: Belief::before(initial)?,
        })
    }

    /// Steps 2 to 8.
    fn predict(&self, belief: &mut Belief, epoch: &IndoorEpoch) -> Result<()> {
        let (old, before) = (orientation(&belief.x), belief.p);
        let input = lever_arm::input(&self.model, epoch, &old);
        let motion = Prediction::full(epoch.interval, &input);
        belief.p = match self.jacobian {
            Jacobian::Frozen => Prediction::frozen(epoch.interval).congruence(&belief.p),
            Jacobian::Full => motion.congruence(&belief.p),
        };
        InputNoise::at(&old, &input, epoch.interval).add_to(&mut belief.p, epoch.interval);
        belief.x = motion.apply(&belief.x);
        fall(&mut belief.x, &self.model.gravity, epoch.interval);
        check(&belief.x)?;
        if let Some(manifold) = self.manifold {
            let turned = manifold.retract(&old, &(orientation(&belief.x) - old))?;
            belief.stay(manifold, &before, &old, turned);
        }
        Ok(())
    }

    /// Steps 10 to 17.
    fn update(&self, belief: &mut Belief, fix: &Fix) -> Result<FixRecord> {
        let (old, before, mask) = (orientation(&belief.x), belief.p, fix.mask());
        let cross = self.transmitters.cross(&belief.p, &mask);
        let spread = self.transmitters.spread(&cross, &mask) + fix.covariance();
        let innovation = fix.innovation(&self.transmitters.expected(&belief.x));
        let update = Update::new(&cross, &spread, &innovation)?;
        belief.x += update.correction;
        belief.p -= update.learned;
        check(&belief.x)?;
        if let Some(manifold) = self.manifold {
            let turned = manifold.retract_correction(&old, &(orientation(&belief.x) - old))?;
            belief.stay(manifold, &before, &old, turned);
        }
        Ok(FixRecord { nis: update.nis, degrees_of_freedom: fix.coordinates() })
    }
}

impl InertialFilter for ExtendedFilter {
    fn step(&mut self, epoch: &IndoorEpoch) -> Result<InertialStep> {
        check_epoch(epoch)?;
        let mut belief = Belief { events: Events::default(), ..self.belief };
        self.predict(&mut belief, epoch)?;
        let expected = self.transmitters.expected(&belief.x);
        let fix = self.front_end.fix(&self.model, &epoch.ranges, &expected);
        let record = fix.map(|fix| self.update(&mut belief, &fix)).transpose()?;
        self.belief = belief;
        Ok(belief.step(record))
    }
}
