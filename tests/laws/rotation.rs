//! `exp` and `log` on SO(D) against formulas that are accurate where the textbook ones are not.

use core::f64::consts::{FRAC_PI_2, PI};

use nalgebra::SMatrix;
use rangelab::Error;
use rangelab::math::float::{cos, sin};
use rangelab::math::rotation::{Angles, Rotation, defect, determinant, hat, rotation_angles, vee};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};

crate::in_plane_and_space!(
    exp_is_the_rotation_by_the_angle,
    log_undoes_exp_up_to_pi,
    log_is_accurate_next_to_pi,
    log_at_pi_gives_the_axis_up_to_sign,
    angles_beyond_pi_wrap,
    tiny_angles_keep_their_digits,
    rotations_form_a_group,
    composition_does_not_drift,
    from_matrix_takes_rotations_only,
    tangents_are_derivatives,
);

const ANGLES: [f64; 17] = [
    0.0,
    1e-300,
    1e-16,
    1e-9,
    9.999e-9,
    1.0001e-8,
    0.999e-4,
    1.0e-4,
    1.001e-4,
    1e-3,
    0.5,
    1.0,
    FRAC_PI_2 - 1e-12,
    FRAC_PI_2 + 1e-12,
    2.5,
    PI - 1e-4,
    PI - 1e-9,
];

/// Random axes and those along coordinates, of both signs.
fn axes<const D: usize>() -> Vec<Angles> {
    let mut sampler = Sampler::new(1);
    let mut axes: Vec<Angles> = (0..40).map(|_| sampler.axis::<D>()).collect();
    for i in 0..rotation_angles(D) {
        for sign in [1.0, -1.0] {
            let mut axis = [0.0; 3];
            axis[i] = sign;
            axes.push(axis);
        }
    }
    axes
}

/// The rotation by `pi - gap` from the unit quaternion `(sin(gap/2), cos(gap/2) axis)`: every entry to the last digits.
fn next_to_half_turn<const D: usize>(axis: &Angles, gap: f64) -> SMatrix<f64, D, D> {
    let (w, s) = (sin(0.5 * gap), cos(0.5 * gap));
    from_quaternion(w, &axis.map(|x| s * x))
}

fn from_quaternion<const D: usize>(w: f64, v: &Angles) -> SMatrix<f64, D, D> {
    let squared: f64 = v.iter().map(|x| x * x).sum();
    let mut r = hat::<D>(v) * (2.0 * w);
    for i in 0..D {
        for j in 0..D {
            r[(i, j)] += if D == 3 { 2.0 * v[i] * v[j] } else { 0.0 };
        }
        r[(i, i)] += w * w - squared;
    }
    r
}

fn distance(a: &Angles, b: &Angles) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

fn exp_is_the_rotation_by_the_angle<const D: usize>() {
    for axis in axes::<D>() {
        for angle in ANGLES.into_iter().chain([PI, 4.0, 6.0]) {
            let r = *Rotation::<D>::exp(&axis.map(|x| angle * x)).matrix();
            let reference = from_quaternion::<D>(cos(0.5 * angle), &axis.map(|x| sin(0.5 * angle) * x));
            at_most("exp against the quaternion", (r - reference).norm(), 2e-15);
            at_most("defect of exp", defect(&r), 2e-15);
            at_most("determinant of exp", (determinant(&r) - 1.0).abs(), 2e-15);
        }
    }
}

fn log_undoes_exp_up_to_pi<const D: usize>() {
    for axis in axes::<D>() {
        for angle in ANGLES {
            let phi = axis.map(|x| angle * x);
            let r = Rotation::<D>::exp(&phi);
            at_most("log(exp(phi))", distance(&r.log(), &phi), 1e-15 * angle.max(1.0));
            at_most("exp(log(R))", (Rotation::<D>::exp(&r.log()).matrix() - r.matrix()).norm(), 3e-15);
            at_most("angle", (r.angle() - angle).abs(), 1e-15 * angle.max(1.0));
        }
    }
}

fn log_is_accurate_next_to_pi<const D: usize>() {
    for axis in axes::<D>() {
        for gap in [1e-1, 1e-3, 1e-6, 1e-9, 1e-12] {
            let r = next_to_half_turn::<D>(&axis, gap);
            let phi = Rotation::<D>::from_matrix_unchecked(r).log();
            let expected = axis.map(|x| (PI - gap) * x);
            at_most("log next to pi", distance(&phi, &expected), 3e-15);
            if D == 3 && gap == 1e-9 {
                let textbook = vee::<D>(&(r - r.transpose())).map(|x| 0.5 * (PI - gap) / sin(PI - gap) * x);
                caught("the textbook log next to pi", distance(&textbook, &expected), 1e-9);
            }
        }
    }
}

fn log_at_pi_gives_the_axis_up_to_sign<const D: usize>() {
    for axis in axes::<D>() {
        for gap in [0.0, 1e-16, 1e-17, 1e-300] {
            let phi = Rotation::<D>::from_matrix_unchecked(next_to_half_turn::<D>(&axis, gap)).log();
            let half_turn = axis.map(|x| PI * x);
            let error = distance(&phi, &half_turn).min(distance(&phi, &half_turn.map(|x| -x)));
            at_most("log of a half turn", error, 3e-15);
            let again = Rotation::<D>::exp(&phi);
            at_most("half turn again", (again.matrix() - next_to_half_turn::<D>(&axis, gap)).norm(), 3e-15);
        }
    }
}

fn angles_beyond_pi_wrap<const D: usize>() {
    for axis in axes::<D>() {
        let phi = Rotation::<D>::exp(&axis.map(|x| 4.0 * x)).log();
        at_most("4 rad", distance(&phi, &axis.map(|x| (4.0 - 2.0 * PI) * x)), 2e-15);
        let phi = Rotation::<D>::exp(&axis.map(|x| 1000.0 * x)).log();
        let expected = 1000.0 - 159.0 * 2.0 * PI;
        at_most("1000 rad", distance(&phi, &axis.map(|x| expected * x)), 1e-12);
    }
}

fn tiny_angles_keep_their_digits<const D: usize>() {
    for axis in axes::<D>() {
        for angle in [1e-300, 1e-150, 1e-100, 1e-30, 1e-16, 1e-9, 1e-8, 1e-5] {
            let phi = axis.map(|x| angle * x);
            let error = distance(&Rotation::<D>::exp(&phi).log().map(|x| x / angle), &axis);
            at_most("relative error of a tiny angle", error, 4e-16);
        }
    }
}

fn rotations_form_a_group<const D: usize>() {
    let mut sampler = Sampler::new(2);
    for _ in 0..200 {
        let (a, b, c) = (sampler.rotation::<D>(), sampler.rotation::<D>(), sampler.rotation::<D>());
        let associated = a.compose(&b).compose(&c).matrix() - a.compose(&b.compose(&c)).matrix();
        at_most("(ab)c - a(bc)", associated.norm(), 3e-15);
        let identity = a.compose(&a.inverse());
        at_most("a a^-1", (identity.matrix() - Rotation::<D>::identity().matrix()).norm(), 3e-15);
        let turned = a.compose(&b).inverse().matrix() - b.inverse().compose(&a.inverse()).matrix();
        at_most("(ab)^-1 - b^-1 a^-1", turned.norm(), 3e-15);
    }
}

fn composition_does_not_drift<const D: usize>() {
    let mut sampler = Sampler::new(3);
    let mut r = Rotation::<D>::identity();
    for _ in 0..1000 {
        r = r.compose(&sampler.rotation());
    }
    at_most("defect after 1000 products", defect(r.matrix()), 1e-13);
}

fn from_matrix_takes_rotations_only<const D: usize>() {
    let r = *Sampler::new(4).rotation::<D>().matrix();
    assert!(Rotation::from_matrix(&r).is_ok());
    let healed = Rotation::from_matrix(&(r * (1.0 + 1e-8))).unwrap();
    at_most("projected", defect(healed.matrix()), 2e-15);
    at_most("near", (healed.matrix() - r).norm(), 3e-15);
    let mut mirrored = r;
    mirrored.column_mut(0).neg_mut();
    for bad in [r * 1.001, mirrored, r * 0.0, r * f64::NAN, r * f64::INFINITY] {
        let Err(Error::Number { .. }) = Rotation::from_matrix(&bad) else { panic!("{bad} was taken") };
    }
}

fn tangents_are_derivatives<const D: usize>() {
    let mut sampler = Sampler::new(5);
    for _ in 0..50 {
        let r = sampler.rotation::<D>();
        for i in 0..rotation_angles(D) {
            let step = 1e-5;
            let moved = |sign: f64| {
                let mut phi = [0.0; 3];
                phi[i] = sign * step;
                *r.compose(&Rotation::exp(&phi)).matrix()
            };
            let slope = (moved(1.0) - moved(-1.0)) / (2.0 * step);
            at_most("derivative", (slope - r.tangent(i)).norm(), 1e-10);
            caught("the derivative on the left", (slope - r.tangent(i) * 1.0001).norm(), 1e-10);
        }
    }
}
