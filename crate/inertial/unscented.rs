//! The unscented Kalman filter on `[vec(R); p; v]` and UKFRie (\[I\] Algorithm 2).

use nalgebra::{SMatrix, SVector};

use super::belief::Belief;
use super::bilinear::{InputNoise, Prediction, STATE, State, Transmitters, check, fall, orientation};
use super::filter::{Events, FixRecord, InertialFilter, InertialStep, check_epoch};
use super::front_end::{Fix, FrontEnd};
use super::lever_arm;
use super::nearest::nearest_positive_definite;
use super::riemannian::Riemannian;
use super::update::Update;
use crate::error::Result;
use crate::math::cholesky::Cholesky;
use crate::math::float::sqrt;
use crate::model::indoor::epoch::{IndoorEpoch, IndoorModel, IndoorStart};
use crate::model::indoor::filter_settings::{FilterSettings, InputNoiseWeights, Transport};

/// `alpha` of the scaled unscented transform. The paper takes 1e-3; where, as here, everything is at most quadratic in the
/// state it drops out, and 1 loses no digits in sums that 1e-3 gives weights of -9e5 and 3e4.
const ALPHA: f64 = 1.0;
/// `kappa`, the paper's iota. It drops out too.
const KAPPA: f64 = 1.0;
/// The paper's `alpha`, which does not drop out where weights are squared.
const PRINTED_ALPHA: f64 = 1e-3;

/// UKF and UKFRie.
#[derive(Clone, Debug)]
pub struct UnscentedFilter {
    model: IndoorModel,
    front_end: FrontEnd,
    transmitters: Transmitters,
    manifold: Option<Riemannian>,
    weights: InputNoiseWeights,
    belief: Belief,
}

/// Sigma points as differences from their centre, one column of the Cholesky factor and its negative after the other.
///
/// ```text
/// chi_0 = x,  chi_(2i, 2i+1) = x +- s L_i,  s^2 = alpha^2 (L + kappa),  xi = 1/(2 s^2),  xi_0 = 1 - 2 L xi
/// ```
///
/// Sums over the points are taken of differences from the centre, so that `xi_0` never multiplies anything:
/// `sum xi (y - y_0) + y_0`, and for covariances `sum xi d d^T - dbar dbar^T`.
struct SigmaPoints {
    columns: SMatrix<f64, STATE, STATE>,
    weight: f64,
}

impl SigmaPoints {
    fn new(factor: &Cholesky<STATE>) -> Self {
        let squared = ALPHA * ALPHA * (STATE as f64 + KAPPA);
        Self { columns: factor.lower() * sqrt(squared), weight: 0.5 / squared }
    }

    /// The points without their centre, as differences from it.
    fn differences(&self) -> impl Iterator<Item = State> {
        (0..STATE).flat_map(|i| {
            let column = self.columns.column(i).into_owned();
            [column, -column]
        })
    }
}

/// The covariance of two functions of the sigma points, given as differences from their values at the centre.
struct CrossSum<const M: usize, const N: usize> {
    products: SMatrix<f64, M, N>,
    left: SVector<f64, M>,
    right: SVector<f64, N>,
}

impl<const M: usize, const N: usize> CrossSum<M, N> {
    fn new() -> Self {
        Self { products: SMatrix::zeros(), left: SVector::zeros(), right: SVector::zeros() }
    }

    fn add(&mut self, weight: f64, left: &SVector<f64, M>, right: &SVector<f64, N>) {
        for j in 0..N {
            let scaled = weight * right[j];
            for i in 0..M {
                self.products[(i, j)] += left[i] * scaled;
            }
        }
        self.left += left * weight;
        self.right += right * weight;
    }

    fn covariance(&self) -> SMatrix<f64, M, N> {
        self.products - self.left * self.right.transpose()
    }
}

/// What the points of the prediction leave to step 13 as printed: their differences from the centre, once moved.
type Moved = [State; 2 * STATE];

impl UnscentedFilter {
    /// Starts from the prior.
    ///
    /// # Errors
    /// [`crate::Error::NotPositiveDefinite`] where the prior is no covariance.
    pub fn new(
        model: &IndoorModel,
        settings: &FilterSettings,
        initial: &IndoorStart,
        manifold: Option<Riemannian>,
    ) -> Result<Self> {
        Ok(Self {
            model: model.clone(),
            front_end: FrontEnd::new(settings),
            transmitters: Transmitters::new(model),
            manifold,
            weights: settings.input_noise_weights,
            belief: Belief::before(initial)?,
        })
    }

    fn transport(&self) -> Transport {
        self.manifold.map_or(Transport::None, |manifold| manifold.transport)
    }

    /// Steps 2 to 8.
    fn predict(&self, belief: &mut Belief, epoch: &IndoorEpoch) -> Result<Moved> {
        let (old, before, t) = (orientation(&belief.x), belief.p, epoch.interval);
        let input = lever_arm::input(&self.model, epoch, &old);
        let motion = Prediction::full(t, &input);
        let points = sigma_points(belief)?;
        let (centre, here) = (motion.apply(&belief.x), InputNoise::at(&old, &input, t));
        let (mut spread, mut noise) = (CrossSum::<STATE, STATE>::new(), here);
        let mut moved = [State::zeros(); 2 * STATE];
        for (moved, difference) in moved.iter_mut().zip(points.differences()) {
            let point = belief.x + difference;
            *moved = motion.apply(&point) - centre;
            spread.add(points.weight, moved, moved);
            noise.add_difference(points.weight, &InputNoise::at(&orientation(&point), &input, t), &here);
        }
        belief.x = centre + spread.left;
        belief.p = spread.covariance();
        if self.weights == InputNoiseWeights::Squared {
            noise = squared_weights(&here, &noise);
        }
        noise.add_to(&mut belief.p, t);
        fall(&mut belief.x, &self.model.gravity, t);
        check(&belief.x)?;
        if let Some(manifold) = self.manifold {
            let turned = manifold.retract(&old, &(orientation(&belief.x) - old))?;
            // The points have carried the covariance over the motion; another congruence would turn it twice.
            let kept = if manifold.transport == Transport::Congruence {
                Transport::None
            } else {
                manifold.transport
            };
            belief.stay(Riemannian { transport: kept, ..manifold }, &before, &old, turned);
        }
        Ok(moved)
    }

    /// Steps 10 to 18.
    fn update(&self, belief: &mut Belief, fix: &Fix, moved: &Moved) -> Result<FixRecord> {
        let mask = fix.mask();
        let points = sigma_points(belief)?;
        let (old, before) = (orientation(&belief.x), belief.p);
        let centre = self.transmitters.apply(&belief.x, &mask);
        let (mut spread, mut cross) = (CrossSum::<9, 9>::new(), CrossSum::<STATE, 9>::new());
        for (difference, moved) in points.differences().zip(moved) {
            let expected = self.transmitters.apply(&(belief.x + difference), &mask) - centre;
            let state = if self.transport() == Transport::Literal { *moved } else { difference };
            spread.add(points.weight, &expected, &expected);
            cross.add(points.weight, &state, &expected);
        }
        let spread = spread.covariance() + fix.covariance();
        let innovation = fix.innovation(&self.transmitters.expected(&belief.x));
        let update = Update::new(&cross.covariance(), &spread, &innovation)?;
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

/// `sum xi_l^2 N(chi_l)` for the paper's `alpha`, where `once = sum xi_l N(chi_l)` for any, and `here = N(chi_0)`.
///
/// As `N` is a quadratic form of `R`, `sum_l>0 (N(chi_l) - N(chi_0))` is `(once - here)/xi`, in proportion to `1/xi`.
fn squared_weights(here: &InputNoise, once: &InputNoise) -> InputNoise {
    let xi = 0.5 / (PRINTED_ALPHA * PRINTED_ALPHA * (STATE as f64 + KAPPA));
    let points = 2.0 * STATE as f64;
    let centre = 1.0 - points * xi;
    let mut noise = here.scaled(centre * centre + points * xi * xi);
    noise.add_difference(xi, once, here);
    noise
}

/// The points of a belief, whose covariance is replaced by the nearest positive definite one where it is none.
fn sigma_points(belief: &mut Belief) -> Result<SigmaPoints> {
    if let Ok(factor) = Cholesky::new(&belief.p) {
        return Ok(SigmaPoints::new(&factor));
    }
    let (repaired, factor) = nearest_positive_definite(&belief.p)?;
    belief.p = repaired;
    belief.events.repairs += 1;
    Ok(SigmaPoints::new(&factor))
}

impl InertialFilter for UnscentedFilter {
    fn step(&mut self, epoch: &IndoorEpoch) -> Result<InertialStep> {
        check_epoch(epoch)?;
        let mut belief = Belief { events: Events::default(), ..self.belief };
        let moved = self.predict(&mut belief, epoch)?;
        let expected = self.transmitters.expected(&belief.x);
        let fix = self.front_end.fix(&self.model, &epoch.ranges, &expected);
        let record = fix.map(|fix| self.update(&mut belief, &fix, &moved)).transpose()?;
        belief.symmetrize();
        self.belief = belief;
        Ok(belief.step(record))
    }
}
