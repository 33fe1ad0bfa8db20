//! Poses: the group SE(D), and steps on SO(D) x R^D.

use nalgebra::SVector;
use rangelab::math::pose::{Pose, Theta};
use rangelab::math::rotation::rotation_angles;

use crate::support::at_most;
use crate::support::sampling::Sampler;

crate::in_plane_and_space!(
    poses_form_a_group,
    local_undoes_retract,
    retract_turns_on_the_right,
    theta_is_a_matrix
);

fn gap<const D: usize>(a: &Pose<D>, b: &Pose<D>) -> f64 {
    (a.rotation.matrix() - b.rotation.matrix()).norm() + (a.position - b.position).norm()
}

fn poses_form_a_group<const D: usize>() {
    let mut sampler = Sampler::new(50);
    for _ in 0..200 {
        let (a, b, c) = (sampler.pose::<D>(2.0), sampler.pose::<D>(2.0), sampler.pose::<D>(2.0));
        at_most("a a^-1", gap(&a.compose(&a.inverse()), &Pose::identity()), 1e-14);
        at_most("associative", gap(&a.compose(&b).compose(&c), &a.compose(&b.compose(&c))), 3e-14);
        let point = sampler.vector::<D>(1.0);
        let error = a.compose(&b).act(&point) - a.act(&b.act(&point));
        at_most("composition acts in turn", error.norm(), 2e-14);
        at_most("distances stay", (a.act(&point) - a.position).norm() - point.norm(), 2e-14);
    }
}

fn local_undoes_retract<const D: usize>() {
    let mut sampler = Sampler::new(51);
    for angle in [0.0, 1e-12, 1e-3, 1.0, 3.0, 3.1] {
        for _ in 0..50 {
            let pose = sampler.pose::<D>(2.0);
            let phi = sampler.axis::<D>().map(|x| angle * x);
            let shift = sampler.vector::<D>(1.0);
            let (phi_found, shift_found) = pose.local(&pose.retract(&phi, &shift));
            let error: f64 = phi_found.iter().zip(phi).map(|(x, y)| (x - y).abs()).sum();
            at_most("phi", error, 1e-14);
            at_most("shift", (shift_found - shift).norm(), 1e-14);
            let other = sampler.pose::<D>(2.0);
            let (to_other, to_place) = pose.local(&other);
            at_most("retract undoes local", gap(&pose.retract(&to_other, &to_place), &other), 2e-14);
        }
    }
}

fn retract_turns_on_the_right<const D: usize>() {
    let mut sampler = Sampler::new(52);
    let pose = sampler.pose::<D>(1.0);
    for i in 0..rotation_angles(D) {
        let mut phi = [0.0; 3];
        phi[i] = 1e-6;
        let moved = pose.retract(&phi, &SVector::zeros());
        let slope = (moved.rotation.matrix() - pose.rotation.matrix()) / 1e-6;
        at_most("slope", (slope - pose.rotation.tangent(i)).norm(), 3e-6);
    }
}

fn theta_is_a_matrix<const D: usize>() {
    let mut sampler = Sampler::new(53);
    let (a, b) = (sampler.theta::<D>(1.0), sampler.theta::<D>(1.0));
    let mut sum = a.minus(&b);
    for j in 0..=D {
        sum.add_to_column(j, &b.column(j));
    }
    at_most("a - b + b", sum.minus(&a).dot(&sum.minus(&a)).sqrt(), 1e-15);
    let columns: f64 = (0..=D).map(|j| a.column(j).dot(&b.column(j))).sum();
    at_most("dot", (columns - a.dot(&b)).abs(), 1e-14);
    assert!(a.is_finite());
    for bad in [f64::NAN, f64::INFINITY] {
        let mut spoiled: Theta<D> = a;
        spoiled.position[D - 1] = bad;
        assert!(!spoiled.is_finite());
        let mut spoiled: Theta<D> = a;
        spoiled.orientation[(0, D - 1)] = bad;
        assert!(!spoiled.is_finite());
    }
}
