//! Maximum likelihood on the ranges themselves, against its cost written out in plain loops.

use rangelab::math::pose::Theta;
use rangelab::math::rotation::{Rotation, rotation_angles};
use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName as Name, Loss};
use rangelab::model::ranges::Ranges;

use crate::scenes::{Scene, difference};
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};

crate::in_plane_and_space!(
    the_likelihood_is_greatest,
    one_step_from_the_simplified_estimate_is_nearly_there,
    one_wrong_range_does_not_move_the_robust_fit,
);

/// `sum rho((r - y)/sigma)`, sigma constant.
fn cost<const D: usize>(scene: &Scene<D>, theta: &Theta<D>, huber: Option<f64>) -> f64 {
    let (mut sum, sigma) = (0.0, 0.05);
    for (n, c) in scene.model.topology().sensors().iter().enumerate() {
        for (m, a) in scene.model.anchors().positions().iter().enumerate() {
            let Some(d) = scene.ranges.get(m, n) else { continue };
            let e = ((theta.orientation * c + theta.position - a).norm() - d.sqrt()) / sigma;
            sum += match huber {
                Some(k) if e.abs() > k => 2.0 * k * e.abs() - k * k,
                _ => e * e,
            };
        }
    }
    sum
}

fn moved<const D: usize>(theta: &Theta<D>, k: usize, by: f64) -> Theta<D> {
    let (mut phi, angles) = ([0.0; 3], rotation_angles(D));
    let mut result = *theta;
    if k < angles {
        phi[k] = by;
        result.orientation = theta.orientation * Rotation::<D>::exp(&phi).matrix();
    } else {
        result.position[k - angles] += by;
    }
    result
}

/// The steepest slope of the cost, by central differences.
fn slope<const D: usize>(scene: &Scene<D>, theta: &Theta<D>, huber: Option<f64>) -> f64 {
    let h = 1e-5;
    let one = |k: usize| {
        (cost(scene, &moved(theta, k, h), huber) - cost(scene, &moved(theta, k, -h), huber)).abs() / (2.0 * h)
    };
    (0..rotation_angles(D) + D).map(one).fold(0.0, f64::max)
}

fn the_likelihood_is_greatest<const D: usize>() {
    let mut sampler = Sampler::new(540);
    for index in 0..60 {
        let scene = Scene::<D>::random(&mut sampler, index, 0.05);
        for loss in [Loss::Squared, Loss::Huber { scale: 1.0 }] {
            let settings = LocalizeSettings { loss, ..LocalizeSettings::default() };
            let found = scene.estimate(Name::MaximumLikelihood, &settings, 0.0).theta.unwrap();
            let huber = if loss == Loss::Squared { None } else { Some(1.0) };
            // A slope of 0.01 is 1e-6 of the curvature (1e4) away from the top.
            at_most("slope", slope(&scene, &found, huber), 0.01);
            caught("the slope of the OUC-LS", slope(&scene, &scene.theta(Name::OucLs), huber), 0.01);
            let least = cost(&scene, &found, huber);
            for name in [Name::SucLs, Name::OucLs, Name::GaussNewton] {
                at_most(name.label(), least - cost(&scene, &scene.theta(name), huber), 1e-9);
            }
        }
    }
}

fn one_step_from_the_simplified_estimate_is_nearly_there<const D: usize>() {
    let mut sampler = Sampler::new(541);
    for index in 0..60 {
        let scene = Scene::<D>::random(&mut sampler, index, 1e-4);
        let best = scene.theta(Name::MaximumLikelihood);
        let before = difference(&scene.theta(Name::SucLs), &best);
        let after = difference(&scene.theta(Name::GaussNewton), &best);
        at_most("what is left after one step", after, 0.02 * before);
    }
}

fn one_wrong_range_does_not_move_the_robust_fit<const D: usize>() {
    let mut sampler = Sampler::new(542);
    let error = |scene: &Scene<D>, loss| {
        let settings = LocalizeSettings { loss, ..LocalizeSettings::default() };
        let found = scene.estimate(Name::MaximumLikelihood, &settings, 0.0).theta.unwrap();
        (found.position - scene.pose.position).norm()
    };
    let (mut plain, mut robust) = (0.0, 0.0);
    for index in (0..120).step_by(3) {
        let mut scene = Scene::<D>::random(&mut sampler, index + 3, 0.05);
        let all = scene.ranges.clone();
        // 2 m too long: a path around a corner.
        let wrong = |m: usize, n: usize| {
            all.get(m, n).map(|d| if (m, n) == (1, 1) { d + 4.0 * d.sqrt() + 4.0 } else { d })
        };
        scene.ranges = Ranges::from_fn(all.anchors(), all.sensors(), wrong).unwrap();
        plain += error(&scene, Loss::Squared);
        robust += error(&scene, Loss::Huber { scale: 1.345 });
    }
    println!("D = {D}: mean error {:.3} m plain, {:.3} m robust", plain / 40.0, robust / 40.0);
    at_most("error of the robust fit", robust, 0.5 * plain);
}
