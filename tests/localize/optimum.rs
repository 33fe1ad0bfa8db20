//! The optimum of the constrained problem against a blind search that knows nothing but the cost.

use rangelab::localize::reduced::Reduced;
use rangelab::localize::{Optimum, localize};
use rangelab::math::quadratic::distance;
use rangelab::math::rotation::{Manifold, Rotation};
use rangelab::math::secular::sphere_minimum;
use rangelab::model::localize_settings::{LocalizeSettings, LocalizerName as Name};

use crate::scenes::Scene;
use crate::support::at_most;
use crate::support::sampling::Sampler;

fn cost(rotation: &Rotation<3>, reduced: &Reduced<3>) -> f64 {
    distance(rotation, &reduced.target, &reduced.metric)
}

/// Turns about each axis by ever smaller angles as long as that helps.
fn walk(start: Rotation<3>, reduced: &Reduced<3>) -> Rotation<3> {
    let (mut best, mut angle) = (start, 0.5);
    while angle > 1e-7 {
        let steps = (0..6).map(|k| {
            let mut phi = [0.0; 3];
            phi[k / 2] = if k % 2 == 0 { angle } else { -angle };
            best.compose(&Rotation::exp(&phi)).renormalized()
        });
        let next = steps.min_by(|a, b| cost(a, reduced).total_cmp(&cost(b, reduced))).unwrap();
        if cost(&next, reduced) < cost(&best, reduced) { best = next } else { angle *= 0.5 }
    }
    best
}

/// The least cost that the search finds over SO(3), or over both components.
fn blind_search(sampler: &mut Sampler, reduced: &Reduced<3>, manifold: Manifold) -> f64 {
    let mirror = Rotation::from_matrix_unchecked(nalgebra::Matrix3::from_diagonal(&[1.0, 1.0, -1.0].into()));
    let mut least = f64::INFINITY;
    for _ in 0..12 {
        let start = sampler.rotation::<3>();
        least = least.min(cost(&walk(start, reduced), reduced));
        if manifold == Manifold::O {
            least = least.min(cost(&walk(start.compose(&mirror), reduced), reduced));
        }
    }
    least
}

#[test]
fn no_search_finds_less() {
    let mut sampler = Sampler::new(530);
    let mut seen = [0; 4];
    for index in 0..90 {
        let scene = Scene::<3>::random(&mut sampler, index, [0.01, 0.5, 3.0][index / 30]);
        let snapshot = scene.snapshot();
        let reduced = snapshot.reduced("test", 0.0).unwrap();
        for manifold in [Manifold::So, Manifold::O] {
            let searched = LocalizeSettings { manifold, multi_start: true, ..LocalizeSettings::default() };
            let found = localize(Name::OucLs, &snapshot, &searched, 0.0).unwrap();
            let least = blind_search(&mut sampler, &reduced, manifold);
            let of = |theta: rangelab::math::pose::Theta<3>| {
                cost(&Rotation::from_matrix_unchecked(theta.orientation), &reduced)
            };
            at_most("cost over the search", of(found.theta.unwrap()) - least, 1e-9 * (1.0 + least));
            let plain = LocalizeSettings { multi_start: false, ..searched };
            let first = localize(Name::OucLs, &snapshot, &plain, 0.0).unwrap();
            seen[first.optimum as usize] += 1;
            if first.optimum == Optimum::Certified {
                // What is certified over O(3) is so over SO(3) too.
                let least = blind_search(&mut sampler, &reduced, Manifold::O);
                at_most("certified", of(first.theta.unwrap()) - least, 1e-9 * (1.0 + least));
            }
        }
    }
    // The scenes hold both kinds: those that a certificate settles and those where it must stay silent.
    assert!(seen[Optimum::Certified as usize] > 40 && seen[Optimum::Local as usize] > 20, "{seen:?}");
}

/// A local minimum that is not the global one is never certified: the certificate is asked at what the search improves on.
#[test]
fn worse_optima_are_not_certified() {
    let mut sampler = Sampler::new(531);
    let mut improved = 0;
    for index in 0..400 {
        let scene = Scene::<3>::random(&mut sampler, 3 * index, 4.0);
        let snapshot = scene.snapshot();
        let reduced = snapshot.reduced("test", 0.0).unwrap();
        let run = |multi_start| {
            let settings =
                LocalizeSettings { multi_start, manifold: Manifold::O, ..LocalizeSettings::default() };
            localize(Name::OucLs, &snapshot, &settings, 0.0).unwrap()
        };
        let of = |theta: rangelab::math::pose::Theta<3>| {
            cost(&Rotation::from_matrix_unchecked(theta.orientation), &reduced)
        };
        let (first, best) = (run(false), run(true));
        let (before, after) = (of(first.theta.unwrap()), of(best.theta.unwrap()));
        at_most("the search never loses", after - before, 1e-9 * (1.0 + before));
        if after < before - 1e-6 * before {
            improved += 1;
            assert_eq!(first.optimum, Optimum::Local);
        }
    }
    println!("the search improved on {improved} of 400 starts");
    assert!(improved > 0, "no start led to a local minimum: the test sees nothing");
}

/// The paper's start (eq. 55) against a blind walk on the sphere, hard case included.
#[test]
fn the_sphere_minimum_is_least() {
    let mut sampler = Sampler::new(532);
    for index in 0..200 {
        let mut values: [f64; 4] = std::array::from_fn(|_| sampler.uniform(0.0, 3.0));
        let mut beta: [f64; 4] = std::array::from_fn(|_| sampler.normal());
        if index % 4 == 1 {
            values[2] = 0.0;
            beta[2] = 0.0;
            beta = beta.map(|b| 0.01 * b);
        }
        if index % 4 == 2 {
            beta = [0.0; 4];
        }
        let radius = sampler.uniform(0.5, 2.0);
        let y = sphere_minimum(&values, &beta, radius);
        let length = |y: &[f64; 4]| y.iter().map(|y| y * y).sum::<f64>().sqrt();
        at_most("radius", (length(&y) - radius).abs(), 1e-9);
        let cost = |y: &[f64; 4]| (0..4).map(|i| values[i] * y[i] * y[i] - 2.0 * beta[i] * y[i]).sum::<f64>();
        for _ in 0..300 {
            let near: [f64; 4] =
                std::array::from_fn(|i| y[i] + [1.0, 0.1, 0.001][index % 3] * sampler.normal());
            let scale = radius / length(&near);
            at_most("cost", cost(&y) - cost(&near.map(|x| x * scale)), 1e-9);
        }
    }
}
