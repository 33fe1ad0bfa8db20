//! What the distances of one pair cost, with slope and curvature by the difference of its nodes.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::Detail;
use crate::math::float::sqrt;
use crate::model::kinematics::distance_record::{DistanceRecord, pair_count};
use crate::model::kinematics::pair_polynomial::{PairPolynomial, chebyshev_nodes, pair_polynomials};

/// The curvature that a step uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curvature {
    /// `J^T J`, never negative.
    Gauss,
    /// All of it.
    Exact,
}

/// Half the sum of the squares of a pair, `delta` being the coefficients of powers of time of `x = x_a - x_b`.
#[derive(Clone, Debug)]
pub struct PairExpansion<const D: usize> {
    pub cost: f64,
    /// By each `delta_l`.
    pub gradient: Vec<SVector<f64, D>>,
    /// By `delta_l` and `delta_m`, at `l (L + 1) + m`.
    pub hessian: Vec<SMatrix<f64, D, D>>,
}

/// The distances of all pairs, in the order of [`pairs`](crate::model::kinematics::distance_record::pairs).
#[derive(Clone, Debug)]
pub struct PairCosts {
    degree: usize,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Compressed {
        instants: Vec<f64>,
        polynomials: Vec<PairPolynomial>,
    },
    Every {
        /// Scaled times and distances of each pair.
        measured: Vec<Vec<(f64, f64)>>,
        /// `1/sigma^2`.
        weight: f64,
    },
}

impl PairCosts {
    /// The distances of a record and a motion of some degree.
    pub fn new(record: &DistanceRecord, degree: usize, detail: Detail) -> Self {
        let kind = match detail {
            Detail::Compressed => Kind::Compressed {
                instants: chebyshev_nodes(2 * degree + 1),
                polynomials: pair_polynomials(record, degree),
            },
            Detail::Every => {
                let sigma = if record.sigma() > 0.0 { record.sigma() } else { 1.0 };
                Kind::Every { measured: measured(record), weight: 1.0 / (sigma * sigma) }
            }
        };
        Self { degree, kind }
    }

    /// L.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The cost of a pair alone.
    pub fn cost<const D: usize>(&self, pair: usize, delta: &[SVector<f64, D>]) -> f64 {
        match &self.kind {
            Kind::Compressed { instants, polynomials } => {
                let squares = instants.iter().map(|&s| at(delta, s).norm_squared());
                let PairPolynomial { factor, target } = &polynomials[pair];
                let model = DVector::from_iterator(instants.len(), squares);
                0.5 * (factor * model - target).norm_squared()
            }
            Kind::Every { measured, weight } => {
                let square = |&(s, distance): &(f64, f64)| {
                    let residual = sqrt(at(delta, s).norm_squared()) - distance;
                    residual * residual
                };
                0.5 * weight * measured[pair].iter().map(square).sum::<f64>()
            }
        }
    }

    /// Cost, slope and curvature of a pair.
    pub fn expansion<const D: usize>(
        &self,
        pair: usize,
        delta: &[SVector<f64, D>],
        curvature: Curvature,
    ) -> PairExpansion<D> {
        match &self.kind {
            Kind::Compressed { instants, polynomials } => {
                compressed(&polynomials[pair], instants, delta, curvature)
            }
            Kind::Every { measured, weight } => every(&measured[pair], *weight, delta, curvature),
        }
    }
}

fn measured(record: &DistanceRecord) -> Vec<Vec<(f64, f64)>> {
    let scale = record.time_scale();
    let of_pair = |pair: usize| {
        let at = |(k, &time): (usize, &f64)| Some((scale.scaled(time), record.distances(k)[pair]?));
        record.stamps().iter().enumerate().filter_map(at).collect()
    };
    (0..pair_count(record.nodes())).map(of_pair).collect()
}

/// `x(s) = sum_l delta_l s^l`.
fn at<const D: usize>(delta: &[SVector<f64, D>], s: f64) -> SVector<f64, D> {
    delta.iter().rev().fold(SVector::zeros(), |sum, coefficient| sum * s + coefficient)
}

/// Sums of matrices times powers of time: blocks of the curvature hold the power `l + m`.
struct Moments<const D: usize>(Vec<SMatrix<f64, D, D>>);

impl<const D: usize> Moments<D> {
    fn new(degree: usize) -> Self {
        Self((0..=2 * degree).map(|_| SMatrix::zeros()).collect())
    }

    fn add(&mut self, s: f64, mut matrix: SMatrix<f64, D, D>) {
        for moment in &mut self.0 {
            *moment += matrix;
            matrix *= s;
        }
    }

    fn blocks(&self) -> Vec<SMatrix<f64, D, D>> {
        let count = self.0.len() / 2 + 1;
        (0..count * count).map(|index| self.0[index / count + index % count]).collect()
    }
}

fn every<const D: usize>(
    measured: &[(f64, f64)],
    weight: f64,
    delta: &[SVector<f64, D>],
    curvature: Curvature,
) -> PairExpansion<D> {
    let (mut cost, mut moments) = (0.0, Moments::new(delta.len() - 1));
    let mut gradient: Vec<SVector<f64, D>> = delta.iter().map(|_| SVector::zeros()).collect();
    for &(s, distance) in measured {
        let x = at(delta, s);
        let modelled = sqrt(x.norm_squared());
        let residual = modelled - distance;
        cost += 0.5 * weight * residual * residual;
        if !(modelled > 0.0) {
            // Nodes that meet have no direction; the instant says nothing about how to part them.
            continue;
        }
        let direction = x / modelled;
        let mut slope = direction * (weight * residual);
        for entry in &mut gradient {
            *entry += slope;
            slope *= s;
        }
        let along = direction * direction.transpose();
        let bend = if curvature == Curvature::Exact { residual / modelled } else { 0.0 };
        moments.add(s, (along * (1.0 - bend) + SMatrix::identity() * bend) * weight);
    }
    PairExpansion { cost, gradient, hessian: moments.blocks() }
}

fn compressed<const D: usize>(
    polynomial: &PairPolynomial,
    instants: &[f64],
    delta: &[SVector<f64, D>],
    curvature: Curvature,
) -> PairExpansion<D> {
    let PairPolynomial { factor, target } = polynomial;
    let points: Vec<SVector<f64, D>> = instants.iter().map(|&s| at(delta, s)).collect();
    let model = DVector::from_iterator(points.len(), points.iter().map(SVector::norm_squared));
    let residual = factor * model - target;
    let slopes = factor.tr_mul(&residual);
    let count = delta.len();
    // d ||x||^2/d delta_l = 2 s^l x.
    let mut design = DMatrix::zeros(points.len(), count * D);
    for (row, (point, &s)) in points.iter().zip(instants).enumerate() {
        let mut slope = point * 2.0;
        for l in 0..count {
            design.view_mut((row, l * D), (1, D)).copy_from(&slope.transpose());
            slope *= s;
        }
    }
    let jacobian = factor * &design;
    let (by_delta, gauss) = (design.tr_mul(&slopes), jacobian.tr_mul(&jacobian));
    let gradient = (0..count).map(|l| by_delta.fixed_rows::<D>(l * D).into_owned()).collect();
    let block = |index: usize| gauss.fixed_view::<D, D>(index / count * D, index % count * D).into_owned();
    let mut hessian: Vec<SMatrix<f64, D, D>> = (0..count * count).map(block).collect();
    if curvature == Curvature::Exact {
        let mut moments = Moments::<D>::new(count - 1);
        for (&s, &slope) in instants.iter().zip(slopes.iter()) {
            moments.add(s, SMatrix::identity() * (2.0 * slope));
        }
        hessian.iter_mut().zip(moments.blocks()).for_each(|(sum, bend)| *sum += bend);
    }
    PairExpansion { cost: 0.5 * residual.norm_squared(), gradient, hessian }
}
