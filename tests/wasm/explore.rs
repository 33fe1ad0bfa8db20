//! The module of the lab Explore, in a browser: the same bits as the native library.
#![cfg(target_arch = "wasm32")]

#[path = "../golden/fingerprint.rs"]
mod fingerprint;

use fingerprint::geometry_fingerprints;
use rangelab::model::presets::preset;
use rangelab_explore::{
    advise, best_next, explore, field_layout, field_parameters, field_probe, field_program, field_rows,
    improve, mounting_cloud, next_at, size_curve,
};
use serde_json::Value;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

#[wasm_bindgen_test]
fn fields_and_placements_give_the_golden_bits() {
    assert_eq!(geometry_fingerprints(), include_str!("../golden/geometry.txt"));
}

/// The rows that workers give are those of the crate, in the single precision that colours need.
#[wasm_bindgen_test]
fn the_facade_of_the_field_hands_through() {
    let scenario = preset("room").unwrap().to_json();
    let layout: Value = serde_json::from_str(&field_layout(&scenario, 20).ok().unwrap()).unwrap();
    let (width, height) = (layout["width"].as_u64().unwrap(), layout["height"].as_u64().unwrap());
    let (width, height) = (usize::try_from(width).unwrap(), usize::try_from(height).unwrap());
    let all = field_rows(&scenario, 20, 0, height).ok().unwrap();
    assert_eq!(all.len(), width * height);
    assert_eq!(field_rows(&scenario, 20, 3, 2).ok().unwrap(), all[3 * width..5 * width]);
    assert!(field_rows(&scenario, 0, 0, 1).is_err());
    let found: Value = serde_json::from_str(&explore(&scenario).ok().unwrap()).unwrap();
    let place: Vec<f64> = serde_json::from_value(found["pose"]["position"].clone()).unwrap();
    let probe: Value = serde_json::from_str(&field_probe(&scenario, &place).ok().unwrap()).unwrap();
    assert_eq!(probe["position_sigma"], found["position_sigma"]);
    assert!(field_probe(&scenario, &[1.0]).is_err());
    let curve = size_curve(&scenario, &[0.5, 1.0, 2.0]).ok().unwrap();
    assert_eq!(curve[1].to_bits(), found["angle_sigma"].as_f64().unwrap().to_bits());
    assert!(curve[0] > curve[1] && curve[1] > curve[2], "a larger body is a better compass: {curve:?}");
    assert!(size_curve(&scenario, &[0.0]).is_err());
    let mut mounted = preset("room").unwrap();
    mounted.mounting_sigma = 0.01;
    let native = rangelab::simulate::mounting::mounting_cloud::<3>(&mounted, 4).unwrap();
    let cloud = mounting_cloud(&mounted.to_json(), 4).ok().unwrap();
    assert_eq!(cloud, native.iter().flat_map(|place| place.iter().copied()).collect::<Vec<_>>());
    assert!(mounting_cloud(&scenario, u32::MAX).is_err());
    let advice: Value = serde_json::from_str(&advise(&scenario).ok().unwrap()).unwrap();
    let better: Value = serde_json::from_str(&improve(&scenario, 0).ok().unwrap()).unwrap();
    assert_eq!(advice["value"], better["before"]);
    let next: Value = serde_json::from_str(&best_next(&scenario).ok().unwrap()).unwrap();
    let there: Vec<f64> = serde_json::from_value(next["point"].clone()).unwrap();
    assert_eq!(next, serde_json::from_str::<Value>(&next_at(&scenario, &there).ok().unwrap()).unwrap());
    assert!(next["after"].as_f64() < next["before"].as_f64(), "one more anchor helps: {next}");
    assert!(next_at(&scenario, &[1.0]).is_err());
    assert!(field_program(&scenario).ok().unwrap().contains("fn main"));
    assert!(field_parameters(&scenario).ok().unwrap().iter().all(|x| x.is_finite()));
}
