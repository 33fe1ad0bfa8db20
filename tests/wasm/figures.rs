//! The module of the papers' figures, in a browser: the same bits as the native library, errors as sentences.
#![cfg(target_arch = "wasm32")]

#[path = "../golden/fingerprint.rs"]
mod fingerprint;

use fingerprint::figure_fingerprints;
use rangelab_figures::{FigureSum, figure_block, figure_jobs, figure_seed, figures};
use serde_json::Value;
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

fn blocks(name: &str, trials: usize, seed: f64) -> Vec<Vec<f64>> {
    let jobs = figure_jobs(name, trials, seed).ok().unwrap();
    (0..jobs).map(|job| figure_block(name, trials, seed, job).ok().unwrap()).collect()
}

fn sum(name: &str, trials: usize, seed: f64, blocks: &[Vec<f64>]) -> FigureSum {
    let mut sum = FigureSum::new(name, trials, seed).ok().unwrap();
    for block in blocks {
        sum.push(block).ok().unwrap();
    }
    sum
}

fn sentence<T>(result: Result<T, JsError>) -> String {
    let error = JsValue::from(result.err().expect("an error is thrown"));
    error.dyn_into::<js_sys::Error>().expect("it is an Error").message().into()
}

/// The blocks that workers give are those of the native library, bit by bit, and so is what the page joins of them.
#[wasm_bindgen_test]
fn figures_give_the_golden_bits() {
    let found = figure_fingerprints(
        |name, trials, seed| blocks(name, trials, seed as f64),
        |name, trials, seed, blocks| sum(name, trials, seed as f64, blocks).report().ok().unwrap(),
    );
    assert_eq!(found, include_str!("../golden/figures.txt"));
}

#[wasm_bindgen_test]
fn the_list_says_what_each_figure_is() {
    let list: Value = serde_json::from_str(&figures()).unwrap();
    let names: Vec<&str> =
        list.as_array().unwrap().iter().map(|each| each["name"].as_str().unwrap()).collect();
    assert_eq!(names[..3], ["tracking-2", "tracking-3", "localization-2"]);
    assert_eq!(list[0]["paper"], "tracking");
    assert_eq!(list[0]["trials"], 1000);
}

#[wasm_bindgen_test]
fn a_growing_figure_reads_as_a_report_and_as_a_table() {
    let blocks = blocks("tracking-3", 40, figure_seed());
    for joined in 0..=blocks.len() {
        let sum = sum("tracking-3", 40, figure_seed(), &blocks[..joined]);
        assert_eq!(sum.jobs(), joined);
        let report: Value = serde_json::from_str(&sum.report().ok().unwrap()).unwrap();
        assert_eq!(report["command"], "rangelab figure tracking-3 --trials 40 --seed 1");
        assert!(sum.csv().ok().unwrap().contains("# rangelab figure tracking-3 --trials 40 --seed 1\n"));
    }
}

#[wasm_bindgen_test]
fn what_cannot_be_is_refused_in_a_sentence() {
    assert!(sentence(figure_jobs("tracking-4", 40, 1.0)).contains("tracking-2, tracking-3"));
    assert!(sentence(figure_jobs("tracking-3", 0, 1.0)).contains("trials"));
    for seed in [-1.0, 0.5, 1e300, f64::NAN] {
        assert!(sentence(figure_jobs("tracking-3", 40, seed)).contains("seed"), "{seed}");
    }
    assert!(figure_block("tracking-3", 20, 1.0, 99).is_err());
    let mut sum = FigureSum::new("tracking-3", 40, 1.0).ok().unwrap();
    assert!(sum.push(&[1.0]).is_err());
    let other = figure_block("tracking-3", 40, 2.0, 0).ok().unwrap();
    assert!(sentence(sum.push(&other)).contains("seed"), "of another seed");
    assert_eq!(sum.jobs(), 0);
}
