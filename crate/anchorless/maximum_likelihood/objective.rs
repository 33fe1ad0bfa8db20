//! The cost of a motion: all pairs and the accelerations.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector, SVector};

use super::acceleration_cost::AccelerationCost;
use super::pair_cost::{Curvature, PairCosts};
use super::retraction::retracted;
use crate::model::kinematics::distance_record::pairs;
use crate::model::kinematics::gauge_directions::{add_translations, add_turns, turn_fields};

/// Half the sum of the squares of all residuals, each over its standard deviation.
pub struct Objective<'a, const D: usize> {
    pub nodes: usize,
    pub pairs: &'a PairCosts,
    pub accelerations: Option<&'a AccelerationCost>,
}

/// The objective near some unknowns.
pub struct Expansion {
    pub cost: f64,
    pub gradient: DVector<f64>,
    /// With information about what is not seen.
    pub hessian: DMatrix<f64>,
}

impl<const D: usize> Objective<'_, D> {
    /// Coefficients of the difference of two nodes.
    fn difference(&self, unknowns: &DVector<f64>, a: usize, b: usize, delta: &mut Vec<SVector<f64, D>>) {
        delta.clear();
        let of_node = |l: usize, node: usize| unknowns.fixed_rows::<D>((l * self.nodes + node) * D);
        delta.extend((0..=self.pairs.degree()).map(|l| of_node(l, a) - of_node(l, b)));
    }

    /// The cost alone.
    pub fn cost(&self, unknowns: &DVector<f64>) -> f64 {
        let mut delta = Vec::new();
        let mut sum = self.accelerations.map_or(0.0, |accelerations| accelerations.cost(unknowns));
        for (pair, (a, b)) in pairs(self.nodes).enumerate() {
            self.difference(unknowns, a, b, &mut delta);
            sum += self.pairs.cost(pair, &delta);
        }
        sum
    }

    /// Cost, slope and curvature; translations, and turns where nothing shows them, are given information.
    pub fn expansion(&self, unknowns: &DVector<f64>, curvature: Curvature) -> Expansion {
        let size = unknowns.len();
        let (mut gradient, mut hessian) = (DVector::zeros(size), DMatrix::zeros(size, size));
        let mut cost = 0.0;
        let mut delta = Vec::new();
        for (pair, (a, b)) in pairs(self.nodes).enumerate() {
            self.difference(unknowns, a, b, &mut delta);
            let part = self.pairs.expansion(pair, &delta, curvature);
            cost += part.cost;
            let first = |l: usize, node: usize| (l * self.nodes + node) * D;
            for l in 0..delta.len() {
                let mut add = |node, sign: f64| {
                    let mut rows = gradient.fixed_rows_mut::<D>(first(l, node));
                    rows += part.gradient[l] * sign;
                };
                add(a, 1.0);
                add(b, -1.0);
                for m in 0..delta.len() {
                    let block = part.hessian[l * delta.len() + m];
                    let mut add = |row, column, sign: f64| {
                        let mut view = hessian.fixed_view_mut::<D, D>(first(l, row), first(m, column));
                        view += block * sign;
                    };
                    add(a, a, 1.0);
                    add(b, b, 1.0);
                    add(a, b, -1.0);
                    add(b, a, -1.0);
                }
            }
        }
        match self.accelerations {
            Some(accelerations) => cost += accelerations.expand(unknowns, &mut gradient, &mut hessian),
            None => add_turns(&mut hessian, &turn_fields::<D>(unknowns.as_slice())),
        }
        add_translations(&mut hessian, D, self.nodes);
        Expansion { cost, gradient, hessian }
    }

    /// The unknowns after a step.
    pub fn moved(&self, unknowns: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        if self.accelerations.is_some() { retracted::<D>(unknowns, step) } else { unknowns + step }
    }
}
