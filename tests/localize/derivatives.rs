//! Slopes and curvatures against finite differences, each with a spoiled twin.

use nalgebra::SMatrix;
use rangelab::math::float::sin;
use rangelab::math::newton::{Expansion, along_turn};
use rangelab::math::quadratic::{Kronecker, distance};
use rangelab::math::rotation::{Rotation, rotation_angles};

use crate::support::sampling::Sampler;
use crate::support::{at_most, caught};

crate::in_plane_and_space!(expansions_are_those_of_the_cost, costs_along_a_turn_are_trigonometric,);

fn problem<const D: usize>(sampler: &mut Sampler) -> (Kronecker<D>, SMatrix<f64, D, D>, Rotation<D>) {
    let eigenvalues: Vec<f64> = (0..D).map(|_| sampler.uniform(0.2, 3.0)).collect();
    let metric = Kronecker { anchors: sampler.spd(&eigenvalues), sensors: sampler.spd(&eigenvalues[..D]) };
    (metric, sampler.matrix(1.0), sampler.rotation())
}

fn moved<const D: usize>(rotation: &Rotation<D>, i: usize, j: usize, a: f64, b: f64) -> Rotation<D> {
    let mut phi = [0.0; 3];
    phi[i] += a;
    phi[j] += b;
    rotation.compose(&Rotation::exp(&phi))
}

fn expansions_are_those_of_the_cost<const D: usize>() {
    let mut sampler = Sampler::new(520);
    let h = 1e-4;
    for _ in 0..50 {
        let (metric, q, rotation) = problem::<D>(&mut sampler);
        let cost = |r: Rotation<D>| distance(&r, &q, &metric);
        let found = Expansion::at(&rotation, &q, &metric);
        let mut planted = found.hessian;
        if D == 3 {
            // The paper's printed eq. 64 has these two exchanged.
            (planted[(1, 1)], planted[(1, 2)]) = (found.hessian[(1, 2)], found.hessian[(1, 1)]);
        } else {
            planted[(0, 0)] = found.gauss[(0, 0)];
        }
        let mut worst_planted: f64 = 0.0;
        for i in 0..rotation_angles(D) {
            let slope =
                (cost(moved(&rotation, i, i, h, 0.0)) - cost(moved(&rotation, i, i, -h, 0.0))) / (2.0 * h);
            at_most("slope", (0.5 * slope - found.gradient[i]).abs(), 1e-6);
            for j in 0..rotation_angles(D) {
                let corner = |a: f64, b: f64| cost(moved(&rotation, i, j, a, b));
                let second = (corner(h, h) - corner(h, -h) - corner(-h, h) + corner(-h, -h)) / (4.0 * h * h);
                at_most("curvature", (0.5 * second - found.hessian[(i, j)]).abs(), 1e-5);
                worst_planted = worst_planted.max((0.5 * second - planted[(i, j)]).abs());
            }
        }
        caught("a spoiled curvature", worst_planted, 1e-5);
    }
}

fn costs_along_a_turn_are_trigonometric<const D: usize>() {
    let mut sampler = Sampler::new(521);
    for _ in 0..50 {
        let (metric, q, rotation) = problem::<D>(&mut sampler);
        let axis = sampler.axis::<D>();
        let along = along_turn(&rotation, &axis, &q, &metric);
        let cost = |x: f64| distance(&rotation.compose(&Rotation::exp(&axis.map(|a| x * a))), &q, &metric);
        let grid = || (0..2000).map(|k| f64::from(k) * std::f64::consts::TAU / 2000.0);
        for x in grid().step_by(100) {
            at_most("cost along a turn", (along.at(x) - cost(x)).abs(), 1e-12 * (1.0 + cost(x)));
            let mut spoiled = along;
            spoiled.sin2 = -spoiled.sin2;
            if sin(2.0 * x).abs() > 0.1 && along.sin2.abs() > 1e-3 {
                caught("a spoiled harmonic", (spoiled.at(x) - cost(x)).abs(), 1e-12 * (1.0 + cost(x)));
            }
        }
        let least = along.at(along.least());
        at_most("the least of all", least - grid().map(cost).fold(f64::INFINITY, f64::min), 1e-12);
        for limit in [0.01, 0.3, 1.0, std::f64::consts::FRAC_PI_2] {
            let found = along.least_up_to(limit);
            assert!((0.0..=limit).contains(&found));
            let best =
                grid().map(|x| x / std::f64::consts::TAU * limit).map(cost).fold(f64::INFINITY, f64::min);
            at_most("the least up to a limit", along.at(found) - best, 1e-12);
        }
    }
}
