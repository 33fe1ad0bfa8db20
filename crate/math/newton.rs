//! Newton's method on SO(3) for the projection in a metric, safeguarded and polished.

use nalgebra::{SMatrix, SVector};

use super::float::sqrt;
use super::linalg::spd_inverse;
use super::quadratic::{Metric, distance};
use super::rotation::{Angles, MAX_ANGLES, Rotation, hat};
use super::singular::singular;
use super::trigonometric::{Harmonics, harmonics_of};
use crate::error::{Error, Result};

/// Ill-conditioned metrics make narrow curved valleys, along which steps are short: hundreds of steps, hardly ever.
const MAX_ITERATIONS: usize = 1000;

/// Steps below this (rad) lie where the cost no longer tells better from worse in double precision.
const LOCAL_STEP: f64 = 1e-5;

/// So do steps that promise to lower the cost by less than rounding the entries of `R` changes it: this part of `||W (q -
/// q_hat)||`.
const ROUNDING: f64 = 1e-14;

/// A curvature is negative beyond rounding below minus this part of the largest.
const CURVATURE: f64 = 1e-10;

const HALVINGS: usize = 40;

/// Coordinates of a turn.
pub type Angles3 = SVector<f64, MAX_ANGLES>;
/// Curvatures in coordinates of a turn.
pub type Hessian = SMatrix<f64, MAX_ANGLES, MAX_ANGLES>;

/// Minimizes `(q - q_hat)^T W (q - q_hat)` from `start`.
///
/// The paper stops when the gradient is 1e-6 of its terms, which leaves errors up to 2e-5 in `Q`; here full Newton steps
/// go on until they stop shrinking.
pub fn newton<const D: usize>(
    start: Rotation<D>,
    q: &SMatrix<f64, D, D>,
    metric: &impl Metric<D>,
) -> Result<Rotation<D>> {
    let mut rotation = start;
    let mut last = f64::INFINITY;
    for _ in 0..MAX_ITERATIONS {
        let Step { angles: step, convex, fall, noise } = newton_step(&rotation, q, metric);
        let size = sqrt(step.norm_squared());
        let local = convex && (size < LOCAL_STEP || fall <= noise);
        if size <= f64::EPSILON || (local && size >= 0.5 * last) {
            return Ok(rotation.renormalized());
        }
        let next =
            if local { Some(moved(&rotation, &step)) } else { descend(&rotation, &step, noise, q, metric) };
        let Some(next) = next else {
            return Ok(rotation.renormalized());
        };
        (rotation, last) = (next, size);
    }
    Err(Error::NoConvergence {
        what: "Newton's method on SO(3)",
        iterations: MAX_ITERATIONS,
        last_step: last,
    })
}

struct Step {
    angles: Angles3,
    /// The Hessian is positive definite.
    convex: bool,
    /// The fall of the cost that the step promises.
    fall: f64,
    /// What rounding adds to the cost.
    noise: f64,
}

/// Half the slope and half the curvatures of the cost along the turns `R exp(hat(phi))`; unused angles (D = 2) are zero.
#[derive(Clone, Copy, Debug)]
pub struct Expansion<const D: usize> {
    /// `W (R - Q_hat)`.
    pub residual: SMatrix<f64, D, D>,
    /// `<R E_i, W (R - Q_hat)>`.
    pub gradient: Angles3,
    /// `<R E_i, W R E_j>`: what Gauss and Newton take for the curvature, `J^T J`.
    pub gauss: Hessian,
    /// The curvature, `J^T J` and what the bend of the manifold adds (\[L\] eq. 65).
    pub hessian: Hessian,
}

impl<const D: usize> Expansion<D> {
    /// Expands the cost at an orthogonal matrix.
    pub fn at(rotation: &Rotation<D>, q: &SMatrix<f64, D, D>, metric: &impl Metric<D>) -> Self {
        let residual = metric.apply(&(rotation.matrix() - q));
        let tangents: [SMatrix<f64, D, D>; MAX_ANGLES] = core::array::from_fn(|i| rotation.tangent(i));
        let gradient = Angles3::from_fn(|i, _| tangents[i].dot(&residual));
        let mut gauss = Hessian::zeros();
        for i in 0..MAX_ANGLES {
            let image = metric.apply(&tangents[i]);
            for j in 0..MAX_ANGLES {
                gauss[(j, i)] = tangents[j].dot(&image);
            }
        }
        // <R (E_i E_j + E_j E_i)/2, W (R - Q_hat)>: with E_i = hat(e_i), E_i E_j = e_j e_i^T - delta_ij I.
        let curvature = rotation.matrix().transpose() * residual;
        let trace = curvature.trace();
        let mut hessian = gauss;
        if D == 2 {
            // One angle, E^2 = -I; the identity leaves unused angles alone.
            hessian = Hessian::identity();
            hessian[(0, 0)] = gauss[(0, 0)] - trace;
            return Self { residual, gradient, gauss, hessian };
        }
        for i in 0..MAX_ANGLES {
            for j in 0..MAX_ANGLES {
                hessian[(i, j)] += 0.5 * (curvature[(i, j)] + curvature[(j, i)]);
            }
            hessian[(i, i)] -= trace;
        }
        Self { residual, gradient, gauss, hessian }
    }
}

/// The Newton step at `rotation`.
fn newton_step<const D: usize>(
    rotation: &Rotation<D>,
    q: &SMatrix<f64, D, D>,
    metric: &impl Metric<D>,
) -> Step {
    let Expansion { residual, gradient, hessian, .. } = Expansion::at(rotation, q, metric);
    let noise = ROUNDING * sqrt(residual.norm_squared());
    let (step, convex) = match spd_inverse(&hessian) {
        Ok(inverse) => (-(inverse * gradient), true),
        Err(_) => (indefinite_step(&hessian, &gradient, noise), false),
    };
    Step { angles: step, convex, fall: -gradient.dot(&step), noise }
}

/// The step where the Hessian is not positive definite: Newton's with curvatures by their size, `-|H|^-1 g`, so that it goes
/// down; on a saddle or a maximum, where the slope is noise, a tenth of a radian along the most negative curvature (both
/// ways are equally good); none where no curvature is negative.
fn indefinite_step(hessian: &Hessian, gradient: &Angles3, noise: f64) -> Angles3 {
    let s = singular(hessian);
    let floor = CURVATURE * s.values[0];
    let curvature = |k: usize| s.left.column(k).dot(&s.right.column(k)) * s.values[k];
    let mut step = Angles3::zeros();
    for k in 0..MAX_ANGLES {
        let direction = s.right.column(k);
        if s.values[k] > floor {
            step -= direction * (direction.dot(gradient) / s.values[k]);
        }
    }
    if -gradient.dot(&step) > noise {
        return step;
    }
    let steepest = (0..MAX_ANGLES).fold(0, |best, k| if curvature(k) < curvature(best) { k } else { best });
    if curvature(steepest) < -floor { s.right.column(steepest) * 0.1 } else { Angles3::zeros() }
}

fn moved<const D: usize>(rotation: &Rotation<D>, step: &Angles3) -> Rotation<D> {
    rotation.compose(&Rotation::exp(&[step[0], step[1], step[2]]))
}

/// Halves the step until the cost falls by more than noise; `None` where it never does.
fn descend<const D: usize>(
    rotation: &Rotation<D>,
    step: &Angles3,
    noise: f64,
    q: &SMatrix<f64, D, D>,
    metric: &impl Metric<D>,
) -> Option<Rotation<D>> {
    let limit = distance(rotation, q, metric) - noise;
    (0..HALVINGS)
        .scan(*step, |step, _| {
            let candidate = moved(rotation, step);
            *step *= 0.5;
            Some(candidate)
        })
        .find(|candidate| distance(candidate, q, metric) < limit)
}

/// The cost along the turns `R exp(x hat(axis))` about a unit axis, a trigonometric polynomial (\[L\] eq. 66).
pub fn along_turn<const D: usize>(
    rotation: &Rotation<D>,
    axis: &Angles,
    q: &SMatrix<f64, D, D>,
    metric: &impl Metric<D>,
) -> Harmonics {
    // exp(x K) = I + sin x K + (1 - cos x) K^2.
    let k = hat::<D>(axis);
    let squared = rotation.matrix() * (k * k);
    let parts = [rotation.matrix() + squared - q, -squared, rotation.matrix() * k];
    let images = parts.map(|part| metric.apply(&part));
    harmonics_of(&core::array::from_fn(|i| core::array::from_fn(|j| parts[i].dot(&images[j]))))
}
