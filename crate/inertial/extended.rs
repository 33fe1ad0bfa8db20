//! The extended Kalman filter on `[vec(R); p; v]` and EKFRie (\[I\] Algorithm 1).

use super::belief::Belief;
use super::bilinear::{InputNoise, Prediction, Transmitters, check, fall, orientation};
use super::filter::{Events, FixRecord, InertialFilter, InertialStep, check_epoch};
use super::front_end::{Fix, FrontEnd};
use super::lever_arm;
use super::riemannian::Riemannian;
use super::update::Update;
use crate::error::Result;
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
        belief.symmetrize();
        self.belief = belief;
        Ok(belief.step(record))
    }
}
