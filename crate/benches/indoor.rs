//! Time of one run of 100 steps of all inertial filters, natively and in WebAssembly, in one run.
//!
//! `cargo bench --bench indoor`; the WebAssembly column appears as in the bench `track`.
#![allow(clippy::disallowed_methods, reason = "a bench needs a clock")]

mod indoor_case;

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use indoor_case::IndoorCase;
use rangelab::model::indoor::filter_settings::FilterName;

const PASSES: usize = 300;

fn main() {
    let case = IndoorCase::new();
    for name in FilterName::ALL {
        println!("{:<24} {:>8.3} ms", name.label(), native(&case, &[name]));
    }
    let all = native(&case, &FilterName::ALL);
    print!("{:<24} {all:>8.3} ms native (target 5)", "all, 100 steps");
    match wasm() {
        Some([ms, sum]) => {
            println!(", {ms:.3} ms in WebAssembly (target 5), ratio {:.2}", ms / all);
            assert_eq!(sum.to_bits(), case.run(&FilterName::ALL).to_bits(), "the same bits");
        }
        None => println!("; no WebAssembly: compile the example track_wasm first (see the bench `track`)"),
    }
}

/// Milliseconds: the fastest of some passes, the one that a busy machine disturbed least.
fn native(case: &IndoorCase, filters: &[FilterName]) -> f64 {
    let time = |_| {
        let start = Instant::now();
        std::hint::black_box(case.run(filters));
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..PASSES).map(time).fold(f64::INFINITY, f64::min)
}

/// The time, and the sum of what was computed.
fn wasm() -> Option<[f64; 2]> {
    let target = std::env::current_exe().ok()?.ancestors().nth(3)?.to_path_buf();
    let module = target.join("wasm32-unknown-unknown/wasm/examples/track_wasm.wasm");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("crate/benches/indoor.mjs");
    let output = Command::new("node").arg(script).arg(module).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let numbers: Vec<f64> = text.lines().filter_map(|line| line.parse().ok()).collect();
    numbers.try_into().ok()
}
