//! Fisher information about all coefficients of the motion.

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::{DMatrix, SMatrix, SVector};

use super::WHAT;
use super::design::KinematicsDesign;
use crate::error::{Error, Result};
use crate::math::float::sqrt;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::distance_record::pairs;
use crate::model::kinematics::stamps::{LEAST_SPREAD, earliest_and_latest};
use crate::model::kinematics::time_scale::TimeScale;
use crate::with_dimension;

/// About the coefficients of powers of scaled time, stacked coefficient by coefficient, node by node.
///
/// With accelerometers the coefficients are those in the accelerometers' own frame: there the turn is seen, and the unknown
/// `Q` leaves with the alignment, which removes it.
pub fn information(motion: &RelativeKinematics, design: &KinematicsDesign) -> Result<DMatrix<f64>> {
    positive("the standard deviation of a distance", design.sigma_distance)?;
    let [first, last] = earliest_and_latest(&design.stamps);
    let value = last - first;
    if value > 0.0 && value < LEAST_SPREAD {
        let (what, limit) = ("the time between the first stamp and the last, s,", "0 or at least 1e-6");
        return Err(Error::Number { what, value, limit });
    }
    let mut information = with_dimension!(motion.dimension(), D => of_distances::<D>(motion, design))?;
    if let Some(sigma) = design.sigma_acceleration {
        positive("the standard deviation of an acceleration", sigma)?;
        if motion.degree() < 2 {
            let (what, limit) = ("the degree of the motion", "at least 2 where accelerations are read");
            return Err(Error::Number { what, value: motion.degree() as f64, limit });
        }
        add_accelerations(&mut information, motion, &design.stamps, sigma);
    }
    Ok(information)
}

fn positive(what: &'static str, value: f64) -> Result<()> {
    if value > 0.0 { Ok(()) } else { Err(Error::Number { what, value, limit: "positive" }) }
}

/// Along the line between two nodes, `u u^T/sigma^2` for each pair and stamp, times the powers `l + m` of time.
fn of_distances<const D: usize>(
    motion: &RelativeKinematics,
    design: &KinematicsDesign,
) -> Result<DMatrix<f64>> {
    let (nodes, terms) = (motion.nodes(), motion.degree() + 1);
    let block = D * nodes;
    let weight = design.present / (design.sigma_distance * design.sigma_distance);
    let scale = TimeScale::of(&design.stamps);
    let points: Vec<DMatrix<f64>> = design.stamps.iter().map(|&time| motion.positions(time)).collect();
    let mut information = DMatrix::zeros(terms * block, terms * block);
    let mut moments = vec![SMatrix::<f64, D, D>::zeros(); 2 * terms - 1];
    for (a, b) in pairs(nodes) {
        moments.fill(SMatrix::zeros());
        for (positions, &time) in points.iter().zip(&design.stamps) {
            let line = positions.fixed_view::<D, 1>(0, a) - positions.fixed_view::<D, 1>(0, b);
            let mut along = outer(&line)? * weight;
            for moment in &mut moments {
                *moment += along;
                along *= scale.scaled(time);
            }
        }
        for l in 0..terms {
            for m in 0..terms {
                let (l_first, m_first) = (l * block, m * block);
                for (row, column, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                    let at = (l_first + row * D, m_first + column * D);
                    let mut view = information.fixed_view_mut::<D, D>(at.0, at.1);
                    view += moments[l + m] * sign;
                }
            }
        }
    }
    Ok(information)
}

fn outer<const D: usize>(line: &SVector<f64, D>) -> Result<SMatrix<f64, D, D>> {
    let squared = line.norm_squared();
    if squared > 0.0 {
        return Ok(line * line.transpose() / squared);
    }
    let reason = "Two nodes meet at a stamp, and the distance between them has no slope there.";
    Err(Error::Degenerate { what: WHAT, value: sqrt(squared), reason })
}

/// `Xdd = sum_l l (l - 1) s^(l-2)/half^2 c_l` in every coordinate; centred, a common acceleration says nothing.
fn add_accelerations(
    information: &mut DMatrix<f64>,
    motion: &RelativeKinematics,
    stamps: &[f64],
    sigma: f64,
) {
    let block = motion.dimension() * motion.nodes();
    let scale = TimeScale::of(stamps);
    let factor = |l: usize| (l * (l - 1)) as f64 / (scale.half * scale.half * sigma);
    let power = |s: f64, exponent: usize| (0..exponent).fold(1.0, |product, _| product * s);
    for l in 2..=motion.degree() {
        for m in 2..=motion.degree() {
            let sum: f64 = stamps.iter().map(|&time| power(scale.scaled(time), l + m - 4)).sum();
            for coordinate in 0..block {
                information[(l * block + coordinate, m * block + coordinate)] += sum * factor(l) * factor(m);
            }
        }
    }
}
