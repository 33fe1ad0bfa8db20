//! The figures of relative kinematics. At the few trials of these tests some claims stay open that are decided at full size.

use super::claims_come_out_over;

pub const FAIL: [&str; 11] = [
    "RMSE(B1) of Algorithm 2 over that of Algorithm 1, worst",
    "RMSE(B0) of Algorithm 1 over the CRB from distances",
    "RMSE(B1) of Algorithm 1 over the CRB from distances",
    "RMSE(B2) of Algorithm 1 over the CRB from distances",
    "RMSE(B0) of Algorithm 2 over the CRB with accelerations",
    "RMSE(B1) of Algorithm 2 over the CRB with accelerations",
    "RMSE(B2) of Algorithm 2 over the CRB with accelerations",
    "RMSE of Algorithm 1 at t = -5 s, the noise a thousandth",
    "RMSE of Algorithm 1 at t = 5 s, the noise a thousandth",
    "RMSE of Algorithm 2 at t = -5 s, the noise a thousandth",
    "RMSE of Algorithm 2 at t = 5 s, the noise a thousandth",
];
pub const OPEN: [&str; 7] = [
    "RMSE(Y0) of Snapshot synchronization over",
    "RMSE(Y0) of ML, distances over the CRB",
    "RMSE(Y1) of ML, distances over the CRB",
    "RMSE(Y2) of ML, distances over the CRB",
    "RMSE(Y1) of ML, distances and accelerations over the CRB",
    "aligned at t = -5 s: RMSE of Algorithm 2, O(D)",
    "aligned at t = 5 s: RMSE of Algorithm 2, O(D)",
];

const TRIALS: usize = 200;

#[test]
fn figure_1() {
    claims_come_out_over(
        TRIALS,
        &[(
            "kinematics-1",
            35,
            &[("algorithm-1-rank1", "range-polynomial", 10), ("algorithm-1-rank1", "algorithm-2-rank1", 2)],
        )],
    );
}

#[test]
fn figure_2a() {
    let spoils = [
        ("algorithm-1-rank1", "algorithm-2-rank1", 3),
        ("maximum-likelihood", "algorithm-2-rank1", 5),
        ("algorithm-2-rank1", "algorithm-2-so", 1),
    ];
    claims_come_out_over(TRIALS, &[("kinematics-2a", 28, &spoils)]);
}

#[test]
fn figure_2b() {
    let spoils = [
        ("algorithm-1-rank1", "algorithm-2-rank1", 1),
        ("maximum-likelihood", "algorithm-1-rank1", 2),
        ("algorithm-2-so", "algorithm-1-rank1", 2),
    ];
    claims_come_out_over(TRIALS, &[("kinematics-2b", 15, &spoils)]);
}
