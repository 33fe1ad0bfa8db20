//! The Fisher information of one epoch's ranges about `theta = vec([Q | t])`.

use crate::error::Result;
use crate::math::block::BlockMatrix;
use crate::math::pose::{Pose, Theta};
use crate::math::tangent::TangentMatrix;
use crate::model::accumulate::RangeBuffer;
use crate::model::ranges::Ranges;
use crate::model::ranging::{RangeForm, RangeModel};

/// The information about `theta`, and where it comes from, so that a bound that does not exist can say why.
#[derive(Clone, Copy, Debug)]
pub struct FisherInformation<'a, const D: usize> {
    /// Anchors, topology and noise.
    pub model: &'a RangeModel<D>,
    /// The true pose.
    pub pose: Pose<D>,
    /// What is done with the unknown `||s_n||^2`.
    pub form: RangeForm,
    /// `F`: block `(i, j)` belongs to columns `i` and `j` of `[Q | t]`.
    pub matrix: BlockMatrix<D>,
    /// Number of ranges in it.
    pub ranges: usize,
}

impl<const D: usize> FisherInformation<'_, D> {
    /// `T^T F T`, the information about the tangent coordinates `(phi, shift)` at the true pose.
    pub fn on_tangent_space(&self) -> TangentMatrix<D> {
        TangentMatrix::restrict(&self.matrix, &self.pose.rotation)
    }
}

/// The Fisher information of all M x N squared ranges at the true pose, `F = H^T Sigma^-1 H` (\[L\] eq. 41 with
/// `J_t = 1_N (x) Abar`: for the common weights of the papers `F = (C_e C_e^T) (x) Abar^T Abar`).
///
/// The noise has the variance of the **true** ranges; which range gives a pair its variance is the model's
/// [`crate::model::ranging::Weighting`], and only [`PerPair`](crate::model::ranging::Weighting::PerPair) is the noise as
/// [`crate::model::noise::RangeNoise`] defines it. The raw form is the information of the squared ranges as they are,
/// linearized at the pose. That the variance itself depends on the pose is left out, as in the papers: it would add
/// `2/zeta` of the information along the range for time of arrival, `sigma^2/(2 r^2)` for squared ranges, and nothing
/// for ranges of constant sigma.
///
/// ```
/// use nalgebra::Vector2;
/// use rangelab::bounds::{fisher_information, unitary_crb};
/// use rangelab::math::pose::Pose;
/// use rangelab::model::{anchors::Anchors, noise::RangeNoise, topology::Topology};
/// use rangelab::model::ranging::{RangeForm, RangeModel, Weighting};
///
/// let anchors = Anchors::new(vec![Vector2::new(0.0, 0.0), Vector2::new(8.0, 0.0), Vector2::new(0.0, 6.0)])?;
/// let topology = Topology::new(vec![Vector2::new(-0.5, 0.0), Vector2::new(0.5, 0.0)])?;
/// let model = RangeModel::new(anchors, topology, RangeNoise::Range { sigma: 0.02 }, Weighting::PerPair)?;
/// let pose = Pose { position: Vector2::new(3.0, 2.0), ..Pose::identity() };
/// let information = fisher_information(&model, &pose, RangeForm::Raw, &mut model.range_buffer())?;
/// let bound = unitary_crb(&information)?;
/// assert!(bound.shift_block().trace().sqrt() < 0.02); // six ranges of 2 cm show the position to better than 2 cm
/// # Ok::<(), rangelab::Error>(())
/// ```
///
/// # Errors
/// [`crate::Error::Number`] where the sums overflow.
pub fn fisher_information<'a, const D: usize>(
    model: &'a RangeModel<D>,
    pose: &Pose<D>,
    form: RangeForm,
    buffer: &mut RangeBuffer<D>,
) -> Result<FisherInformation<'a, D>> {
    let exact = model.exact_ranges(&Theta::from(*pose))?;
    information_of(model, pose, &exact, &exact, form, buffer)
}

/// [`fisher_information`] of the ranges that were measured; the values of `measured` are not looked at, only which of
/// them exist.
///
/// # Errors
/// [`crate::Error::Size`] where `measured` does not match anchors and sensors, [`crate::Error::Number`] where the sums
/// overflow.
pub fn fisher_information_of<'a, const D: usize>(
    model: &'a RangeModel<D>,
    pose: &Pose<D>,
    measured: &Ranges,
    form: RangeForm,
    buffer: &mut RangeBuffer<D>,
) -> Result<FisherInformation<'a, D>> {
    let exact = model.exact_ranges(&Theta::from(*pose))?;
    information_of(model, pose, measured, &exact, form, buffer)
}

pub(super) fn information_of<'a, const D: usize>(
    model: &'a RangeModel<D>,
    pose: &Pose<D>,
    measured: &Ranges,
    exact: &Ranges,
    form: RangeForm,
    buffer: &mut RangeBuffer<D>,
) -> Result<FisherInformation<'a, D>> {
    // The matrix depends on which ranges exist, on the weights and (raw form) on the pose; not on the measured values.
    let equations = model.normal_equations(measured, exact, &Theta::from(*pose), form, buffer)?;
    let matrix = equations.information.to_blocks();
    Ok(FisherInformation { model, pose: *pose, form, matrix, ranges: equations.ranges })
}
