//! Topology: where the sensors sit on the body.

use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};

use super::anchors::require_points;
use super::spread::Spread;
use crate::error::Result;
use crate::math::block::MAX_BLOCKS;
use crate::math::float::sqrt;
use crate::math::linalg::add_outer;
use crate::math::singular::singular;

/// Positions `c_n` of the sensors in the body frame (\[T\] Sec. II-B), m, and what follows from them alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Topology<const D: usize> {
    sensors: Vec<SVector<f64, D>>,
    gram: SMatrix<f64, D, D>,
    sum: SVector<f64, D>,
    axes: SMatrix<f64, D, D>,
    moments: [f64; MAX_BLOCKS],
    centred: bool,
}

impl<const D: usize> Topology<D> {
    /// Takes at least one sensor with finite coordinates.
    ///
    /// # Errors
    /// [`crate::Error::Size`] without sensors, [`crate::Error::Number`] for a coordinate that is not finite.
    ///
    /// ```
    /// use nalgebra::Vector2;
    /// use rangelab::model::topology::Topology;
    /// let rod = Topology::new(vec![Vector2::new(-0.5, 0.0), Vector2::new(0.5, 0.0)])?;
    /// assert!(rod.is_centred());
    /// assert_eq!(rod.extended_rank(), 2); // a plane body needs 3 to show every entry of Q
    /// # Ok::<(), rangelab::Error>(())
    /// ```
    pub fn new(sensors: Vec<SVector<f64, D>>) -> Result<Self> {
        require_points("sensors", &sensors)?;
        let mut gram = SMatrix::zeros();
        let mut sum = SVector::zeros();
        for c in &sensors {
            add_outer(&mut gram, 1.0, c, c);
            sum += c;
        }
        let principal = singular(&gram);
        let mut moments = [0.0; MAX_BLOCKS];
        moments[..D].copy_from_slice(&principal.values);
        moments[D] = sensors.len() as f64;
        let size = sensors.iter().map(SVector::norm).fold(0.0, f64::max);
        let centred = sum.norm() <= 1e-12 * size * sensors.len() as f64;
        Ok(Self { sensors, gram, sum, axes: principal.right, moments, centred })
    }

    /// The sensor positions in the body frame, m.
    pub fn sensors(&self) -> &[SVector<f64, D>] {
        &self.sensors
    }

    /// Number of sensors `N`.
    pub fn len(&self) -> usize {
        self.sensors.len()
    }

    /// Never: there is at least one sensor.
    pub fn is_empty(&self) -> bool {
        self.sensors.is_empty()
    }

    /// `C C^T`, m^2.
    pub fn gram(&self) -> &SMatrix<f64, D, D> {
        &self.gram
    }

    /// Entry `(i, j)` of `C_e C_e^T`, `C_e = [C; 1^T]`: what the information of the anchors is multiplied with.
    pub fn extended_gram(&self, i: usize, j: usize) -> f64 {
        match (i < D, j < D) {
            (true, true) => self.gram[(i, j)],
            (true, false) => self.sum[i],
            (false, true) => self.sum[j],
            (false, false) => self.sensors.len() as f64,
        }
    }

    /// True if the body frame has its origin at the centroid of the sensors (`C 1 = 0`): then the information about
    /// `Q` and about `t` do not mix.
    pub fn is_centred(&self) -> bool {
        self.centred
    }

    /// Principal axes `V` of `C C^T = V diag(moments) V^T`, one a column.
    pub fn axes(&self) -> &SMatrix<f64, D, D> {
        &self.axes
    }

    /// The D second moments of the sensors along the [`Topology::axes`] (m^2), then the number of sensors: what the
    /// information of the anchors is multiplied with for each column of `[Q V | t]`.
    pub fn moments(&self) -> &[f64; MAX_BLOCKS] {
        &self.moments
    }

    /// Rank of `[C; 1^T]`; `D + 1` lets the ranges see every entry of `[Q | t]`.
    pub fn extended_rank(&self) -> usize {
        self.spread().rank() + 1
    }

    /// Root mean square distance of the sensors from the origin of the body frame, m; 1 where it vanishes. Angles times
    /// it compare with shifts.
    pub fn size(&self) -> f64 {
        let size = sqrt(self.gram.trace() / self.len() as f64);
        if size > 0.0 { size } else { 1.0 }
    }

    /// How the sensors fill the body frame.
    pub fn spread(&self) -> Spread<D> {
        Spread::of(&self.sensors)
    }
}
