//! The Cramér-Rao bound of relative kinematics, with the gauge fixed as errors are measured.
//!
//! Distances show neither translations nor a common turn, so information about the coefficients is singular there. An
//! estimate is compared with the truth after centring and one Procrustes alignment, to first order
//!
//! ```text
//! e_l  ->  e_l + Omega Y_l      Omega skew with the least ||e_0 + Omega Y_0||_F
//! ```
//!
//! and so is the bound: any generalized inverse of the information, mapped by this projection along the gauge.

mod alignment;
mod design;
mod gram;
mod information;
mod over_time;

pub use design::KinematicsDesign;

use alloc::vec::Vec;

use nalgebra::DMatrix;

use crate::error::{Error, Result};
use crate::math::definite::definite_factor;
use crate::math::float::sqrt;
use crate::model::kinematics::coefficients::RelativeKinematics;
use crate::model::kinematics::gauge_directions::{add_translations, add_turns, turn_fields};
use crate::model::kinematics::stacked::stacked_powers;
use crate::model::kinematics::time_scale::TimeScale;
use crate::with_dimension;
use alignment::ReadOut;
use over_time::OverTime;

/// What is being computed, for errors.
const WHAT: &str = "the Cramér-Rao bound of relative kinematics";

/// To what positions are aligned before they are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alignment {
    /// One element of O(D), from the positions at time 0.
    AtZero,
    /// At each instant another one, from the positions then.
    AtEach,
}

/// How well any unbiased estimator could find the motion of a network.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicsBound {
    motion: RelativeKinematics,
    scale: TimeScale,
    /// How errors of the centred coefficients of powers of scaled time, stacked, follow from independent normal numbers of
    /// variance 1: times its transpose it is a generalized inverse of the information about them.
    root: DMatrix<f64>,
}

impl KinematicsBound {
    /// From distances alone, or with accelerometers in one unknown proper frame, as the design says.
    ///
    /// # Errors
    /// [`Error::Number`] where a standard deviation is not positive, all stamps lie within 1e-6 s and are not one, or
    /// accelerations of a motion of degree below 2 are given; [`Error::Degenerate`] where two nodes meet at a stamp, or the motion is not determined to first order.
    ///
    /// ```
    /// use rangelab::bounds::kinematics::{KinematicsBound, KinematicsDesign};
    /// use rangelab::model::kinematics::presets::kinematics_preset;
    /// let scenario = kinematics_preset("kinematics-paper")?;
    /// let design = KinematicsDesign::distances(&scenario.setup()?.stamps, &scenario.noise);
    /// let bound = KinematicsBound::new(&scenario.setup()?.motion, &design)?;
    /// assert!((bound.coefficient_rmse(1)? - 0.0151).abs() < 1e-4); // m/s for each coordinate
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn new(motion: &RelativeKinematics, design: &KinematicsDesign) -> Result<Self> {
        let (motion, scale) = (motion.centred(), TimeScale::of(&design.stamps));
        let mut information = information::information(&motion, design)?;
        let stacked = stacked_powers(&scale.scale(&motion));
        if design.sigma_acceleration.is_none() {
            let fields = with_dimension!(motion.dimension(), D => Ok::<_, Error>(turn_fields::<D>(stacked.as_slice())))?;
            add_turns(&mut information, &fields);
        }
        add_translations(&mut information, motion.dimension(), motion.nodes());
        let factor = definite_factor(&information).map_err(undetermined)?;
        let mut root = DMatrix::identity(information.nrows(), information.nrows());
        let solved = factor.l_dirty().tr_solve_lower_triangular_mut(&mut root);
        debug_assert!(solved, "its pivots were checked");
        centre(&mut root, motion.dimension(), motion.nodes());
        Ok(Self { motion, scale, root })
    }

    /// The motion at which it is, centred.
    pub fn motion(&self) -> &RelativeKinematics {
        &self.motion
    }

    /// Covariance of `Y_l` after one alignment at time 0, (D N) x (D N), node by node.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where the positions at time 0 do not fix a frame, [`Error::Size`] for l above L.
    pub fn coefficient_covariance(&self, l: usize) -> Result<DMatrix<f64>> {
        Ok(covariance(&self.coefficient_noise(l)?))
    }

    /// Root mean square over the coordinates of `Y_l` after one alignment at time 0, m/s^l.
    ///
    /// # Errors
    /// As [`KinematicsBound::coefficient_covariance`].
    pub fn coefficient_rmse(&self, l: usize) -> Result<f64> {
        Ok(root_mean(&self.coefficient_noise(l)?))
    }

    /// Covariance of `Y_0 + factor Y_l`, the tips of arrows drawn from the nodes, after one alignment at time 0, (D N) x (D N),
    /// node by node; `factor` in s^l.
    ///
    /// # Errors
    /// As [`KinematicsBound::coefficient_covariance`].
    pub fn tip_covariance(&self, l: usize, factor: f64) -> Result<DMatrix<f64>> {
        let positions = ReadOut::new(self, 0, 0.0);
        let angles = positions.angles()?;
        Ok(covariance(&positions.plus(factor, &self.coefficient(l)?).turned(&angles)?))
    }

    /// Covariance of the positions at a time (s), (D N) x (D N), node by node.
    ///
    /// # Errors
    /// [`Error::Degenerate`] where the positions that are aligned do not fix a frame.
    pub fn position_covariance(&self, time: f64, alignment: Alignment) -> Result<DMatrix<f64>> {
        Ok(covariance(&self.position_noise(time, alignment)?))
    }

    /// Root mean square over the coordinates of the positions at a time (s), m.
    ///
    /// # Errors
    /// As [`KinematicsBound::position_covariance`].
    pub fn position_rmse(&self, time: f64, alignment: Alignment) -> Result<f64> {
        Ok(root_mean(&self.position_noise(time, alignment)?))
    }

    /// [`KinematicsBound::position_rmse`] at some times (s), with both alignments: after the one at time 0, and after one at
    /// each time.
    ///
    /// # Errors
    /// As [`KinematicsBound::position_covariance`].
    pub fn position_rmses(&self, times: &[f64]) -> Result<[Vec<f64>; 2]> {
        let over_time = OverTime::new(self)?;
        let mut rmses = [Vec::with_capacity(times.len()), Vec::with_capacity(times.len())];
        for &time in times {
            let (at_zero, at_each) = over_time.rmses(time)?;
            rmses[0].push(at_zero);
            rmses[1].push(at_each.map_or_else(|| self.position_rmse(time, Alignment::AtEach), Ok)?);
        }
        Ok(rmses)
    }

    /// Root mean square over the entries of `vech(B_l)`, `G(t) = sum_l B_l t^l`, m^2/s^l (\[A\] Fig. 1); Gram matrices need no
    /// alignment.
    ///
    /// # Errors
    /// [`Error::Size`] for l above 2L.
    pub fn gram_rmse(&self, l: usize) -> Result<f64> {
        up_to("coefficients of the Gram matrix up to the one asked for", 2 * self.motion.degree(), l)?;
        Ok(root_mean(&gram::gram_noise(self, l)))
    }

    fn coefficient(&self, l: usize) -> Result<ReadOut> {
        up_to("coefficients of the motion up to the one asked for", self.motion.degree(), l)?;
        Ok(ReadOut::new(self, l, 0.0))
    }

    fn coefficient_noise(&self, l: usize) -> Result<DMatrix<f64>> {
        self.coefficient(l)?.turned(&ReadOut::new(self, 0, 0.0).angles()?)
    }

    fn position_noise(&self, time: f64, alignment: Alignment) -> Result<DMatrix<f64>> {
        let reference = if alignment == Alignment::AtZero { 0.0 } else { time };
        ReadOut::new(self, 0, time).turned(&ReadOut::new(self, 0, reference).angles()?)
    }
}

/// Refuses a coefficient above the last one.
fn up_to(what: &'static str, last: usize, l: usize) -> Result<()> {
    if l > last {
        return Err(Error::Size { what, found: last + 1, expected: l + 1 });
    }
    Ok(())
}

fn covariance(noise: &DMatrix<f64>) -> DMatrix<f64> {
    noise * noise.transpose()
}

fn root_mean(noise: &DMatrix<f64>) -> f64 {
    sqrt(noise.norm_squared() / noise.nrows() as f64)
}

/// Takes the mean over the nodes away, of each coordinate of each coefficient.
fn centre(stacked: &mut DMatrix<f64>, dimension: usize, nodes: usize) {
    for mut column in stacked.column_iter_mut() {
        for coefficient in column.as_mut_slice().chunks_exact_mut(dimension * nodes) {
            for axis in 0..dimension {
                let mean = coefficient.iter().skip(axis).step_by(dimension).sum::<f64>() / nodes as f64;
                coefficient.iter_mut().skip(axis).step_by(dimension).for_each(|value| *value -= mean);
            }
        }
    }
}

fn undetermined(value: f64) -> Error {
    let reason = "Some motion of the nodes changes no distance to first order: there are too few nodes or stamps, all nodes \
                  lie on a line, or they hardly move.";
    Error::Degenerate { what: WHAT, value, reason }
}
