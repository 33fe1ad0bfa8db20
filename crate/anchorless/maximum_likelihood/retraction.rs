//! Steps that turn the whole network turn it exactly.

use nalgebra::{DVector, SVector};

use crate::math::linalg::spd_inverse;
use crate::math::newton::{Angles3, Hessian};
use crate::math::rotation::{Rotation, rotation_angles};
use crate::model::kinematics::gauge_directions::turn_fields;

/// `exp(hat(phi)) (y + step - hat(phi) y)` for all stacked vectors `y`, `phi` being the common turn nearest to the step.
///
/// Distances are blind to a common turn and accelerations are not; a straight step along the turn would stretch the network,
/// which distances, far more exact, would forbid: the way along the circle would take hundreds of short steps.
pub fn retracted<const D: usize>(unknowns: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
    let fields = turn_fields::<D>(unknowns.as_slice());
    // Unused angles (D = 2) keep the identity and a slope of zero.
    let (mut gram, mut slope) = (Hessian::identity(), Angles3::zeros());
    for i in 0..rotation_angles(D) {
        slope[i] = fields[i].dot(step);
        for j in 0..rotation_angles(D) {
            gram[(i, j)] = fields[i].dot(&fields[j]);
        }
    }
    let mut moved = unknowns + step;
    // A network on a line has a turn that does not move it.
    let Ok(inverse) = spd_inverse(&gram) else { return moved };
    let phi: [f64; 3] = (inverse * slope).into();
    for (field, angle) in fields.iter().zip(phi) {
        moved.axpy(-angle, field, 1.0);
    }
    let turn = Rotation::<D>::exp(&phi);
    for y in moved.as_mut_slice().chunks_exact_mut(D) {
        let turned = turn.matrix() * SVector::<f64, D>::from_column_slice(y);
        y.copy_from_slice(turned.as_slice());
    }
    moved
}
