//! Derivatives against differences, and the covariance of a corrected acceleration against its draws.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use rangelab::inertial::bilinear::{Prediction, State};
use rangelab::inertial::integrate::Interval;
use rangelab::inertial::lever_arm::acceleration_covariance;
use rangelab::math::exponential_integral::ExponentialIntegral;
use rangelab::math::rotation::{Rotation, hat};
use rangelab::model::imu::Input;
use rangelab::model::indoor::epoch::NavigationState;

use crate::plain;
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};

/// Step of the differences, and what they may be wrong by: the square of the step and rounding over the step.
const STEP: f64 = 1e-5;
const LIMIT: f64 = 1e-8;

struct Case {
    state: NavigationState,
    input: Input,
    length: f64,
}

fn case(sampler: &mut Sampler) -> Case {
    Case {
        state: NavigationState {
            rotation: sampler.rotation(),
            position: sampler.vector(3.0),
            velocity: sampler.vector(1.0),
        },
        input: Input {
            angular_velocity: sampler.vector(2.0),
            acceleration: sampler.vector(3.0),
            angular_velocity_variance: 1.0,
            acceleration_covariance: Matrix3::identity(),
        },
        length: sampler.uniform(0.01, 0.5),
    }
}

fn moved(state: &NavigationState, error: &SVector<f64, 9>) -> NavigationState {
    NavigationState {
        rotation: state.rotation.compose(&Rotation::exp(&[error[0], error[1], error[2]])),
        position: state.position + Vector3::new(error[3], error[4], error[5]),
        velocity: state.velocity + Vector3::new(error[6], error[7], error[8]),
    }
}

fn error(from: &NavigationState, to: &NavigationState) -> SVector<f64, 9> {
    let phi = from.rotation.inverse().compose(&to.rotation).log();
    let (p, v) = (to.position - from.position, to.velocity - from.velocity);
    SVector::from([phi[0], phi[1], phi[2], p[0], p[1], p[2], v[0], v[1], v[2]])
}

/// The end of the interval for another start and another input.
fn end(case: &Case, start: &SVector<f64, 9>, input: &SVector<f64, 6>) -> NavigationState {
    let mut driven = case.input;
    driven.angular_velocity += Vector3::new(input[0], input[1], input[2]);
    driven.acceleration += Vector3::new(input[3], input[4], input[5]);
    let gravity = Vector3::new(0.1, -0.3, -9.8);
    Interval::new(case.length, &driven, &gravity).apply(&moved(&case.state, start))
}

/// Central differences of the error at the end.
fn differences<const N: usize>(
    case: &Case,
    end: impl Fn(&SVector<f64, N>) -> NavigationState,
) -> SMatrix<f64, 9, N> {
    let nominal = self::end(case, &SVector::zeros(), &SVector::zeros());
    let mut result = SMatrix::<f64, 9, N>::zeros();
    for k in 0..N {
        let mut step = SVector::<f64, N>::zeros();
        step[k] = STEP;
        let difference = error(&nominal, &end(&step)) - error(&nominal, &end(&-step));
        result.set_column(k, &(difference / (2.0 * STEP)));
    }
    result
}

#[test]
fn the_transition_is_the_derivative_by_the_state() {
    let mut sampler = Sampler::new(1);
    for _ in 0..50 {
        let case = case(&mut sampler);
        let rotation = case.state.rotation.matrix();
        let interval = Interval::new(case.length, &case.input, &Vector3::zeros());
        let transition = interval.transition(rotation);
        let expected = differences(&case, |start| end(&case, start, &SVector::zeros()));
        at_most("transition", (transition - expected).abs().max(), LIMIT);
        let spoiled = Interval::new(1.01 * case.length, &case.input, &Vector3::zeros()).transition(rotation);
        caught("an interval longer by a hundredth", (spoiled - expected).abs().max(), 100.0 * LIMIT);
    }
}

#[test]
fn the_noise_is_that_of_the_derivative_by_the_input() {
    let mut sampler = Sampler::new(2);
    for _ in 0..50 {
        let case = case(&mut sampler);
        let rotation = case.state.rotation.matrix();
        let interval = Interval::new(case.length, &case.input, &Vector3::zeros());
        let expected = differences(&case, |input: &SVector<f64, 6>| end(&case, &SVector::zeros(), input));
        let blocks = interval.input_jacobian(rotation);
        let jacobian = SMatrix::<f64, 9, 6>::from_fn(|i, j| blocks[i / 3][j / 3][(i % 3, j % 3)]);
        at_most("input", (jacobian - expected).abs().max(), LIMIT);
        let noise = expected * expected.transpose();
        at_most("noise", (interval.noise(rotation) - noise).abs().max(), 10.0 * LIMIT);
        let without = Interval::new(
            case.length,
            &Input { acceleration: Vector3::zeros(), ..case.input },
            &Vector3::zeros(),
        );
        caught("no coupling of turn and acceleration", (without.noise(rotation) - noise).abs().max(), 1e-6);
    }
}

#[test]
fn the_prediction_of_the_paper_is_its_own_derivative() {
    let mut sampler = Sampler::new(3);
    let case = case(&mut sampler);
    let motion = Prediction::full(case.length, &case.input);
    let x = State::from_fn(|_, _| sampler.normal());
    let y = State::from_fn(|_, _| sampler.normal());
    let linear = motion.apply(&(x + y)) - motion.apply(&x) - motion.apply(&y);
    at_most("linearity", linear.abs().max(), 1e-13);
    // R' = R (I + T hat(omega)), v' = v + T R a, p' = p + T v + T^2/2 R a.
    let (t, r) = (case.length, Matrix3::from_fn(|i, j| x[3 * j + i]));
    let turned = r + r * hat::<3>(&case.input.angular_velocity.into()) * t;
    let accelerated = r * case.input.acceleration;
    let next = motion.apply(&x);
    for i in 0..3 {
        for j in 0..3 {
            at_most("R", (next[3 * j + i] - turned[(i, j)]).abs(), 1e-14);
        }
        at_most("p", (next[9 + i] - x[9 + i] - t * x[12 + i] - 0.5 * t * t * accelerated[i]).abs(), 1e-14);
        at_most("v", (next[12 + i] - x[12 + i] - t * accelerated[i]).abs(), 1e-14);
    }
}

#[test]
fn the_integrals_are_their_series() {
    let mut sampler = Sampler::new(4);
    for size in [0.0, 1e-9, 1e-4, 0.1, 1.9, 2.1, 3.0, 5.0] {
        let phi = Vector3::from(sampler.axis::<3>()) * size;
        let a = sampler.vector::<3>(1.0);
        let integral = ExponentialIntegral::new(&phi);
        for (n, matrix) in [(0, integral.exponential()), (1, integral.first()), (2, integral.second())] {
            let series = plain::series(phi.as_slice(), n);
            let expected = Matrix3::from_fn(|i, j| series[i][j]);
            at_most(&format!("G_{n} at {size}"), (matrix - expected).abs().max(), 1e-14);
        }
        for (n, matrix) in [(1, integral.first_derivative(&a)), (2, integral.second_derivative(&a))] {
            let columns: Vec<_> =
                (0..3).map(|axis| plain::series_slope(phi.as_slice(), n, a.as_slice(), axis)).collect();
            let expected = Matrix3::from_fn(|i, j| columns[j][i]);
            at_most(&format!("dG_{n} at {size}"), (matrix - expected).abs().max(), 1e-13);
            caught("its transpose", (matrix.transpose() - expected).abs().max(), 1e-2);
        }
        at_most(
            "Exp",
            (integral.exponential() - Rotation::exp(&phi.into()).matrix()).abs().max(),
            1e-15 * 4.0,
        );
    }
}

/// The corrected acceleration has the covariance of the formula, to what so many draws can tell.
#[test]
fn the_covariance_of_a_corrected_acceleration_is_that_of_its_draws() {
    // The entries of a covariance of n normal draws are off by sqrt(2/n) of the trace at most.
    corrected(0.1, 0.1, 2.0);
}

/// Where the noise is larger than the turn and slow, most comes from its squares, which spread like those of normal draws:
/// the fourth moment of a squared normal number is 15 times the square of its second instead of 3 times.
#[test]
fn so_it_is_where_the_squares_of_the_noise_count() {
    let (z, w, variance) = (LEVER, TURN, 4.0);
    corrected(2.0, 1.0, 14.0);
    let formula = acceleration_covariance(&w, &z, 1.0, variance, 0.0);
    let linear = acceleration_covariance(&w, &z, 1.0, 1e-9, 0.0) * (variance / 1e-9);
    caught("no squares", (formula - linear).abs().max() / formula.trace(), 0.1);
}

const LEVER: Vector3<f64> = Vector3::new(0.05, 0.02, -0.03);
const TURN: Vector3<f64> = Vector3::new(0.4, -1.1, 0.7);

/// Draws what the formula says, with a fourth moment that is `1 + spread` times the square of the second.
fn corrected(deviation: f64, t: f64, spread: f64) {
    const DRAWS: usize = 200_000;
    let (z, w, own) = (LEVER, TURN, 0.1 * deviation);
    let mut sampler = Sampler::new(5);
    let mut sum = Matrix3::zeros();
    let felt = |now: &Vector3<f64>, next: &Vector3<f64>| {
        let omega: Matrix3<f64> = hat(&(*now).into());
        (omega * omega + hat::<3>(&((next - now) / t).into())) * z
    };
    // The mean of omega^T A omega is above that of the means by the variance times the trace of A.
    let shift = z * (-2.0 * deviation * deviation);
    for _ in 0..DRAWS {
        let (now, next) = (w + sampler.vector::<3>(deviation), w + sampler.vector::<3>(deviation));
        let off = sampler.vector::<3>(own) - felt(&now, &next) + felt(&w, &w) + shift;
        sum += off * off.transpose();
    }
    let drawn = sum / DRAWS as f64;
    let formula = acceleration_covariance(&w, &z, t, deviation * deviation, own * own);
    let scale = formula.trace();
    let tolerance = 4.5 * (spread / DRAWS as f64).sqrt();
    at_most("covariance", (drawn - formula).abs().max() / scale, tolerance);
    let independent = acceleration_covariance(&Vector3::zeros(), &z, t, deviation * deviation, own * own);
    caught("no turn", (drawn - independent).abs().max() / scale, tolerance);
}
