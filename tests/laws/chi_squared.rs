//! Chi-square intervals against figures that mpmath 1.3 gives with 40 digits (bisection of `gammainc`).
#![allow(clippy::unreadable_literal, clippy::excessive_precision, reason = "figures as they were printed")]

use rangelab::math::chi_squared::chi_squared_interval;

use crate::support::{at_most, caught};

/// Degrees of freedom, probability, both ends of the central interval.
const FIGURES: [(f64, f64, [f64; 2]); 32] = [
    (1.0, 0.5, [0.1015310442676215, 1.323303696931466]),
    (1.0, 0.95, [0.0009820691171752577, 5.023886187314887]),
    (1.0, 0.999, [3.926991331029232e-7, 12.11566514639717]),
    (1.0, 0.999999999, [3.926990594861474e-19, 38.67726175809113]),
    (2.0, 0.5, [0.5753641449035619, 2.772588722239781]),
    (2.0, 0.95, [0.0506356159685798, 7.377758908227871]),
    (2.0, 0.999, [0.001000250083364597, 15.20180491908416]),
    (2.0, 0.999999999, [9.999999719680685e-10, 42.83282609157658]),
    (3.0, 0.5, [1.212532903045669, 4.108344935632317]),
    (3.0, 0.95, [0.215795282623898, 9.348403604496146]),
    (3.0, 0.999, [0.01527896724324296, 17.72999622894593]),
    (3.0, 0.999999999, [1.523237381675167e-6, 46.25737864589694]),
    (6.0, 0.5, [3.454598835721039, 7.84080412058512]),
    (6.0, 0.95, [1.237344245791203, 14.44937533544792]),
    (6.0, 0.999, [0.2994076998463289, 24.10279899498349]),
    (6.0, 0.999999999, [0.002885539680617311, 54.83718070576838]),
    (12.0, 0.5, [8.438418766135793, 14.84540367104018]),
    (12.0, 0.95, [4.403788506981703, 23.33666415864534]),
    (12.0, 0.999, [1.934376738014023, 34.82127463647435]),
    (12.0, 0.999999999, [0.1707549687621298, 68.96500878581104]),
    (30.0, 0.5, [24.47760766488626, 34.79974251914093]),
    (30.0, 0.95, [16.79077226556663, 46.97924224367115]),
    (30.0, 0.999, [10.80436467244, 62.16185286918065]),
    (30.0, 0.999999999, [3.428492572116958, 103.5853652611038]),
    (57.0, 0.5, [49.4821242000799, 63.79326149206507]),
    (57.0, 0.95, [38.02674095621744, 79.75219228029037]),
    (57.0, 0.999, [28.24777633492203, 98.78384154798484]),
    (57.0, 0.999999999, [13.63789323548609, 148.0370087706138]),
    (100.0, 0.5, [90.13321974633931, 109.1412410700806]),
    (100.0, 0.95, [74.22192747492373, 129.5611971858366]),
    (100.0, 0.999, [59.89565798656429, 153.1669550816672]),
    (100.0, 0.999999999, [36.12525708057322, 211.8733339042806]),
];

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn intervals_have_all_their_digits_also_far_out() {
    for (freedom, probability, expected) in FIGURES {
        let found = chi_squared_interval(freedom, probability).unwrap();
        for (found, expected) in found.into_iter().zip(expected) {
            let error = (found - expected).abs() / expected;
            at_most(&format!("chi^2 of {freedom} at {probability}: {found}"), error, 1e-13);
        }
        // One degree of freedom more is another interval.
        let [other, _] = chi_squared_interval(freedom + 1.0, probability).unwrap();
        caught("another distribution", (other - expected[0]).abs() / expected[0], 1e-3);
    }
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn intervals_of_many_trials_are_nearly_normal() {
    // Cornish-Fisher: n + z sqrt(2 n) + 2/3 (z^2 - 1) + (z^3 - 7 z)/(9 sqrt(2 n)), with the normal quantile z of 0.975.
    let z: f64 = 1.959963984540054;
    for freedom in [1e3_f64, 1e5, 1e7, 1e9] {
        let [low, high] = chi_squared_interval(freedom, 0.95).unwrap();
        let spread = (2.0 * freedom).sqrt();
        for (found, z) in [(low, -z), (high, z)] {
            let series =
                freedom + z * spread + (z * z - 1.0) * 2.0 / 3.0 + (z * z * z - 7.0 * z) / (9.0 * spread);
            at_most(&format!("chi^2 of {freedom}: {found}"), (found - series).abs() / spread, 1e-5);
        }
    }
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn what_is_no_distribution_or_no_probability_is_refused() {
    for freedom in [0.0, 0.5, -3.0, f64::NAN, f64::INFINITY, 2e9] {
        assert!(chi_squared_interval(freedom, 0.95).is_err(), "{freedom}");
    }
    for probability in [0.0, 1.0, -0.1, 1.5, f64::NAN] {
        assert!(chi_squared_interval(6.0, probability).is_err(), "{probability}");
    }
    let sentence = chi_squared_interval(6.0, 95.0).unwrap_err().to_string();
    assert_eq!(sentence, "the probability of an interval is 95; it must be above 0 and below 1");
    // The widest and the narrowest interval there are.
    for probability in [1e-300, 1.0 - f64::EPSILON / 2.0] {
        let [low, high] = chi_squared_interval(1.0, probability).unwrap();
        assert!(0.0 < low && low <= high && high < 100.0, "{low} to {high}");
    }
}
