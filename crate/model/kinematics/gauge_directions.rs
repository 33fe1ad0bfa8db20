//! Small motions of the whole network, which no distance shows, in coordinates.
//!
//! The unknowns are coefficients stacked as they lie in memory: coefficient by coefficient, node by node, coordinate by
//! coordinate.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector, SVector};

use crate::math::rotation::{MAX_ANGLES, hat, rotation_angles};

/// For each plane of rotation `E_i` the field `E_i y` at all stacked vectors `y`.
///
/// ```
/// use rangelab::model::kinematics::gauge_directions::turn_fields;
/// assert_eq!(turn_fields::<2>(&[1.0, 0.0, 3.0, 4.0])[0].as_slice(), [0.0, 1.0, -4.0, 3.0]);
/// ```
pub fn turn_fields<const D: usize>(stacked: &[f64]) -> Vec<DVector<f64>> {
    let field = |plane: usize| {
        let mut unit = [0.0; MAX_ANGLES];
        unit[plane] = 1.0;
        let skew = hat::<D>(&unit);
        let turned = |y: &[f64]| skew * SVector::<f64, D>::from_column_slice(y);
        DVector::from_iterator(
            stacked.len(),
            stacked.chunks_exact(D).flat_map(|y| turned(y).as_slice().to_vec()),
        )
    };
    (0..rotation_angles(D)).map(field).collect()
}

/// Information about the translations of each coefficient, as much as about the others on average, so that the matrix can
/// be inverted; what is left unknown in this way is the mean, which centring removes.
pub fn add_translations(information: &mut DMatrix<f64>, dimension: usize, nodes: usize) {
    let block = dimension * nodes;
    for first in (0..information.nrows()).step_by(block) {
        let mean = (first..first + block).map(|i| information[(i, i)]).sum::<f64>() / block as f64;
        let weight = mean / nodes as f64;
        for column in 0..block {
            for row in (column % dimension..block).step_by(dimension) {
                information[(first + row, first + column)] += weight;
            }
        }
    }
}

/// The same for turns, given by [`turn_fields`].
pub fn add_turns(information: &mut DMatrix<f64>, fields: &[DVector<f64>]) {
    let mean = information.trace() / information.nrows() as f64;
    for field in fields {
        let squared = field.norm_squared();
        if squared > 0.0 {
            information.ger(mean / squared, field, field, 1.0);
        }
    }
}
