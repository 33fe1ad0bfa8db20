//! What mounting errors do to the bounds.

use alloc::vec::Vec;

use nalgebra::{SMatrix, SVector};

use super::fisher::{FisherInformation, fisher_information_of};
use crate::error::Result;
use crate::math::block::BlockMatrix;
use crate::math::linalg::spd_inverse;
use crate::math::pose::{Pose, Theta};
use crate::model::ranges::Ranges;
use crate::model::ranging::{RangeForm, RangeModel};
use crate::model::sensor_equations::SensorEquations;

/// The Fisher information about `[Q | t]` where each sensor sits off its place on the body by `e_n ~ N(0, sigma_e^2 I)`.
///
/// The ranges of a sensor see `s_n = Q (c_n + e_n) + t`, and `Q e_n` has the covariance `sigma_e^2 I` whatever `Q` is. To the
/// information `R_n` about the place of the sensor that adds a variance:
///
/// ```text
/// F = sum_n (c_n c_n^T) (x) (R_n^-1 + sigma_e^2 I)^-1,   (R^-1 + sigma_e^2 I)^-1 = R (sigma_e^2 R + I)^-1
/// ```
///
/// with `c_n` extended by 1; exact for the projected form, which is linear in `s_n`, and to first order for the raw one. It is
/// the weighting of the OUC-TLS (\[L\] eq. 34, corrected). As the ranges become exact the bound does not vanish: it tends to
/// that of `N` exactly known points off by `sigma_e`, `sigma_e sqrt(D/N)` for the centroid. With `sigma_e = 0` it is
/// [`fisher_information_of`].
///
/// # Errors
/// [`crate::Error::Size`] where `measured` does not match anchors and sensors, [`crate::Error::Number`] where the sums
/// overflow.
pub fn perturbed_information<'a, const D: usize>(
    model: &'a RangeModel<D>,
    pose: &Pose<D>,
    measured: &Ranges,
    form: RangeForm,
    mounting_sigma: f64,
) -> Result<FisherInformation<'a, D>> {
    let mut information = fisher_information_of(model, pose, measured, form, &mut model.range_buffer())?;
    if mounting_sigma == 0.0 {
        return Ok(information);
    }
    let mut matrix = BlockMatrix::zeros();
    for (equations, c) in equations_at(model, pose, measured, form)?.iter().zip(model.topology().sensors()) {
        let extended = |i: usize| if i < D { c[i] } else { 1.0 };
        matrix.add_kronecker(|i, j| extended(i) * extended(j), &discounted(&equations.gram, mounting_sigma));
    }
    information.matrix = matrix;
    Ok(information)
}

/// The bound on each sensor by itself from its own projected ranges: the least `sum_n E ||s_hat_n - s_n||^2` against the
/// nominal places, `sum_n tr(R_n^-1 + sigma_e^2 I)`, m^2, and the covariance of the mean of the positions; `None` where the
/// ranges of some sensor do not show it.
///
/// # Errors
/// Those of [`perturbed_information`].
pub fn sensor_information_traces<const D: usize>(
    model: &RangeModel<D>,
    pose: &Pose<D>,
    measured: &Ranges,
    mounting_sigma: f64,
) -> Result<Option<(f64, SMatrix<f64, D, D>)>> {
    let equations = equations_at(model, pose, measured, RangeForm::Projected)?;
    let mut sum = SMatrix::<f64, D, D>::zeros();
    for each in &equations {
        let Ok(inverse) = spd_inverse(&each.gram) else { return Ok(None) };
        sum += inverse + SMatrix::<f64, D, D>::identity() * (mounting_sigma * mounting_sigma);
    }
    let count = equations.len() as f64;
    Ok(Some((sum.trace(), sum / (count * count))))
}

fn equations_at<const D: usize>(
    model: &RangeModel<D>,
    pose: &Pose<D>,
    measured: &Ranges,
    form: RangeForm,
) -> Result<Vec<SensorEquations<D>>> {
    let exact = model.exact_ranges(&Theta::from(*pose))?;
    let places: Vec<SVector<f64, D>> = model.topology().sensors().iter().map(|c| pose.act(c)).collect();
    let mut equations = Vec::with_capacity(places.len());
    model.sensor_equations(measured, &exact, form, |n| places[n], &mut equations)?;
    Ok(equations)
}

/// `R (sigma^2 R + I)^-1`, exactly symmetric; defined for singular `R` too.
fn discounted<const D: usize>(gram: &SMatrix<f64, D, D>, sigma: f64) -> SMatrix<f64, D, D> {
    let shifted = gram * (sigma * sigma) + SMatrix::<f64, D, D>::identity();
    let product = spd_inverse(&shifted).map_or(*gram, |inverse| inverse * gram);
    (product + product.transpose()) * 0.5
}
