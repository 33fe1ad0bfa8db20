//! The bound on positions at many times, for which what is large is summed once.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::KinematicsBound;
use super::alignment::{ReadOut, turned_squares};
use crate::error::{Error, Result};
use crate::math::float::sqrt;
use crate::model::kinematics::gauge_directions::turn_fields;
use crate::model::kinematics::stacked::stacked_powers;
use crate::model::kinematics::time_scale::TimeScale;
use crate::with_dimension;

/// Below this part of the squared error after one alignment, that after another is not told from rounding.
const CANCELLED: f64 = 1e-6;

/// Squared errors of positions as quadratic forms in the powers `w` of scaled time.
///
/// Positions are `sum_l w_l c_l`, and their error after one alignment at time 0 is `sum_l w_l A_l` with `A_l` that of `c_l`:
/// its square is `w^T (<A_l, A_m>) w`, a form of L + 1 unknowns. An alignment at the time itself takes the turns `T` away,
///
/// ```text
/// ||A||^2 - tr((T^T A)^T (T^T T)^-1 T^T A)      T = sum_m w_m T_m, the turned c_m
/// ```
///
/// and of `T_m^T A_l` there are (L + 1)^2, each with D(D - 1)/2 rows.
pub struct OverTime<'a> {
    scale: &'a TimeScale,
    /// Of the matrix with the `A_l` as columns.
    triangle: DMatrix<f64>,
    /// `T_0, T_1, ...` side by side.
    turns: DMatrix<f64>,
    /// Of each l, all `T_m^T A_l` below each other.
    along: Vec<DMatrix<f64>>,
}

impl<'a> OverTime<'a> {
    /// What is the same at all times.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where the positions at time 0 do not fix a frame.
    pub fn new(bound: &'a KinematicsBound) -> Result<Self> {
        let KinematicsBound { motion, scale, root } = bound;
        let (block, terms) = (motion.coefficient(0).len(), motion.degree() + 1);
        let angles = ReadOut::new(bound, 0, 0.0).angles()?;
        let powers = stacked_powers(&scale.scale(motion));
        let turns_of = |l: usize| {
            let power = &powers.as_slice()[l * block..(l + 1) * block];
            with_dimension!(motion.dimension(), D => Ok::<_, Error>(turn_fields::<D>(power)))
        };
        let turns: Vec<Vec<DVector<f64>>> = (0..terms).map(turns_of).collect::<Result<_>>()?;
        let noise = |l: usize| {
            let mut noise = root.rows(l * block, block).into_owned();
            noise.gemm(-1.0, &DMatrix::from_columns(&turns[l]), &angles, 1.0);
            noise
        };
        let noises: Vec<DMatrix<f64>> = (0..terms).map(noise).collect();
        let turns = DMatrix::from_columns(&turns.concat());
        let along = noises.iter().map(|noise| turns.tr_mul(noise)).collect();
        let columns: Vec<DVector<f64>> =
            noises.into_iter().map(|noise| DVector::from_vec(noise.data.into())).collect();
        Ok(Self { scale, triangle: DMatrix::from_columns(&columns).qr().unpack_r(), turns, along })
    }

    /// Root mean squares over the coordinates at a time (s), m: after the alignment at time 0, and after one then, which is
    /// `None` where it is lost in the difference.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where the positions then do not fix a frame.
    pub fn rmses(&self, time: f64) -> Result<(f64, Option<f64>)> {
        let s = self.scale.scaled(time);
        let terms = self.along.len();
        let mut weights = DVector::from_element(terms, 1.0);
        (1..terms).for_each(|l| weights[l] = weights[l - 1] * s);
        let (planes, coordinates) = (self.turns.ncols() / terms, self.turns.nrows() as f64);
        let whole = (&self.triangle * &weights).norm_squared();
        let mut turned = DMatrix::zeros(self.turns.nrows(), planes);
        let mut along = DMatrix::zeros(planes, self.along[0].ncols());
        for m in 0..terms {
            turned += self.turns.columns(m * planes, planes) * weights[m];
            for (l, of_power) in self.along.iter().enumerate() {
                let weight = weights[m] * weights[l];
                along.zip_apply(&of_power.rows(m * planes, planes), |sum, part| *sum += weight * part);
            }
        }
        let left = whole - turned_squares(&turned)?.solve(&along).dot(&along);
        let root_mean = |squared: f64| sqrt(squared / coordinates);
        Ok((root_mean(whole), (left > CANCELLED * whole).then(|| root_mean(left))))
    }
}
