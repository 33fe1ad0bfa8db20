//! The left-invariant extended Kalman filter on `SE_2(3)` (Barrau and Bonnabel 2017).

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::error_state::Navigation;
use super::filter::{ErrorMatrix, ErrorVector, FixRecord, InertialFilter, InertialStep, check_epoch};
use super::front_end::{Fix, FrontEnd};
use super::integrate::{Interval, set};
use super::lever_arm;
use super::update::Update;
use crate::error::Result;
use crate::math::exponential_integral::ExponentialIntegral;
use crate::math::rotation::Rotation;
use crate::model::indoor::epoch::{IndoorEpoch, IndoorModel, IndoorStart};
use crate::model::indoor::filter_settings::FilterSettings;

/// The error lives in the body frame: `X_true = X Exp(xi)` with `X = (R, p, v)`, so that
///
/// ```text
/// R_true = R Exp(phi),  p_true = p + R G_1(phi) xi_p,  v_true = v + R G_1(phi) xi_v
/// ```
///
/// Its propagation and its measurement of positions do not depend on the state.
#[derive(Clone, Debug)]
pub struct InvariantFilter {
    model: IndoorModel,
    front_end: FrontEnd,
    /// The covariance is that of `xi`.
    belief: Navigation,
}

impl InvariantFilter {
    /// Starts from the prior.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the prior is no covariance.
    pub fn new(model: &IndoorModel, settings: &FilterSettings, start: &IndoorStart) -> Result<Self> {
        let mut belief = Navigation::before(start)?;
        let into_body = frame_change(&belief.state.rotation.matrix().transpose());
        belief.covariance = into_body * belief.covariance * into_body.transpose();
        Ok(Self { model: model.clone(), front_end: FrontEnd::new(settings), belief })
    }

    fn predict(&self, belief: &mut Navigation, epoch: &IndoorEpoch) -> Result<()> {
        let rotation = *belief.state.rotation.matrix();
        let input = lever_arm::input(&self.model, epoch, &rotation);
        let interval = Interval::new(epoch.interval, &input, &self.model.gravity);
        let turned = interval.turn.transpose();
        // The error-state filter's propagation at the identity, seen in the axes after the turn.
        let into_body = frame_change(&turned);
        let transition = into_body * interval.transition(&Matrix3::identity());
        let noise = into_body * interval.noise(&Matrix3::identity()) * into_body.transpose();
        belief.covariance = transition * belief.covariance * transition.transpose() + noise;
        belief.state = interval.apply(&belief.state);
        belief.check()
    }

    fn update(&self, belief: &mut Navigation, fix: &Fix) -> Result<FixRecord> {
        let expected = self.model.transmitters.map(|c| belief.state.act(&c));
        let jacobian = self.jacobian(belief.state.rotation.matrix(), fix);
        let cross = belief.covariance * jacobian.transpose();
        let spread = jacobian * cross + fix.covariance();
        let update = Update::new(&cross, &spread, &fix.innovation(&expected))?;
        belief.covariance -= update.learned;
        move_along(belief, &update.correction);
        belief.check()?;
        Ok(FixRecord { nis: update.nis, degrees_of_freedom: fix.coordinates() })
    }

    /// `y_i = p + R c_i` moves by `R (xi_p - hat(c_i) phi)`.
    fn jacobian(&self, rotation: &Matrix3<f64>, fix: &Fix) -> SMatrix<f64, 9, 9> {
        let mut h = super::error_state::fix_jacobian(&self.model, rotation, fix);
        for i in 0..3 {
            if fix.transmitters[i].is_some() {
                set(&mut h, 3 * i, 3, rotation);
            }
        }
        h
    }
}

/// `X Exp(xi)`.
fn move_along(belief: &mut Navigation, xi: &ErrorVector) {
    let part = |k: usize| Vector3::from_fn(|i, _| xi[3 * k + i]);
    let integral = ExponentialIntegral::new(&part(0));
    let state = &mut belief.state;
    let frame = state.rotation.matrix() * integral.first();
    state.position += frame * part(1);
    state.velocity += frame * part(2);
    state.rotation =
        Rotation::from_matrix_unchecked(state.rotation.matrix() * integral.exponential()).renormalized();
}

/// Position and velocity into other axes, angles left as they are.
fn frame_change(axes: &Matrix3<f64>) -> ErrorMatrix {
    let mut change = ErrorMatrix::identity();
    set(&mut change, 3, 3, axes);
    set(&mut change, 6, 6, axes);
    change
}

impl InertialFilter for InvariantFilter {
    fn step(&mut self, epoch: &IndoorEpoch) -> Result<InertialStep> {
        check_epoch(epoch)?;
        let mut belief = self.belief;
        self.predict(&mut belief, epoch)?;
        let expected = self.model.transmitters.map(|c| belief.state.act(&c));
        let fix = self.front_end.fix(&self.model, &epoch.ranges, &expected);
        let record = fix.map(|fix| self.update(&mut belief, &fix)).transpose()?;
        belief.symmetrize();
        self.belief = belief;
        let into_world = frame_change(belief.state.rotation.matrix());
        let covariance = into_world * belief.covariance * into_world.transpose();
        Ok(Navigation { covariance, ..belief }.step(record))
    }
}
