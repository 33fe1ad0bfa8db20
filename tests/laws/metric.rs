//! The metric `P_q^-1` of the constrained filter, and the gain `P_tq P_q^-1` that moves the position along.

use rangelab::math::block::BlockMatrix;

use super::positive_definite::blocks;
use crate::support::sampling::Sampler;
use crate::support::{at_most, caught, dense};

crate::in_plane_and_space!(the_metric_is_the_inverse_of_the_orientation_block);

fn the_metric_is_the_inverse_of_the_orientation_block<const D: usize>() {
    let mut sampler = Sampler::new(40);
    for _ in 0..200 {
        let covariance: BlockMatrix<D> = blocks(&mut sampler, |_| 1.0);
        let full = dense::matrix(&covariance);
        let split = D * D;
        let expected = full.view((0, 0), (split, split)).into_owned().cholesky().unwrap().inverse();
        let gain = full.view((split, 0), (D, split)) * &expected;
        let found = covariance.orientation_metric().unwrap();
        let metric = dense::matrix(&found.metric).view((0, 0), (split, split)).into_owned();
        at_most("P_q^-1", dense::difference(&metric, &expected), 1e-10);
        let moves = nalgebra::DMatrix::from_fn(D, split, |i, j| found.position_gain[j / D][(i, j % D)]);
        at_most("P_tq P_q^-1", dense::difference(&moves, &gain), 1e-10);
        let conditional = full.clone().cholesky().unwrap().inverse();
        let wrong = conditional.view((0, 0), (split, split)).into_owned();
        caught("the block of the inverse instead", dense::difference(&wrong, &expected), 1e-3);
    }
    assert!(BlockMatrix::<D>::zeros().orientation_metric().is_err());
}
